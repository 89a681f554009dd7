// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>A body that was added or placed anew.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct TraceMove
    {
        /// <summary>TraceBody.Id.</summary>
        public ulong Body;

        public Pose Pose;
    }

    /// <summary>One step of a trace: what was changed before it, the settings that it had, and its outcome. Its lists and
    /// Contacts are valid until the next step is read or the trace is disposed.</summary>
    public readonly unsafe struct TraceTick
    {
        private readonly Outcome outcome;
        private readonly int generation;
        private readonly void* moves;
        private readonly UIntPtr moveCount;
        private readonly UIntPtr moveStride;
        private readonly void* removed;
        private readonly UIntPtr removedCount;

        internal TraceTick(Outcome outcome, Raw.plp_trace_tick tick)
        {
            this.outcome = outcome;
            generation = outcome.Generation;
            moves = tick.moves;
            moveCount = tick.move_count;
            moveStride = tick.move_stride;
            removed = tick.removed;
            removedCount = tick.removed_count;
            Contacts = new Contacts(outcome);
            Step = (long)tick.step;
            Lost = (long)tick.lost;
            Time = tick.time;
            Clock = tick.clock;
            TimeStep = tick.time_step;
            Mode = (Mode)tick.mode;
            Law = (Law)tick.law;
            Cutoff = tick.cutoff;
            Stiffness = tick.stiffness;
            Damping = tick.damping;
            StiffnessCap = tick.stiffness_cap;
            Friction = tick.friction;
            Tool = tick.tool;
            ToolPose = *(Pose*)&tick.tool_pose;
            Wrench = *(Wrench*)&tick.wrench;
            MinDistance = tick.min_distance;
            SetCount = (int)tick.set_count;
            Overlap = tick.overlap != 0;
            OverlapCount = (long)tick.overlap_count;
            Status = (Status)tick.status;
            StepUs = tick.step_us;
        }

        /// <summary>Of its scene, from 1.</summary>
        public long Step { get; }

        /// <summary>Steps just before it that were not recorded.</summary>
        public long Lost { get; }

        /// <summary>Seconds of the scene since the first step of the trace.</summary>
        public double Time { get; }

        /// <summary>Seconds that had passed since the recording began.</summary>
        public double Clock { get; }

        /// <summary>Seconds since the step before.</summary>
        public double TimeStep { get; }

        public Mode Mode { get; }
        public Law Law { get; }

        /// <summary>Units of the space.</summary>
        public double Cutoff { get; }

        /// <summary>N/m.</summary>
        public double Stiffness { get; }

        /// <summary>N·s/m.</summary>
        public double Damping { get; }

        /// <summary>N/m.</summary>
        public double StiffnessCap { get; }

        /// <summary>Coulomb's coefficient.</summary>
        public double Friction { get; }

        /// <summary>TraceBody.Id; 0: none.</summary>
        public ulong Tool { get; }

        public Pose ToolPose { get; }

        public Wrench Wrench { get; }

        /// <summary>Of the LMDs; infinite if there is none.</summary>
        public double MinDistance { get; }

        /// <summary>The number of LMDs, a plateau counted once.</summary>
        public int SetCount { get; }

        /// <summary>Whether surfaces touch or cross.</summary>
        public bool Overlap { get; }

        public long OverlapCount { get; }

        /// <summary>How the outcome is out of the ordinary.</summary>
        public Status Status { get; }

        /// <summary>Microseconds: all that the step computed.</summary>
        public double StepUs { get; }

        /// <summary>The LMDs; springs and the list of overlaps are not recorded.</summary>
        public Contacts Contacts { get; }

        /// <summary>Bodies that were added or placed anew before the step, but for the tool.</summary>
        public NativeList<TraceMove> Moves => new NativeList<TraceMove>(Current, moves, moveCount, moveStride);

        /// <summary>TraceBody.Id of bodies that were removed before the step.</summary>
        public NativeList<ulong> Removed => new NativeList<ulong>(Current, removed, removedCount, (UIntPtr)sizeof(ulong));

        private Outcome Current
        {
            get
            {
                if (outcome == null || generation != outcome.Generation)
                {
                    throw new InvalidOperationException(NativeList<TraceMove>.Overwritten);
                }
                return outcome;
            }
        }
    }
}
