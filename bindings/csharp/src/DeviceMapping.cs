// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>How a device's handle holds a scene's tool. Poses are in the scene's space, in which the axes of a device
    /// without a pose of its own point as Palpate's: its +y is the scene's up.</summary>
    public sealed unsafe class DeviceMapping
    {
        internal Raw.plp_device_mapping Struct;

        public DeviceMapping()
        {
            fixed (Raw.plp_device_mapping* mapping = &Struct)
            {
                Raw.plp_device_mapping_init(mapping, (UIntPtr)sizeof(Raw.plp_device_mapping));
            }
        }

        /// <summary>Where the device stands in the scene.</summary>
        public Pose SceneFromBase
        {
            get
            {
                fixed (Raw.plp_pose* pose = &Struct.scene_from_base)
                {
                    return *(Pose*)pose;
                }
            }
            set => Struct.scene_from_base = *(Raw.plp_pose*)&value;
        }

        /// <summary>How the tool's frame lies in the handle's.</summary>
        public Pose HandleFromTool
        {
            get
            {
                fixed (Raw.plp_pose* pose = &Struct.handle_from_tool)
                {
                    return *(Pose*)pose;
                }
            }
            set => Struct.handle_from_tool = *(Raw.plp_pose*)&value;
        }

        /// <summary>Metres of the scene for a metre of the handle; turns are kept.</summary>
        public double MotionScale
        {
            get => Struct.motion_scale;
            set => Struct.motion_scale = value;
        }

        /// <summary>Newtons on the hand for a newton on the tool.</summary>
        public double ForceScale
        {
            get => Struct.force_scale;
            set => Struct.force_scale = value;
        }

        /// <summary>Bits of buttons: while all are held the handle moves without the tool; 0: no clutch.</summary>
        public uint ClutchButtons
        {
            get => Struct.clutch_buttons;
            set => Struct.clutch_buttons = value;
        }

        /// <summary>For a device without motors for torque, which has it felt as force at the end of this lever: from a
        /// pivot to the handle, metres in the handle's frame, 0.001 to 1 long. Zero: torque is dropped.</summary>
        public Vector3d TorqueLever
        {
            get
            {
                fixed (double* lever = Struct.torque_lever)
                {
                    return *(Vector3d*)lever;
                }
            }
            set
            {
                fixed (double* lever = Struct.torque_lever)
                {
                    *(Vector3d*)lever = value;
                }
            }
        }

        /// <summary>Take the tool up where it is, rather than moving it into the hand.</summary>
        public bool KeepToolPose
        {
            get => (Struct.flags & Raw.PLP_DEVICE_KEEP_TOOL_POSE) != 0;
            set => Struct.flags = value ? Raw.PLP_DEVICE_KEEP_TOOL_POSE : 0u;
        }
    }
}
