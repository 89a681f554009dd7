"""One exception for each error code of the native library."""

from . import _raw


class PalpateError(Exception):
    """Base of all errors that the native library reports; `code` is its plp_result."""

    code = _raw.PLP_ERROR_INTERNAL


class InvalidArgument(PalpateError, ValueError):
    """NaN, out of range, or of a wrong shape."""

    code = _raw.PLP_ERROR_INVALID_ARGUMENT


class InvalidHandle(PalpateError):
    """Closed, removed, or overwritten by a later search."""

    code = _raw.PLP_ERROR_INVALID_HANDLE


class OutOfMemory(PalpateError, MemoryError):
    code = _raw.PLP_ERROR_OUT_OF_MEMORY


class FileNotFound(PalpateError, FileNotFoundError):
    code = _raw.PLP_ERROR_FILE_NOT_FOUND


class FileReadError(PalpateError, OSError):
    """The file exists but could not be read."""

    code = _raw.PLP_ERROR_FILE_READ


class BadFormat(PalpateError):
    """Not what it should be, such as glTF or a trace, or breaks its own rules."""

    code = _raw.PLP_ERROR_BAD_FORMAT


class Unsupported(PalpateError):
    """glTF that requires an extension the library does not have."""

    code = _raw.PLP_ERROR_UNSUPPORTED


class NoTriangles(PalpateError):
    """Nothing to touch: no triangle of positive area."""

    code = _raw.PLP_ERROR_NO_TRIANGLES


class NonFinite(PalpateError):
    """An infinite or NaN coordinate."""

    code = _raw.PLP_ERROR_NON_FINITE


class LimitExceeded(PalpateError):
    code = _raw.PLP_ERROR_LIMIT


class UnsafePath(PalpateError):
    """A glTF names a buffer outside its own folder."""

    code = _raw.PLP_ERROR_UNSAFE_PATH


class WrongState(PalpateError):
    """Not now, such as stepping a scene whose servo runs."""

    code = _raw.PLP_ERROR_WRONG_STATE


class DeviceError(PalpateError):
    """A device that cannot be opened."""

    code = _raw.PLP_ERROR_DEVICE


class FileWriteError(PalpateError, OSError):
    """A file that cannot be made or written."""

    code = _raw.PLP_ERROR_FILE_WRITE


class InternalError(PalpateError):
    """A defect of the library."""


EXCEPTIONS: dict[int, type[PalpateError]] = {
    exception.code: exception
    for exception in (InvalidArgument, InvalidHandle, OutOfMemory, FileNotFound, FileReadError, BadFormat, Unsupported,
                      NoTriangles, NonFinite, LimitExceeded, UnsafePath, WrongState, DeviceError,
                      FileWriteError, InternalError)
}


def check(result: int) -> None:
    """Raises what a negative result stands for, with the library's own sentence."""
    if result < 0:
        message = _raw.plp_last_error() or _raw.plp_result_string(result)
        raise EXCEPTIONS.get(result, PalpateError)(message.decode(errors="replace"))
