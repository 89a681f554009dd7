// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>How the servo of a scene runs: a native thread that steps it, beside another that searches.</summary>
    public struct ServoOptions
    {
        /// <summary>Steps a second, 1 to 20000; 0 for 1000.</summary>
        public double Rate;

        /// <summary>Without real-time priority, even where the system allows it.</summary>
        public bool NotRealTime;

        /// <summary>Of SCHED_FIFO, 1 to 99; 0 for the library's choice. It counts only where the system allows it.</summary>
        public int Priority;

        /// <summary>The only processor that it runs on, counted from 1, where the system allows it; 0 for any.</summary>
        public int Processor;

        internal unsafe Raw.plp_servo_options Struct
        {
            get
            {
                Raw.plp_servo_options options;
                Raw.plp_servo_options_init(&options, (UIntPtr)sizeof(Raw.plp_servo_options));
                options.rate = Rate;
                options.priority = NotRealTime ? -1 : Priority;
                options.cpu = Processor - 1;
                return options;
            }
        }
    }

    /// <summary>Microseconds: percentiles, which may be an eighth too long, and the maximum.</summary>
    public readonly struct Latency
    {
        internal unsafe Latency(double* times)
        {
            P50 = times[0];
            P99 = times[1];
            P999 = times[2];
            Max = times[3];
        }

        public double P50 { get; }
        public double P99 { get; }
        public double P999 { get; }
        public double Max { get; }

        public override string ToString() => $"p50 {P50} µs, p99 {P99} µs, p99.9 {P999} µs, max {Max} µs";
    }

    /// <summary>How a servo runs or, if it was stopped, ran.</summary>
    public readonly struct ServoState
    {
        internal unsafe ServoState(Raw.plp_servo_state state)
        {
            Running = state.running != 0;
            Priority = state.priority;
            Processor = state.cpu + 1;
            WantedRate = state.wanted_rate;
            Rate = state.rate;
            Ticks = state.ticks;
            Missed = state.missed;
            Skipped = state.skipped;
            Work = new Latency(state.work_us);
            Lateness = new Latency(state.lateness_us);
            WaitingTicks = state.waiting_ticks;
            CutTicks = state.cut_ticks;
            Preparations = state.preparations;
            Searches = state.searches;
            ResultAge = state.result_age;
        }

        public bool Running { get; }

        /// <summary>Of SCHED_FIFO, as the system granted it; 0: none.</summary>
        public int Priority { get; }

        /// <summary>The only processor that it runs on, counted from 1, as granted; 0: any.</summary>
        public int Processor { get; }

        public double WantedRate { get; }

        /// <summary>Steps a second, measured over the last second or so.</summary>
        public double Rate { get; }

        public ulong Ticks { get; }

        /// <summary>Steps that ended after the next one's time.</summary>
        public ulong Missed { get; }

        /// <summary>Steps left out because their time had passed.</summary>
        public ulong Skipped { get; }

        /// <summary>Of a step.</summary>
        public Latency Work { get; }

        /// <summary>From a step's time to its begin.</summary>
        public Latency Lateness { get; }

        /// <summary>Steps in which a near body was still being made ready.</summary>
        public ulong WaitingTicks { get; }

        /// <summary>Steps in which more was found than there was room for.</summary>
        public ulong CutTicks { get; }

        /// <summary>Pairs of models made ready for the servo.</summary>
        public ulong Preparations { get; }

        /// <summary>Mode.Descent: searches from scratch beside the servo.</summary>
        public ulong Searches { get; }

        /// <summary>Mode.Descent: steps since the pose of the search that the newest LMDs come from.</summary>
        public ulong ResultAge { get; }
    }
}
