// SPDX-License-Identifier: MIT
using System;

namespace Palpate
{
    /// <summary>An error that the native library reports, with its own sentence about it.</summary>
    public class PalpateException : Exception
    {
        internal PalpateException(int code, string message) : base(message)
        {
            Code = code;
        }

        /// <summary>One of PLP_ERROR_*.</summary>
        public int Code { get; }

        /// <summary>Throws what a negative result of a function of Raw stands for.</summary>
        public static unsafe void Check(int result)
        {
            if (result >= 0)
            {
                return;
            }
            string message = Utf8.Text(Raw.plp_last_error());
            throw ExceptionOfCode.Make(result, message != "" ? message : Utf8.Text(Raw.plp_result_string(result)));
        }
    }
}
