// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>What the safety limits let a device do.</summary>
    public enum Safety
    {
        /// <summary>No force: not armed, not calibrated, or the dead-man button let go.</summary>
        Disarmed = Raw.PLP_SAFETY_DISARMED,

        /// <summary>Force fades in.</summary>
        Ramping = Raw.PLP_SAFETY_RAMPING,

        Armed = Raw.PLP_SAFETY_ARMED,

        /// <summary>No force until its cause has been away for a while; then it fades in by itself.</summary>
        Fault = Raw.PLP_SAFETY_FAULT
    }

    /// <summary>What can change a wrench on its way to the motors.</summary>
    [Flags]
    public enum Limiters : uint
    {
        None = 0,

        /// <summary>Time stood still, as at a breakpoint: force fades in anew.</summary>
        LongTick = 1u << Raw.PLP_LIMITER_LONG_TICK,

        NonFiniteWrench = 1u << Raw.PLP_LIMITER_NON_FINITE_WRENCH,
        NonFinitePose = 1u << Raw.PLP_LIMITER_NON_FINITE_POSE,

        /// <summary>Faster than a hand.</summary>
        PoseJump = 1u << Raw.PLP_LIMITER_POSE_JUMP,

        StaleServo = 1u << Raw.PLP_LIMITER_STALE_SERVO,
        StalePose = 1u << Raw.PLP_LIMITER_STALE_POSE,
        ForceClamp = 1u << Raw.PLP_LIMITER_FORCE_CLAMP,
        TorqueClamp = 1u << Raw.PLP_LIMITER_TORQUE_CLAMP,
        ForceSlew = 1u << Raw.PLP_LIMITER_FORCE_SLEW,
        TorqueSlew = 1u << Raw.PLP_LIMITER_TORQUE_SLEW,
        Ramp = 1u << Raw.PLP_LIMITER_RAMP,

        /// <summary>The device reports a fault, its Condition.</summary>
        Device = 1u << Raw.PLP_LIMITER_DEVICE
    }

    /// <summary>A device after a tick, in its base frame: +x right, +y up, +z to the user, metres.</summary>
    public readonly unsafe struct DeviceState
    {
        private readonly Raw.plp_device_state state;

        internal DeviceState(Raw.plp_device_state state)
        {
            this.state = state;
            Pose = *(Pose*)&state.pose;
            LinearVelocity = *(Vector3d*)state.linear_velocity;
            AngularVelocity = *(Vector3d*)state.angular_velocity;
            Commanded = *(Wrench*)&state.commanded;
            Applied = *(Wrench*)&state.applied;
        }

        /// <summary>Of the handle.</summary>
        public Pose Pose { get; }

        /// <summary>m/s.</summary>
        public Vector3d LinearVelocity { get; }

        /// <summary>rad/s.</summary>
        public Vector3d AngularVelocity { get; }

        /// <summary>Asked for, about the handle.</summary>
        public Wrench Commanded { get; }

        /// <summary>Sent to the motors, about the handle.</summary>
        public Wrench Applied { get; }

        /// <summary>Bit i: button i is held.</summary>
        public uint Buttons => state.buttons;

        /// <summary>Seconds, of the sample, by the device's own clock.</summary>
        public double Time => state.time;

        /// <summary>Grows with every sample.</summary>
        public ulong Sequence => state.sequence;

        /// <summary>False: its pose is not to be trusted, and there is no force.</summary>
        public bool Calibrated => state.calibrated != 0;

        public Safety Safety => (Safety)state.safety;

        /// <summary>Of the fading in, 0 to 1.</summary>
        public double Gain => state.gain;

        /// <summary>That acted in the last tick.</summary>
        public Limiters Limiters => (Limiters)state.limiters;

        /// <summary>Part of Commanded was dropped, because there are no motors for it.</summary>
        public bool Unactuated => state.unactuated != 0;

        public ulong Ticks => state.ticks;

        public Condition Condition => (Condition)state.condition;

        /// <summary>Of the hottest motor: 0 cold, 1 too hot; 0 where none is measured.</summary>
        public double Temperature => state.temperature;

        /// <summary>Samples that were taken but never arrived, since it was opened.</summary>
        public ulong Lost => state.lost;

        /// <summary>Ticks in which a limiter has acted.</summary>
        public ulong TicksOf(Limiters limiter)
        {
            for (int i = 0; i <= Raw.PLP_LIMITER_DEVICE; ++i)
            {
                if ((uint)limiter == 1u << i)
                {
                    Raw.plp_device_state copy = state;
                    return copy.limiter_ticks[i];
                }
            }
            throw new ArgumentException("names no limiter, or several", nameof(limiter));
        }
    }
}
