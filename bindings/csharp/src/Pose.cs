// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>Three numbers in double precision.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Vector3d
    {
        public double X;
        public double Y;
        public double Z;

        public Vector3d(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public override string ToString() => $"({X}, {Y}, {Z})";
    }

    /// <summary>A rotation as a quaternion. It need not be normalised.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Quaterniond
    {
        public double X;
        public double Y;
        public double Z;
        public double W;

        public Quaterniond(double x, double y, double z, double w)
        {
            X = x;
            Y = y;
            Z = z;
            W = w;
        }

        public static Quaterniond Identity => new Quaterniond(0, 0, 0, 1);

        public override string ToString() => $"({X}, {Y}, {Z}, {W})";
    }

    /// <summary>x ↦ rotate(Orientation, x) + Position.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Pose
    {
        public Vector3d Position;
        public Quaterniond Orientation;

        public Pose(Vector3d position, Quaterniond orientation)
        {
            Position = position;
            Orientation = orientation;
        }

        /// <summary>Not turned.</summary>
        public Pose(double x, double y, double z) : this(new Vector3d(x, y, z), Quaterniond.Identity)
        {
        }

        public static Pose Identity => new Pose(0, 0, 0);

        public override string ToString() => $"{Position} {Orientation}";
    }

    /// <summary>A force in newtons and a torque in newton-metres.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Wrench
    {
        public Vector3d Force;
        public Vector3d Torque;

        public override string ToString() => $"{Force} N {Torque} N·m";
    }
}
