// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>An array in native memory, viewed where it is and valid as long as the Contacts it comes from.</summary>
    public readonly unsafe ref struct NativeList<T> where T : struct
    {
        internal const string Overwritten = "This was overwritten by a later search or step, or its owner is gone.";

        private readonly Outcome outcome;
        private readonly int generation;
        private readonly byte* first;
        private readonly int stride;

        internal NativeList(Outcome outcome, void* first, UIntPtr count, UIntPtr stride)
        {
            this.outcome = outcome;
            generation = outcome.Generation;
            this.first = (byte*)first;
            Count = checked((int)count);
            this.stride = checked((int)stride);
        }

        public int Count { get; }

        public ref readonly T this[int index]
        {
            get
            {
                if ((uint)index >= (uint)Count)
                {
                    throw new ArgumentOutOfRangeException(nameof(index));
                }
                RequireCurrent();
                return ref MemoryMarshal.GetReference(new ReadOnlySpan<T>(first + (long)index * stride, 1));
            }
        }

        /// <summary>The same as one span, where the library packs its elements as tightly as this version does. The
        /// span checks nothing: it must not be read after the next search.</summary>
        public bool TryGetSpan(out ReadOnlySpan<T> span)
        {
            RequireCurrent();
            bool packed = Count < 2 || stride == MemoryMarshal.AsBytes(new ReadOnlySpan<T>(first, 1)).Length;
            span = packed ? new ReadOnlySpan<T>(first, Count) : default(ReadOnlySpan<T>);
            return packed;
        }

        /// <summary>Copies as many as there is room for and returns how many.</summary>
        public int CopyTo(Span<T> target)
        {
            int count = Math.Min(Count, target.Length);
            for (int i = 0; i < count; ++i)
            {
                target[i] = this[i];
            }
            return count;
        }

        public T[] ToArray()
        {
            var array = new T[Count];
            CopyTo(array);
            return array;
        }

        public Enumerator GetEnumerator() => new Enumerator(this);

        private void RequireCurrent()
        {
            if (outcome == null || generation != outcome.Generation)
            {
                throw new InvalidOperationException(Overwritten);
            }
        }

        public ref struct Enumerator
        {
            private readonly NativeList<T> list;
            private int index;

            internal Enumerator(NativeList<T> list)
            {
                this.list = list;
                index = -1;
            }

            public ref readonly T Current => ref list[index];

            public bool MoveNext() => ++index < list.Count;
        }
    }
}
