// SPDX-License-Identifier: MIT
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>What kind of place a point is on.</summary>
    public enum Feature : byte
    {
        Face = Raw.PLP_FEATURE_FACE,
        Edge = Raw.PLP_FEATURE_EDGE,
        Vertex = Raw.PLP_FEATURE_VERTEX
    }

    /// <summary>One local minimum distance (LMD), or one point of a plateau of equal ones.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Contact
    {
        /// <summary>On the first model, or on the scene.</summary>
        public Vector3d PointA;

        /// <summary>On the second model, or on the tool.</summary>
        public Vector3d PointB;

        /// <summary>Unit vector from PointA to PointB.</summary>
        public Vector3d Normal;

        public double Distance;

        /// <summary>Of this point in its set: the weights of one set sum to 1.</summary>
        public double Weight;

        /// <summary>Newtons, on the second model or on the tool, at PointB.</summary>
        public Vector3d Force;

        /// <summary>Body.Id in a scene; 0 from a query.</summary>
        public ulong BodyA;

        public ulong BodyB;

        /// <summary>Points of one plateau share it.</summary>
        public uint Set;

        public Feature FeatureA;
        public Feature FeatureB;

        /// <summary>Of TriangleA as it is searched: which vertex or edge; 0 for a face.</summary>
        public byte CornerA;

        public byte CornerB;

        /// <summary>A triangle that holds the feature, as numbered in the input.</summary>
        public uint TriangleA;

        public uint TriangleB;
    }

    /// <summary>Two triangles that touch or cross.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Overlap
    {
        public ulong BodyA;
        public ulong BodyB;
        public uint TriangleA;
        public uint TriangleB;
    }

    /// <summary>Work that a search did.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Work
    {
        public ulong Bodies;
        public ulong BodyPairs;
        public ulong NodePairs;
        public ulong TrianglePairs;
        public ulong Descents;
        public ulong DescentSteps;
        public ulong FrontEntries;
        public ulong FrontExpired;
        public ulong Age;
        public double GlobalUs;
        public ulong Rebuilds;
    }
}
