// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>How an outcome is out of the ordinary.</summary>
    [Flags]
    public enum Status : uint
    {
        None = 0,

        /// <summary>SceneOptions.TickBudget ran out: the set may lack new LMDs.</summary>
        ByDescent = Raw.PLP_STATUS_BY_DESCENT,

        /// <summary>A servo found more than it had room for; it gets more.</summary>
        Cut = Raw.PLP_STATUS_CUT,

        /// <summary>A near body pushes nothing yet: it is being made ready for the servo.</summary>
        Waiting = Raw.PLP_STATUS_WAITING,

        /// <summary>Surfaces overlap and walls hold the tool.</summary>
        Wall = Raw.PLP_STATUS_WALL
    }

    /// <summary>Where the outcome of a scene or query is read to, again and again.</summary>
    internal sealed unsafe class Outcome
    {
        internal Raw.plp_contacts Struct;

        /// <summary>Grows whenever native memory that the struct points to may have been overwritten or freed.</summary>
        internal int Generation;

        internal Outcome()
        {
            fixed (Raw.plp_contacts* contacts = &Struct)
            {
                Raw.plp_contacts_init(contacts, (UIntPtr)sizeof(Raw.plp_contacts));
            }
        }
    }

    /// <summary>The outcome of one search: a view, valid until the next search of its scene or QueryResult or the end
    /// of that. From then on it throws InvalidOperationException.</summary>
    public readonly unsafe struct Contacts
    {
        private readonly Outcome outcome;
        private readonly int generation;

        internal Contacts(Outcome outcome)
        {
            this.outcome = outcome;
            generation = outcome.Generation;
        }

        /// <summary>The LMDs, a plateau's points one by one.</summary>
        public NativeList<Contact> Lmds => new NativeList<Contact>(
            outcome, Current.lmds, Current.lmd_count, Current.lmd_stride);

        /// <summary>All that pushes, each with its whole force: LMDs by Law.Springs, near minima by Law.Smooth, walls and
        /// springs that fade by both.</summary>
        public NativeList<Contact> Springs => new NativeList<Contact>(
            outcome, Current.springs, Current.spring_count, Current.lmd_stride);

        /// <summary>Pairs of triangles that touch or cross.</summary>
        public NativeList<Overlap> Overlaps => new NativeList<Overlap>(
            outcome, Current.overlaps, Current.overlap_count, Current.overlap_stride);

        /// <summary>Whether surfaces touch or cross.</summary>
        public bool Overlap => Current.overlap != 0;

        /// <summary>How the outcome is out of the ordinary.</summary>
        public Status Status => (Status)Current.status;

        /// <summary>Whether more pairs overlap than are listed.</summary>
        public bool OverlapsCut => Current.overlaps_cut != 0;

        /// <summary>The number of LMDs, a plateau counted once.</summary>
        public int SetCount => (int)Current.set_count;

        /// <summary>Of the LMDs; infinite if there is none.</summary>
        public double MinDistance => Current.min_distance;

        /// <summary>Microseconds.</summary>
        public double SearchUs => Current.search_us;

        public Wrench Wrench
        {
            get
            {
                fixed (Raw.plp_wrench* wrench = &Current.wrench)
                {
                    return *(Wrench*)wrench;
                }
            }
        }

        public Work Work
        {
            get
            {
                fixed (Raw.plp_work* work = &Current.work)
                {
                    return *(Work*)work;
                }
            }
        }

        private ref Raw.plp_contacts Current
        {
            get
            {
                if (outcome == null || generation != outcome.Generation)
                {
                    throw new InvalidOperationException(NativeList<Contact>.Overwritten);
                }
                return ref outcome.Struct;
            }
        }
    }
}
