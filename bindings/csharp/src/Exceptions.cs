// SPDX-License-Identifier: MIT
// Made from palpate.h by bindings/gen/generate.py; do not edit.
namespace Palpate
{
    /// <summary>PLP_ERROR_INVALID_ARGUMENT: null, NaN, out of range, a struct_size that no version has.</summary>
    public sealed class PalpateInvalidArgumentException : PalpateException
    {
        internal PalpateInvalidArgumentException(string message) : base(Raw.PLP_ERROR_INVALID_ARGUMENT, message)
        {
        }
    }

    /// <summary>PLP_ERROR_INVALID_HANDLE: null, released, or of another kind.</summary>
    public sealed class PalpateInvalidHandleException : PalpateException
    {
        internal PalpateInvalidHandleException(string message) : base(Raw.PLP_ERROR_INVALID_HANDLE, message)
        {
        }
    }

    /// <summary>PLP_ERROR_OUT_OF_MEMORY.</summary>
    public sealed class PalpateOutOfMemoryException : PalpateException
    {
        internal PalpateOutOfMemoryException(string message) : base(Raw.PLP_ERROR_OUT_OF_MEMORY, message)
        {
        }
    }

    /// <summary>PLP_ERROR_FILE_NOT_FOUND.</summary>
    public sealed class PalpateFileNotFoundException : PalpateException
    {
        internal PalpateFileNotFoundException(string message) : base(Raw.PLP_ERROR_FILE_NOT_FOUND, message)
        {
        }
    }

    /// <summary>PLP_ERROR_FILE_READ: the file exists but could not be read.</summary>
    public sealed class PalpateFileReadException : PalpateException
    {
        internal PalpateFileReadException(string message) : base(Raw.PLP_ERROR_FILE_READ, message)
        {
        }
    }

    /// <summary>PLP_ERROR_BAD_FORMAT: not what it should be, such as glTF or a trace, or breaks its own rules.</summary>
    public sealed class PalpateBadFormatException : PalpateException
    {
        internal PalpateBadFormatException(string message) : base(Raw.PLP_ERROR_BAD_FORMAT, message)
        {
        }
    }

    /// <summary>PLP_ERROR_UNSUPPORTED: glTF that requires an extension this library does not have.</summary>
    public sealed class PalpateUnsupportedException : PalpateException
    {
        internal PalpateUnsupportedException(string message) : base(Raw.PLP_ERROR_UNSUPPORTED, message)
        {
        }
    }

    /// <summary>PLP_ERROR_NO_TRIANGLES: nothing to touch: no triangle of positive area.</summary>
    public sealed class PalpateNoTrianglesException : PalpateException
    {
        internal PalpateNoTrianglesException(string message) : base(Raw.PLP_ERROR_NO_TRIANGLES, message)
        {
        }
    }

    /// <summary>PLP_ERROR_NON_FINITE: an infinite or NaN coordinate.</summary>
    public sealed class PalpateNonFiniteException : PalpateException
    {
        internal PalpateNonFiniteException(string message) : base(Raw.PLP_ERROR_NON_FINITE, message)
        {
        }
    }

    /// <summary>PLP_ERROR_LIMIT: larger than a limit that the options or this library set.</summary>
    public sealed class PalpateLimitException : PalpateException
    {
        internal PalpateLimitException(string message) : base(Raw.PLP_ERROR_LIMIT, message)
        {
        }
    }

    /// <summary>PLP_ERROR_UNSAFE_PATH: a glTF names a buffer outside its own folder.</summary>
    public sealed class PalpateUnsafePathException : PalpateException
    {
        internal PalpateUnsafePathException(string message) : base(Raw.PLP_ERROR_UNSAFE_PATH, message)
        {
        }
    }

    /// <summary>PLP_ERROR_WRONG_STATE: not while things are as they are: a servo steps the scene, or another scene has the device.</summary>
    public sealed class PalpateWrongStateException : PalpateException
    {
        internal PalpateWrongStateException(string message) : base(Raw.PLP_ERROR_WRONG_STATE, message)
        {
        }
    }

    /// <summary>PLP_ERROR_DEVICE: a device that cannot be opened.</summary>
    public sealed class PalpateDeviceException : PalpateException
    {
        internal PalpateDeviceException(string message) : base(Raw.PLP_ERROR_DEVICE, message)
        {
        }
    }

    /// <summary>PLP_ERROR_FILE_WRITE: a file that cannot be made or written.</summary>
    public sealed class PalpateFileWriteException : PalpateException
    {
        internal PalpateFileWriteException(string message) : base(Raw.PLP_ERROR_FILE_WRITE, message)
        {
        }
    }

    /// <summary>PLP_ERROR_INTERNAL: a defect of this library.</summary>
    public sealed class PalpateInternalException : PalpateException
    {
        internal PalpateInternalException(string message) : base(Raw.PLP_ERROR_INTERNAL, message)
        {
        }
    }

    internal static class ExceptionOfCode
    {
        internal static PalpateException Make(int code, string message)
        {
            switch (code)
            {
                case Raw.PLP_ERROR_INVALID_ARGUMENT: return new PalpateInvalidArgumentException(message);
                case Raw.PLP_ERROR_INVALID_HANDLE: return new PalpateInvalidHandleException(message);
                case Raw.PLP_ERROR_OUT_OF_MEMORY: return new PalpateOutOfMemoryException(message);
                case Raw.PLP_ERROR_FILE_NOT_FOUND: return new PalpateFileNotFoundException(message);
                case Raw.PLP_ERROR_FILE_READ: return new PalpateFileReadException(message);
                case Raw.PLP_ERROR_BAD_FORMAT: return new PalpateBadFormatException(message);
                case Raw.PLP_ERROR_UNSUPPORTED: return new PalpateUnsupportedException(message);
                case Raw.PLP_ERROR_NO_TRIANGLES: return new PalpateNoTrianglesException(message);
                case Raw.PLP_ERROR_NON_FINITE: return new PalpateNonFiniteException(message);
                case Raw.PLP_ERROR_LIMIT: return new PalpateLimitException(message);
                case Raw.PLP_ERROR_UNSAFE_PATH: return new PalpateUnsafePathException(message);
                case Raw.PLP_ERROR_WRONG_STATE: return new PalpateWrongStateException(message);
                case Raw.PLP_ERROR_DEVICE: return new PalpateDeviceException(message);
                case Raw.PLP_ERROR_FILE_WRITE: return new PalpateFileWriteException(message);
                case Raw.PLP_ERROR_INTERNAL: return new PalpateInternalException(message);
                default: return new PalpateException(code, message);
            }
        }
    }
}
