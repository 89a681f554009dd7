"""Ownership of native objects."""

import weakref
from collections.abc import Callable
from ctypes import byref, c_void_p
from types import TracebackType
from typing import Any, TypeVar

from ._errors import check

Self = TypeVar("Self", bound="Closing")


class Native:
    """One native object, released with the last Python object that refers to it: its wrapper or a view of its memory.

    `generation` counts the searches that overwrote that memory."""

    def __init__(self, value: int | None, release: Callable[[int | None], object]) -> None:
        self.value = value
        self.generation = 0
        weakref.finalize(self, release, value)


def create(function: Callable[..., int], release: Callable[[int | None], object], *arguments: Any) -> Native:
    """Calls a function whose last argument receives a handle."""
    handle = c_void_p()
    check(function(*arguments, byref(handle)))
    return Native(handle.value, release)


class Closing:
    """A wrapper that can be closed and used in a with statement."""

    def __init__(self, native: Native) -> None:
        self._native: Native | None = native

    @property
    def _handle(self) -> int | None:
        """None once closed, which the library refuses as an invalid handle."""
        return self._native.value if self._native else None

    def close(self) -> None:
        """Gives the native object up; using this one afterwards raises InvalidHandle. Arrays that still view its
        memory stay valid and delay the release."""
        self._native = None

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 traceback: TracebackType | None) -> None:
        self.close()
