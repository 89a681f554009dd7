// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>How a simulated hand holds the handle.</summary>
    public enum Grip
    {
        /// <summary>Nobody holds it.</summary>
        Released = Raw.PLP_GRIP_RELEASED,

        /// <summary>Fingers on a stylus: 200 N/m.</summary>
        Light = Raw.PLP_GRIP_LIGHT,

        /// <summary>1,000 N/m.</summary>
        Firm = Raw.PLP_GRIP_FIRM,

        /// <summary>The numbers of Hand.</summary>
        Own = Raw.PLP_GRIP_OWN
    }

    /// <summary>What a simulated hand does.</summary>
    public enum HandScript
    {
        /// <summary>Stays at the origin.</summary>
        Hold = Raw.PLP_HAND_HOLD,

        /// <summary>In by the depth and out again, for ever.</summary>
        Tap = Raw.PLP_HAND_TAP,

        /// <summary>In by the depth, and stays there.</summary>
        Press = Raw.PLP_HAND_PRESS,

        /// <summary>Presses, then to and fro along the travel.</summary>
        Slide = Raw.PLP_HAND_SLIDE,

        /// <summary>Presses in by the depth while it sways to both sides.</summary>
        Wedge = Raw.PLP_HAND_WEDGE,

        /// <summary>Around the origin, without depth.</summary>
        Circle = Raw.PLP_HAND_CIRCLE
    }

    /// <summary>A simulated hand: metres, seconds, radians, the device's base frame.</summary>
    public sealed unsafe class Hand
    {
        internal Raw.plp_hand_options Struct;

        public Hand()
        {
            fixed (Raw.plp_hand_options* options = &Struct)
            {
                Raw.plp_hand_options_init(options, (UIntPtr)sizeof(Raw.plp_hand_options));
            }
        }

        public Grip Grip
        {
            get => (Grip)Struct.grip;
            set => Struct.grip = (int)value;
        }

        public HandScript Script
        {
            get => (HandScript)Struct.script;
            set => Struct.script = (int)value;
        }

        /// <summary>Held: bit i for button i.</summary>
        public uint Buttons
        {
            get => Struct.buttons;
            set => Struct.buttons = value;
        }

        /// <summary>Of the motion, at its beginning.</summary>
        public Pose Origin
        {
            get
            {
                fixed (Raw.plp_pose* origin = &Struct.origin)
                {
                    return *(Pose*)origin;
                }
            }
            set => Struct.origin = *(Raw.plp_pose*)&value;
        }

        /// <summary>Direction into the surface; need not have unit length.</summary>
        public Vector3d Into
        {
            get
            {
                fixed (double* into = Struct.into)
                {
                    return *(Vector3d*)into;
                }
            }
            set
            {
                fixed (double* into = Struct.into)
                {
                    *(Vector3d*)into = value;
                }
            }
        }

        /// <summary>Direction across Into.</summary>
        public Vector3d Along
        {
            get
            {
                fixed (double* along = Struct.along)
                {
                    return *(Vector3d*)along;
                }
            }
            set
            {
                fixed (double* along = Struct.along)
                {
                    *(Vector3d*)along = value;
                }
            }
        }

        /// <summary>Metres along Into.</summary>
        public double Depth
        {
            get => Struct.depth;
            set => Struct.depth = value;
        }

        /// <summary>Metres along Along: stroke of a slide, half of a sway, radius of a circle.</summary>
        public double Travel
        {
            get => Struct.travel;
            set => Struct.travel = value;
        }

        /// <summary>Radians about Into, to both sides, with the same period.</summary>
        public double Twist
        {
            get => Struct.twist;
            set => Struct.twist = value;
        }

        /// <summary>Seconds of one tap, stroke, sway or turn, and of the first press.</summary>
        public double Period
        {
            get => Struct.period;
            set => Struct.period = value;
        }

        /// <summary>Grip.Own: kg.</summary>
        public double Mass
        {
            get => Struct.mass;
            set => Struct.mass = value;
        }

        /// <summary>Grip.Own: N·s/m.</summary>
        public double Damping
        {
            get => Struct.damping;
            set => Struct.damping = value;
        }

        /// <summary>Grip.Own: N/m.</summary>
        public double Stiffness
        {
            get => Struct.stiffness;
            set => Struct.stiffness = value;
        }

        /// <summary>Grip.Own: kg·m².</summary>
        public double Inertia
        {
            get => Struct.inertia;
            set => Struct.inertia = value;
        }

        /// <summary>Grip.Own: N·m·s/rad.</summary>
        public double AngularDamping
        {
            get => Struct.angular_damping;
            set => Struct.angular_damping = value;
        }

        /// <summary>Grip.Own: N·m/rad.</summary>
        public double AngularStiffness
        {
            get => Struct.angular_stiffness;
            set => Struct.angular_stiffness = value;
        }
    }
}
