// SPDX-License-Identifier: MIT

namespace Palpate
{
    /// <summary>How the recording of a scene goes.</summary>
    public readonly struct Recording
    {
        internal Recording(Raw.plp_recording recording)
        {
            Running = recording.running != 0;
            Ticks = (long)recording.ticks;
            Lost = (long)recording.lost;
            Bytes = (long)recording.bytes;
        }

        public bool Running { get; }

        /// <summary>Steps in the file or on their way to it.</summary>
        public long Ticks { get; }

        /// <summary>Steps that found no room, because the file is too slow for the servo.</summary>
        public long Lost { get; }

        /// <summary>Of the file.</summary>
        public long Bytes { get; }
    }
}
