"""The receiver of log messages."""

import atexit
import enum
from collections.abc import Callable
from ctypes import c_void_p, cast
from typing import TypeAlias

from . import _raw


class LogLevel(enum.IntEnum):
    """How weighty a message is."""

    ERROR = _raw.PLP_LOG_ERROR
    WARNING = _raw.PLP_LOG_WARNING
    INFO = _raw.PLP_LOG_INFO
    DEBUG = _raw.PLP_LOG_DEBUG


LogCallback: TypeAlias = Callable[[LogLevel, str], object]
_callback: LogCallback | None = None


def _deliver(level: int, message: bytes, _user: int | None) -> None:
    callback = _callback
    if callback is not None:
        callback(LogLevel(level), message.decode(errors="replace"))


# Another thread may be inside the native callback while the receiver is exchanged, so that it must never be freed:
# there is one, and it looks up who receives.
_receive = _raw.plp_log_callback(_deliver)


def set_log_callback(callback: LogCallback | None) -> None:
    """Installs the one receiver of log messages, or with None removes it. It is called as callback(level, message) from
    whatever thread is in a call of this package, and must not call this package itself."""
    global _callback
    _callback = callback
    _raw.plp_set_log_callback(cast(c_void_p(), _raw.plp_log_callback) if callback is None else _receive, None)


# The interpreter may be gone before the last model is.
atexit.register(set_log_callback, None)
