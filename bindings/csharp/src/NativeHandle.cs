// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>Owns one native object. Its value is used without counting references: to the library a value is no
    /// address, and one that another thread has released meanwhile is an error code.</summary>
    internal abstract class NativeHandle : SafeHandle
    {
        protected NativeHandle(IntPtr value) : base(IntPtr.Zero, true)
        {
            SetHandle(value);
        }

        public override bool IsInvalid => handle == IntPtr.Zero;

        /// <summary>Who uses it keeps the owner alive until the call is over.</summary>
        internal IntPtr Value
        {
            get
            {
                if (IsClosed)
                {
                    throw new ObjectDisposedException(Name);
                }
                return handle;
            }
        }

        protected abstract string Name { get; }
    }

    internal sealed class ModelHandle : NativeHandle
    {
        internal ModelHandle(IntPtr value) : base(value)
        {
        }

        protected override string Name => nameof(Model);

        protected override bool ReleaseHandle() => Raw.plp_model_release(handle) >= 0;
    }

    internal sealed class QueryResultHandle : NativeHandle
    {
        internal QueryResultHandle(IntPtr value) : base(value)
        {
        }

        protected override string Name => nameof(QueryResult);

        protected override bool ReleaseHandle() => Raw.plp_query_result_release(handle) >= 0;
    }

    internal sealed class DeviceHandle : NativeHandle
    {
        internal DeviceHandle(IntPtr value) : base(value)
        {
        }

        protected override string Name => nameof(Device);

        protected override bool ReleaseHandle() => Raw.plp_device_release(handle) >= 0;
    }

    internal sealed class TraceHandle : NativeHandle
    {
        internal TraceHandle(IntPtr value) : base(value)
        {
        }

        protected override string Name => nameof(Trace);

        protected override bool ReleaseHandle() => Raw.plp_trace_release(handle) >= 0;
    }

    internal sealed class SceneHandle : NativeHandle
    {
        internal SceneHandle(IntPtr value) : base(value)
        {
        }

        protected override string Name => nameof(Scene);

        protected override bool ReleaseHandle() => Raw.plp_scene_release(handle) >= 0;
    }
}
