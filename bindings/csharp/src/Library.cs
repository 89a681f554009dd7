// SPDX-License-Identifier: MIT
namespace Palpate
{
    /// <summary>The native library that is loaded.</summary>
    public static unsafe class Library
    {
        /// <summary>Such as "0.1.0".</summary>
        public static string Version => Utf8.Text(Raw.plp_version_string());

        /// <summary>Stops the servos of all scenes. It may be called again and again, and happens by itself when the
        /// process exits; a host that unloads managed code without ending the process calls it before.</summary>
        public static void ShutDownAll() => PalpateException.Check(Raw.plp_shutdown_all());

        /// <summary>major × 1000000 + minor × 1000 + patch.</summary>
        public static uint VersionNumber => Raw.plp_version();
    }
}
