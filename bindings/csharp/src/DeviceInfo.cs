// SPDX-License-Identifier: MIT
namespace Palpate
{
    /// <summary>What a device, or the way to it, says of itself. All but the first two give no force.</summary>
    public enum Condition
    {
        Ready = Raw.PLP_CONDITION_READY,

        /// <summary>Its pose is not to be trusted yet, and there is no force.</summary>
        NeedsCalibration = Raw.PLP_CONDITION_NEEDS_CALIBRATION,

        /// <summary>Until they have cooled down.</summary>
        WarmMotors = Raw.PLP_CONDITION_WARM_MOTORS,

        /// <summary>Told to push harder than it can, it has let go for a while.</summary>
        ExceededForce = Raw.PLP_CONDITION_EXCEEDED_FORCE,

        /// <summary>Moved faster than it follows, it has let go for a while.</summary>
        ExceededVelocity = Raw.PLP_CONDITION_EXCEEDED_VELOCITY,

        /// <summary>It does not answer; once it does, it is taken up again.</summary>
        Lost = Raw.PLP_CONDITION_LOST,

        /// <summary>Its driver reports another error.</summary>
        Failed = Raw.PLP_CONDITION_FAILED,

        /// <summary>Listed only, as the next three: what reaches it is not installed.</summary>
        NoLibrary = Raw.PLP_CONDITION_NO_LIBRARY,

        /// <summary>What is installed lacks a part.</summary>
        WrongLibrary = Raw.PLP_CONDITION_WRONG_LIBRARY,

        CannotOpen = Raw.PLP_CONDITION_CANNOT_OPEN,

        /// <summary>Another way to it is the right one, or the system does not permit this one.</summary>
        Withheld = Raw.PLP_CONDITION_WITHHELD
    }

    /// <summary>What a haptic device is and can do. What it cannot actuate has limits of zero.</summary>
    public sealed unsafe class DeviceInfo
    {
        internal DeviceInfo(Raw.plp_device_info info)
        {
            Uri = Utf8.Text(info.uri);
            Name = Utf8.Text(info.name);
            Serial = Utf8.Text(info.serial);
            Buttons = (int)info.buttons;
            Sensed = info.sensed;
            Actuated = info.actuated;
            MaxForce = info.max_force;
            ContinuousForce = info.continuous_force;
            MaxTorque = info.max_torque;
            ContinuousTorque = info.continuous_torque;
            MaxStiffness = info.max_stiffness;
            MaxDamping = info.max_damping;
            PositionResolution = info.position_resolution;
            AngleResolution = info.angle_resolution;
            UpdateRate = info.update_rate;
            WorkspaceMin = *(Vector3d*)info.workspace_min;
            WorkspaceMax = *(Vector3d*)info.workspace_max;
            Condition = (Condition)info.condition;
            Status = Utf8.Text(info.status);
        }

        /// <summary>What Device.Open takes.</summary>
        public string Uri { get; }

        /// <summary>For people.</summary>
        public string Name { get; }

        /// <summary>Empty if it has none.</summary>
        public string Serial { get; }

        public int Buttons { get; }

        /// <summary>Bits 0 to 2: translation along x, y, z; bits 3 to 5: rotation about them.</summary>
        public uint Sensed { get; }

        /// <summary>The same for forces and torques.</summary>
        public uint Actuated { get; }

        /// <summary>Newtons, for short.</summary>
        public double MaxForce { get; }

        /// <summary>Newtons, for ever.</summary>
        public double ContinuousForce { get; }

        /// <summary>Newton-metres, for short.</summary>
        public double MaxTorque { get; }

        /// <summary>Newton-metres, for ever.</summary>
        public double ContinuousTorque { get; }

        /// <summary>N/m that the hand may feel.</summary>
        public double MaxStiffness { get; }

        /// <summary>N·s/m.</summary>
        public double MaxDamping { get; }

        /// <summary>Metres at the handle.</summary>
        public double PositionResolution { get; }

        /// <summary>Radians.</summary>
        public double AngleResolution { get; }

        /// <summary>Hertz.</summary>
        public double UpdateRate { get; }

        /// <summary>Metres, base frame.</summary>
        public Vector3d WorkspaceMin { get; }

        public Vector3d WorkspaceMax { get; }

        public Condition Condition { get; }

        /// <summary>What its user can do about its condition.</summary>
        public string Status { get; }

        public override string ToString() => $"{Uri}: {Name}";
    }
}
