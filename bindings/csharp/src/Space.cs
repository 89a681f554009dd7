// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>The space of poses, points and wrenches. AxisX says along which Palpate axis the first axis points: ±1,
    /// ±2 or ±3 for ±x, ±y or ±z; each axis occurs once. Forces stay in newtons and torques in newton-metres.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Space
    {
        public int AxisX;
        public int AxisY;
        public int AxisZ;
        private readonly int reserved;
        public double MetresPerUnit;

        public Space(int axisX, int axisY, int axisZ, double metresPerUnit = 1)
        {
            AxisX = axisX;
            AxisY = axisY;
            AxisZ = axisZ;
            reserved = 0;
            MetresPerUnit = metresPerUnit;
        }

        /// <summary>Right-handed, +y up, metres: Palpate's own, glTF's, Godot's and that of OpenXR.</summary>
        public static Space Native => new Space(1, 2, 3);

        /// <summary>Unity with models as UnityGLTF and glTFast load them.</summary>
        public static Space UnityGltf => new Space(-1, 2, 3);

        /// <summary>Unity as OpenXR gives poses.</summary>
        public static Space UnityOpenXR => new Space(1, 2, -3);

        /// <summary>Blender and Panda3D.</summary>
        public static Space ZUp => new Space(1, -3, 2);

        /// <summary>Unreal: left-handed, +z up, centimetres.</summary>
        public static Space Unreal => new Space(3, -1, 2, 0.01);
    }
}
