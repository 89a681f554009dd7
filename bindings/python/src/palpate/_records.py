"""Arrays of C structs, viewed where they are: as a numpy structured array, or without numpy as a sequence."""

import ctypes
import functools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Protocol

from ._numpy import numpy


class Records(Protocol):
    """What both forms have in common: `records[i]["field"]`, `records["field"]`, len() and iteration."""

    def __len__(self) -> int: ...

    def __iter__(self) -> Iterator[Any]: ...

    def __getitem__(self, key: Any, /) -> Any: ...


@dataclass(frozen=True)
class Span:
    """`count` structs, `stride` bytes from one to the next, in memory that lives as long as `owner`."""

    struct: type[ctypes.Structure]
    address: int
    count: int
    stride: int
    owner: object

    @property
    def size(self) -> int:
        return (self.count - 1) * self.stride + ctypes.sizeof(self.struct) if self.count else 0


class Record:
    """One struct of a RecordView. Its fields are read by name; those with three numbers give tuples."""

    __slots__ = ("_owner", "_struct")

    def __init__(self, struct: ctypes.Structure, owner: object) -> None:
        self._struct = struct
        self._owner = owner

    def __getitem__(self, field: str) -> Any:
        try:
            value = getattr(self._struct, field)
        except AttributeError:
            raise KeyError(field) from None
        return tuple(value) if isinstance(value, ctypes.Array) else value

    def __repr__(self) -> str:
        names = [field[0] for field in self._struct._fields_]
        return f"Record({', '.join(f'{name}={self[name]}' for name in names)})"


class RecordView:
    """A read-only sequence of Record over native memory."""

    def __init__(self, span: Span) -> None:
        self._span = span

    def __len__(self) -> int:
        return self._span.count

    def __iter__(self) -> Iterator[Record]:
        return map(self._record, range(len(self)))

    def __getitem__(self, key: Any, /) -> Any:
        if isinstance(key, str):
            return [record[key] for record in self]
        rows = range(len(self))[key]
        return [self._record(row) for row in rows] if isinstance(rows, range) else self._record(rows)

    def __repr__(self) -> str:
        return f"RecordView({list(self)})"

    def _record(self, row: int) -> Record:
        span = self._span
        return Record(span.struct.from_address(span.address + row * span.stride), span.owner)


class _ArrayInterface:
    """Hands a Span to numpy as read-only memory; the array keeps this object and so the owner alive."""

    def __init__(self, span: Span) -> None:
        self._span = span
        self.__array_interface__ = {
            "version": 3,
            "data": (span.address, True),
            "shape": (span.count,),
            "strides": (span.stride,),
            "typestr": f"|V{ctypes.sizeof(span.struct)}",
        }


@functools.cache
def _dtype(struct: type[ctypes.Structure]) -> Any:
    return numpy.dtype(struct)


def view(span: Span) -> Records:
    if numpy is None:
        return RecordView(span)
    dtype = _dtype(span.struct)
    if span.count == 0:
        return numpy.empty(0, dtype)  # type: ignore[no-any-return]
    return numpy.asarray(_ArrayInterface(span)).view(dtype)  # type: ignore[no-any-return]
