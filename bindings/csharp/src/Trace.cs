// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>The trace of a scene, which Scene.Record wrote, one that was cut off too. Steps are read from its file when
    /// they are asked for; one thread at a time may do so. All that it gives is in Space.</summary>
    public sealed unsafe class Trace : IDisposable
    {
        private readonly TraceHandle handle;
        private readonly Outcome outcome = new Outcome();
        private readonly Raw.plp_trace_info info;

        private Trace(IntPtr value)
        {
            handle = new TraceHandle(value);
            Raw.plp_trace_info told;
            Raw.plp_trace_info_init(&told, (UIntPtr)sizeof(Raw.plp_trace_info));
            Check(Raw.plp_trace_get_info(value, &told));
            info = told;
            Space = Options().Space;
        }

        public static Trace Open(string path)
        {
            IntPtr value;
            fixed (byte* name = Utf8.Bytes(path ?? throw new ArgumentNullException(nameof(path)), nameof(path)))
            {
                PalpateException.Check(Raw.plp_trace_open(name, &value));
            }
            return new Trace(value);
        }

        /// <summary>For functions of Raw that have no other form here; throws if the trace is disposed.</summary>
        public IntPtr Handle => handle.Value;

        /// <summary>Steps.</summary>
        public long Count => (long)info.ticks;

        /// <summary>Steps that were not recorded, because the file was too slow.</summary>
        public long Lost => (long)info.lost;

        /// <summary>False if it was cut off, as by a crash: the scene went on behind the last step.</summary>
        public bool Complete => info.complete != 0;

        /// <summary>Seconds of the scene from the first step to the last.</summary>
        public double Duration => info.duration;

        /// <summary>Of the scene.</summary>
        public Space Space { get; }

        /// <summary>To make a scene as the recorded one was when the recording began, without its bodies.</summary>
        public SceneOptions Options()
        {
            var options = new SceneOptions();
            fixed (Raw.plp_scene_options* how = &options.Struct)
            {
                Check(Raw.plp_trace_get_options(handle.Value, how));
            }
            return options;
        }

        /// <summary>All that there ever were, in the order in which they were added.</summary>
        public TraceBody[] Bodies()
        {
            var bodies = new TraceBody[checked((int)info.bodies)];
            for (int i = 0; i < bodies.Length; ++i)
            {
                Raw.plp_trace_body body;
                Raw.plp_trace_body_init(&body, (UIntPtr)sizeof(Raw.plp_trace_body));
                Check(Raw.plp_trace_get_body(handle.Value, (ulong)i, &body));
                bodies[i] = new TraceBody(body);
            }
            return bodies;
        }

        /// <summary>Reads a step. Allocates nothing.</summary>
        /// <param name="tick">From 0, below Count.</param>
        public TraceTick this[long tick]
        {
            get
            {
                if (tick < 0 || tick >= Count)
                {
                    throw new ArgumentOutOfRangeException(nameof(tick));
                }
                IntPtr trace = handle.Value;
                ++outcome.Generation;
                Raw.plp_trace_tick read;
                Raw.plp_trace_tick_init(&read, (UIntPtr)sizeof(Raw.plp_trace_tick));
                fixed (Raw.plp_contacts* contacts = &outcome.Struct)
                {
                    Check(Raw.plp_trace_read(trace, (ulong)tick, &read));
                    Check(Raw.plp_trace_get_contacts(trace, contacts));
                }
                return new TraceTick(outcome, read);
            }
        }

        /// <summary>Places a body of a scene where a recorded one was in that step, bit by bit, which the pose of a
        /// TraceTick may miss by its rounding.</summary>
        public void Place(long tick, TraceBody recorded, Body body)
        {
            if (tick < 0 || tick >= Count)
            {
                throw new ArgumentOutOfRangeException(nameof(tick));
            }
            ulong id = (recorded ?? throw new ArgumentNullException(nameof(recorded))).Id;
            body.Scene.Check(Raw.plp_trace_place(handle.Value, (ulong)tick, id, body.Scene.Handle, body.Id));
            GC.KeepAlive(this);
        }

        public void Dispose()
        {
            ++outcome.Generation;
            handle.Dispose();
        }

        private void Check(int result)
        {
            GC.KeepAlive(this);
            PalpateException.Check(result);
        }
    }
}
