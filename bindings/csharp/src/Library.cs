// SPDX-License-Identifier: MIT
namespace Palpate
{
    /// <summary>The native library that is loaded.</summary>
    public static unsafe class Library
    {
        /// <summary>Such as "0.1.0".</summary>
        public static string Version => Utf8.Text(Raw.plp_version_string());

        /// <summary>major × 1000000 + minor × 1000 + patch.</summary>
        public static uint VersionNumber => Raw.plp_version();
    }
}
