"""Callers' arrays as plp_triangles: where their layout allows it the library reads them in place, else a copy."""

from array import array
from collections.abc import Iterable, Iterator
from ctypes import c_void_p, sizeof
from typing import Any

from . import _raw
from ._errors import InvalidArgument
from ._numpy import numpy
from .space import Space, space_struct

_TYPES = {
    ("f", 4): _raw.PLP_TYPE_FLOAT32,
    ("f", 8): _raw.PLP_TYPE_FLOAT64,
    ("u", 1): _raw.PLP_TYPE_UINT8,
    ("u", 2): _raw.PLP_TYPE_UINT16,
    ("u", 4): _raw.PLP_TYPE_UINT32,
}
_INDEX_MAX = 2**32 - 1


class Rows:
    """Rows of three numbers in memory that lives as long as this object."""

    def __init__(self, memory: object, address: int, count: int, stride: int, type_code: int) -> None:
        self.memory = memory
        self.address = c_void_p(address)
        self.count = count
        self.stride = stride
        self.type_code = type_code


def rows_of_three(numbers: Any) -> Any:
    """A ctypes array as a numpy array of three columns that keeps it alive, without numpy as a list of tuples."""
    if numpy is not None:
        return numpy.ctypeslib.as_array(numbers).reshape(-1, 3)
    return list(zip(*[iter(numbers)] * 3))


def triangles_struct(positions: Rows, indices: Rows | None, space: Space | None) -> _raw.plp_triangles:
    """Valid as long as the rows."""
    triangles = _raw.plp_triangles()
    _raw.plp_triangles_init(triangles, sizeof(triangles))
    triangles.positions = positions.address
    triangles.position_stride = positions.stride
    triangles.vertex_count = positions.count
    triangles.position_type = positions.type_code
    triangles.index_type = _raw.PLP_TYPE_NONE
    if indices is not None:
        triangles.indices = indices.address
        triangles.index_stride = indices.stride
        triangles.triangle_count = indices.count
        triangles.index_type = indices.type_code
    if space is not None:
        triangles.space = space_struct(space)
    return triangles


def position_rows(positions: Any) -> Rows:
    if numpy is None:
        return _packed_rows(array("d", map(float, _flat(positions))), _raw.PLP_TYPE_FLOAT64, "positions")
    numbers = numpy.asarray(positions)
    if numbers.dtype.kind not in "fiu":
        raise InvalidArgument(f"positions are of type {numbers.dtype}, which is none of real numbers")
    return _rows_of(numbers if _has_type(numbers, "f") else numbers.astype(numpy.float64), "positions")


def index_rows(indices: Any) -> Rows:
    if numpy is None:
        return _packed_rows(_packed_indices(indices), _raw.PLP_TYPE_UINT32, "indices")
    numbers = numpy.asarray(indices)
    if numbers.dtype.kind not in "iu":
        raise InvalidArgument(f"indices are of type {numbers.dtype}, which is none of integers")
    if not _has_type(numbers, "u"):
        # Some would otherwise become other indices when they are cut to 32 bits.
        if numbers.size and not 0 <= numbers.min() <= numbers.max() <= _INDEX_MAX:
            raise InvalidArgument("indices are not within 0 and 2^32 - 1")
        numbers = numbers.astype(numpy.uint32)
    return _rows_of(numbers, "indices")


def _has_type(numbers: Any, kind: str) -> bool:
    dtype = numbers.dtype
    return bool(dtype.isnative) and dtype.kind == kind and (dtype.kind, dtype.itemsize) in _TYPES


def _rows_of(numbers: Any, name: str) -> Rows:
    """Rows of any spacing are read in place, as are numbers that follow each other three by three."""
    if numbers.ndim == 1 and numbers.size % 3 == 0:
        numbers = numbers.reshape(-1, 3)
    if numbers.ndim != 2 or numbers.shape[1] != 3:
        raise InvalidArgument(f"{name} have the shape {numbers.shape} instead of (n, 3)")
    row, item = numbers.strides
    if item != numbers.itemsize or row < 3 * numbers.itemsize:
        numbers = numpy.ascontiguousarray(numbers)
    type_code = _TYPES[numbers.dtype.kind, numbers.dtype.itemsize]
    return Rows(numbers, numbers.ctypes.data, len(numbers), numbers.strides[0], type_code)


def _flat(values: Iterable[Any]) -> Iterator[Any]:
    """The numbers of (n, 3) or of flat data, in order."""
    for value in values.tolist() if isinstance(values, memoryview) else values:
        if isinstance(value, Iterable):
            yield from value
        else:
            yield value


def _packed_indices(indices: Iterable[Any]) -> "array[int]":
    try:
        return array("I", _flat(indices))
    except OverflowError:
        raise InvalidArgument("indices are not within 0 and 2^32 - 1") from None
    except TypeError:
        raise InvalidArgument("indices are none of integers") from None


def _packed_rows(numbers: "array[Any]", type_code: int, name: str) -> Rows:
    if len(numbers) % 3:
        raise InvalidArgument(f"{name} are {len(numbers)} numbers, which is no multiple of three")
    return Rows(numbers, numbers.buffer_info()[0], len(numbers) // 3, 3 * numbers.itemsize, type_code)
