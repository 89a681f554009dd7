// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>Limits that are tighter than a device's own; a number that is 0 is the device's own.</summary>
    public sealed unsafe class SafetyLimits
    {
        internal Raw.plp_safety_limits Struct;

        public SafetyLimits()
        {
            fixed (Raw.plp_safety_limits* limits = &Struct)
            {
                Raw.plp_safety_limits_init(limits, (UIntPtr)sizeof(Raw.plp_safety_limits));
            }
        }

        /// <summary>Bits of buttons that must all be held for any force; 0: none.</summary>
        public uint DeadMan
        {
            get => Struct.dead_man;
            set => Struct.dead_man = value;
        }

        /// <summary>Newtons.</summary>
        public double MaxForce
        {
            get => Struct.max_force;
            set => Struct.max_force = value;
        }

        /// <summary>Newton-metres.</summary>
        public double MaxTorque
        {
            get => Struct.max_torque;
            set => Struct.max_torque = value;
        }

        /// <summary>N/s.</summary>
        public double ForceSlew
        {
            get => Struct.force_slew;
            set => Struct.force_slew = value;
        }

        /// <summary>N·m/s.</summary>
        public double TorqueSlew
        {
            get => Struct.torque_slew;
            set => Struct.torque_slew = value;
        }

        /// <summary>m/s: a faster pose jumps.</summary>
        public double MaxSpeed
        {
            get => Struct.max_speed;
            set => Struct.max_speed = value;
        }

        /// <summary>rad/s.</summary>
        public double MaxTurnRate
        {
            get => Struct.max_turn_rate;
            set => Struct.max_turn_rate = value;
        }

        /// <summary>Seconds without a new wrench, pose or tick.</summary>
        public double Watchdog
        {
            get => Struct.watchdog;
            set => Struct.watchdog = value;
        }

        /// <summary>Seconds in which force fades in; not shorter than the device's own.</summary>
        public double RampTime
        {
            get => Struct.ramp_time;
            set => Struct.ramp_time = value;
        }

        /// <summary>Seconds without a cause that end a fault; not shorter than the device's own.</summary>
        public double FaultHold
        {
            get => Struct.fault_hold;
            set => Struct.fault_hold = value;
        }
    }
}
