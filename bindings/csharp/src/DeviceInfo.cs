// SPDX-License-Identifier: MIT
namespace Palpate
{
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

        public override string ToString() => $"{Uri}: {Name}";
    }
}
