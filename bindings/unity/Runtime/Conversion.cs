// SPDX-License-Identifier: MIT
using UnityEngine;

namespace Palpate.Unity
{
    /// <summary>Which axis of a right-handed model was turned to bring it into Unity's left-handed world.</summary>
    public enum Handedness
    {
        /// <summary>x, as UnityGLTF and glTFast load models.</summary>
        FlipX,

        /// <summary>z, as the poses of OpenXR come.</summary>
        FlipZ
    }

    /// <summary>Between Unity's numbers and Palpate's. Only their width changes here: the library turns handedness and
    /// units at the border of its scene, and of the triangles it is given, which are told the space of Unity.</summary>
    public static class Conversion
    {
        public static Space SpaceOf(Handedness handedness, double metresPerUnit)
        {
            Space space = handedness == Handedness.FlipX ? Space.UnityGltf : Space.UnityOpenXR;
            space.MetresPerUnit = metresPerUnit;
            return space;
        }

        public static Vector3d ToPalpate(Vector3 vector) => new Vector3d(vector.x, vector.y, vector.z);

        public static Quaterniond ToPalpate(Quaternion rotation) =>
            new Quaterniond(rotation.x, rotation.y, rotation.z, rotation.w);

        public static Pose PoseOf(Transform transform) =>
            new Pose(ToPalpate(transform.position), ToPalpate(transform.rotation));

        public static Vector3 ToUnity(Vector3d vector) =>
            new Vector3((float)vector.X, (float)vector.Y, (float)vector.Z);

        public static Quaternion ToUnity(Quaterniond rotation) =>
            new Quaternion((float)rotation.X, (float)rotation.Y, (float)rotation.Z, (float)rotation.W);
    }
}
