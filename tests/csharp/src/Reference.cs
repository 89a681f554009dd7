using System;
using System.IO;
using NUnit.Framework;

namespace Palpate.Tests
{
    /// <summary>Reads what reference.c wrote.</summary>
    internal sealed class Reference : IDisposable
    {
        internal readonly double Distance;
        private readonly BinaryReader reader = new BinaryReader(File.OpenRead(Samples.ReferencePath));

        internal Reference()
        {
            Distance = Double();
        }

        internal double Cutoff => 0.05 * Distance;

        internal double Double() => reader.ReadDouble();

        internal int Count() => checked((int)reader.ReadUInt64());

        internal Vector3d Vector() => new Vector3d(Double(), Double(), Double());

        internal Pose Pose() => new Pose(Vector(), new Quaterniond(Double(), Double(), Double(), Double()));

        internal Wrench Wrench() => new Wrench { Force = Vector(), Torque = Vector() };

        /// <summary>To the ticks of the scenes.</summary>
        internal void SkipQueries()
        {
            for (int count = Count(); count > 0; --count)
            {
                Pose();
                int lmds = Count();
                reader.BaseStream.Seek(8 * (8 + 14 * lmds), SeekOrigin.Current);
            }
        }

        internal bool AtEnd => reader.BaseStream.Position == reader.BaseStream.Length;

        public void Dispose() => reader.Dispose();

        internal static bool Same(double a, double b) => BitConverter.DoubleToInt64Bits(a) == BitConverter.DoubleToInt64Bits(b);

        internal static bool Same(Vector3d a, Vector3d b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z);

        internal static bool Same(Wrench a, Wrench b) => Same(a.Force, b.Force) && Same(a.Torque, b.Torque);
    }
}
