// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Palpate
{
    /// <summary>How weighty a log message is.</summary>
    public enum LogLevel
    {
        Error = Raw.PLP_LOG_ERROR,
        Warning = Raw.PLP_LOG_WARNING,
        Info = Raw.PLP_LOG_INFO,
        Debug = Raw.PLP_LOG_DEBUG
    }

    /// <summary>By its name the ahead-of-time compilers of Mono and Unity know what native code calls.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class MonoPInvokeCallbackAttribute : Attribute
    {
        internal MonoPInvokeCallbackAttribute(Type type)
        {
        }
    }

    /// <summary>The receiver of log messages. The library calls it on threads that are inside one of its functions,
    /// never on a thread of its own.</summary>
    public static unsafe class Log
    {
        // Another thread may be inside the native callback while the receiver is exchanged, so that it must never be
        // collected: there is one, and it looks up who receives.
        private static readonly Raw.plp_log_callback Callback = Deliver;
        private static volatile Action<LogLevel, string> receiver;

        static Log()
        {
            // The library outlives the domain.
            AppDomain.CurrentDomain.DomainUnload += (sender, arguments) => SetReceiver(null);
            AppDomain.CurrentDomain.ProcessExit += (sender, arguments) => SetReceiver(null);
        }

        /// <summary>Installs the one receiver, or with null removes it. It must not call the library; what it throws is
        /// dropped.</summary>
        public static void SetReceiver(Action<LogLevel, string> value)
        {
            receiver = value;
            Raw.plp_set_log_callback(
                value == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(Callback), null);
        }

        [MonoPInvokeCallback(typeof(Raw.plp_log_callback))]
        private static void Deliver(int level, byte* message, void* user)
        {
            try
            {
                receiver?.Invoke((LogLevel)level, Utf8.Text(message));
            }
            catch (Exception)
            {
                // No exception may cross native frames.
            }
        }
    }
}
