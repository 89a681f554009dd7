// SPDX-License-Identifier: MIT
using System;
using System.Text;

namespace Palpate
{
    /// <summary>Texts as the native library has them.</summary>
    internal static unsafe class Utf8
    {
        /// <summary>Null for null.</summary>
        internal static string Text(byte* text)
        {
            if (text == null)
            {
                return null;
            }
            int length = 0;
            while (text[length] != 0)
            {
                ++length;
            }
            return Encoding.UTF8.GetString(text, length);
        }

        /// <summary>With the zero at its end; null for null.</summary>
        internal static byte[] Bytes(string text, string name)
        {
            if (text == null)
            {
                return null;
            }
            if (text.IndexOf('\0') >= 0)
            {
                throw new ArgumentException("holds a null character", name);
            }
            return Encoding.UTF8.GetBytes(text + "\0");
        }
    }
}
