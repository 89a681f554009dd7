"""Numbers for the fields of C structs, which ctypes would cut to their width without a word."""

import ctypes
import operator
from collections.abc import Iterable
from typing import Any, SupportsFloat, SupportsIndex

from ._errors import InvalidArgument


def _integer(value: SupportsIndex, name: str, low: int, high: int) -> int:
    number = operator.index(value)
    if not low <= number <= high:
        raise InvalidArgument(f"{name} is not within {low} and {high}")
    return number


def int32(value: SupportsIndex, name: str) -> int:
    return _integer(value, name, -2**31, 2**31 - 1)


def uint32(value: SupportsIndex, name: str) -> int:
    return _integer(value, name, 0, 2**32 - 1)


def uint64(value: SupportsIndex, name: str) -> int:
    return _integer(value, name, 0, 2**64 - 1)


def doubles(values: Iterable[SupportsFloat], count: int, name: str) -> Any:
    """A C array of exactly `count` doubles."""
    numbers = [float(value) for value in values]
    if len(numbers) != count:
        raise InvalidArgument(f"{name} has {len(numbers)} numbers instead of {count}")
    return (ctypes.c_double * count)(*numbers)


def triple(values: Iterable[float]) -> tuple[float, float, float]:
    x, y, z = values
    return x, y, z


def quadruple(values: Iterable[float]) -> tuple[float, float, float, float]:
    x, y, z, w = values
    return x, y, z, w
