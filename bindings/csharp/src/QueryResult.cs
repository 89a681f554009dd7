// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>How a query searches and pushes. Only the cutoff must be set.</summary>
    public sealed unsafe class QueryOptions
    {
        internal Raw.plp_query_options Struct;

        public QueryOptions()
        {
            fixed (Raw.plp_query_options* options = &Struct)
            {
                Raw.plp_query_options_init(options, (UIntPtr)sizeof(Raw.plp_query_options));
            }
        }

        /// <summary>Metres, positive: LMDs farther apart are not searched.</summary>
        public double Cutoff
        {
            get => Struct.cutoff;
            set => Struct.cutoff = value;
        }

        /// <summary>N/m, not negative: force = stiffness × (cutoff − distance) × weight.</summary>
        public double Stiffness
        {
            get => Struct.stiffness;
            set => Struct.stiffness = value;
        }

        /// <summary>Frame of B: torques are about it.</summary>
        public Vector3d ReferencePoint
        {
            get
            {
                fixed (double* point = Struct.reference_point)
                {
                    return *(Vector3d*)point;
                }
            }
            set
            {
                fixed (double* point = Struct.reference_point)
                {
                    *(Vector3d*)point = value;
                }
            }
        }

        /// <summary>List at most so many overlapping pairs.</summary>
        public uint MaxOverlaps
        {
            get => Struct.max_overlaps;
            set => Struct.max_overlaps = value;
        }
    }

    /// <summary>Room for contacts between two models at one pose; reuse one to avoid allocations. One thread at a time
    /// may use it.</summary>
    public sealed unsafe class QueryResult : IDisposable
    {
        private readonly QueryResultHandle handle;
        private readonly Outcome outcome = new Outcome();

        public QueryResult()
        {
            IntPtr value;
            PalpateException.Check(Raw.plp_query_result_create(&value));
            handle = new QueryResultHandle(value);
        }

        /// <summary>Finds every local minimum distance within the cutoff, and the wrench of their springs on B. Points,
        /// normals, forces and the torque are in A's frame.</summary>
        /// <param name="aFromB">B's frame in A's.</param>
        public Contacts Search(Model a, Model b, Pose aFromB, QueryOptions options)
        {
            if (options == null)
            {
                throw new ArgumentNullException(nameof(options));
            }
            IntPtr first = Model.ValueOf(a, nameof(a)), second = Model.ValueOf(b, nameof(b)), result = handle.Value;
            // A search that fails empties the room, too.
            ++outcome.Generation;
            fixed (Raw.plp_query_options* how = &options.Struct)
            fixed (Raw.plp_contacts* contacts = &outcome.Struct)
            {
                PalpateException.Check(Raw.plp_query(first, second, (Raw.plp_pose*)&aFromB, how, result));
                PalpateException.Check(Raw.plp_query_result_get(result, contacts));
            }
            GC.KeepAlive(a);
            GC.KeepAlive(b);
            GC.KeepAlive(this);
            return new Contacts(outcome);
        }

        public void Dispose()
        {
            ++outcome.Generation;
            handle.Dispose();
        }
    }
}
