"""Triangle models."""

import ctypes
import enum
import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from . import _raw
from ._errors import InvalidArgument, check
from ._native import Closing, create
from ._numbers import int32, uint64
from ._triangles import index_rows, position_rows, rows_of_three, triangles_struct
from .space import Space


class Orientation(enum.IntEnum):
    """How the closed surfaces of a model wind."""

    OPEN = _raw.PLP_ORIENTATION_OPEN
    OUTWARD = _raw.PLP_ORIENTATION_OUTWARD
    INWARD = _raw.PLP_ORIENTATION_INWARD
    MIXED = _raw.PLP_ORIENTATION_MIXED


@dataclass(frozen=True)
class SurfaceCounts:
    """Counts of a surface. Vertices are welded; edges are counted over triangles whose three corners differ."""

    triangles: int
    vertices: int
    edges: int
    boundary_edges: int
    nonmanifold_edges: int
    inconsistent_edges: int
    components: int
    orientation: Orientation
    watertight: bool


@dataclass(frozen=True)
class ModelInfo:
    """What a model is and what was done to it: lengths in metres, times in microseconds."""

    source: SurfaceCounts
    """As it came, welded only."""
    searched: SurfaceCounts
    """As it is searched, after repair."""
    stored_vertices: int
    degenerate_triangles: int
    duplicate_triangles: int
    split_triangles: int
    reversed_triangles: int
    flipped_components: int
    double_sided_triangles: int
    bounds_min: tuple[float, float, float]
    bounds_max: tuple[float, float, float]
    diagonal: float
    mesh_bytes: int
    tree_bytes: int
    """0 as long as the hierarchy is not built."""
    tree_nodes: int
    load_us: float
    tree_us: float
    read_bytes: int
    """Of the glTF and of the external buffers that its triangles need: no others are opened."""
    decoded_bytes: int
    """Of the accessors and compressed streams that were decoded to triangles."""


def _surface_counts(struct: _raw.plp_surface_counts) -> SurfaceCounts:
    values = _fields(struct)
    values["orientation"] = Orientation(struct.orientation)
    values["watertight"] = bool(struct.watertight)
    return SurfaceCounts(**values)


def _model_info(struct: _raw.plp_model_info) -> ModelInfo:
    values = _fields(struct)
    del values["struct_size"], values["note_count"]
    values["source"] = _surface_counts(struct.source)
    values["searched"] = _surface_counts(struct.searched)
    return ModelInfo(**values)


def _fields(struct: ctypes.Structure) -> dict[str, Any]:
    values = {field[0]: getattr(struct, field[0]) for field in struct._fields_}
    return {name: tuple(value) if isinstance(value, ctypes.Array) else value for name, value in values.items()}


def model_options(weld_tolerance: float, double_sided: bool, keep_winding: bool, scene: int | None,
                  max_triangles: int, scale: float = 1.0) -> _raw.plp_model_options:
    options = _raw.plp_model_options()
    _raw.plp_model_options_init(options, ctypes.sizeof(options))
    options.weld_tolerance = weld_tolerance
    options.flags = ((_raw.PLP_MODEL_DOUBLE_SIDED if double_sided else 0)
                     | (_raw.PLP_MODEL_KEEP_WINDING if keep_winding else 0))
    if scene is not None:
        options.gltf_scene = int32(scene, "scene")
    options.max_triangles = uint64(max_triangles, "max_triangles")
    options.scale = scale
    return options


def encoded_path(path: str | bytes | os.PathLike[Any]) -> bytes:
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise InvalidArgument("a path holds a null character")
    return encoded


class Model(Closing):
    """An immutable triangle model. It may be used from several threads at once, and scenes keep what they use.

    Options of all that make one: `weld_tolerance` in metres (0 welds equal positions only); `double_sided` lets both
    sides of every triangle be touched; `keep_winding` trusts the winding as it comes; more than `max_triangles` raise
    LimitExceeded (0: 100,000,000); `scene` is the index of the glTF scene (None: the file's default one); all positions
    are multiplied by `scale` before anything else."""

    @classmethod
    def load(cls, path: str | bytes | os.PathLike[Any], *, weld_tolerance: float = 0.0, double_sided: bool = False,
             keep_winding: bool = False, scene: int | None = None, max_triangles: int = 0,
             scale: float = 1.0) -> "Model":
        """Loads a .gltf or .glb file, the whole scene baked into one model. External buffers come only from the
        file's own folder or below."""
        options = model_options(weld_tolerance, double_sided, keep_winding, scene, max_triangles, scale)
        return cls(create(_raw.plp_model_load_file, _raw.plp_model_release, encoded_path(path), options))

    @classmethod
    def from_bytes(cls, data: Any, folder: str | bytes | os.PathLike[Any] | None = None, *,
                   weld_tolerance: float = 0.0, double_sided: bool = False, keep_winding: bool = False,
                   scene: int | None = None, max_triangles: int = 0, scale: float = 1.0) -> "Model":
        """From the bytes of a .gltf or .glb file, in anything that has a buffer. `folder` is where external buffers
        are, None if there are none."""
        content = data if isinstance(data, bytes) else bytes(memoryview(data))
        options = model_options(weld_tolerance, double_sided, keep_winding, scene, max_triangles, scale)
        return cls(create(_raw.plp_model_load_memory, _raw.plp_model_release, content, len(content),
                          None if folder is None else encoded_path(folder), options))

    @classmethod
    def from_arrays(cls, positions: Any, indices: Any = None, *, space: Space | None = None,
                    weld_tolerance: float = 0.0, double_sided: bool = False, keep_winding: bool = False,
                    max_triangles: int = 0, scale: float = 1.0) -> "Model":
        """From positions of shape (n, 3) and triangles of shape (m, 3), counter-clockwise seen from outside; without
        indices every three positions are a triangle. numpy arrays of float32 or float64 and of uint8, uint16 or uint32
        are read in place, also when their rows are apart. `space` is that of the positions."""
        vertices = position_rows(positions)
        corners = None if indices is None else index_rows(indices)
        options = model_options(weld_tolerance, double_sided, keep_winding, None, max_triangles, scale)
        return cls(create(_raw.plp_model_create_from_triangles, _raw.plp_model_release,
                          triangles_struct(vertices, corners, space), options))

    @property
    def info(self) -> ModelInfo:
        return _model_info(self._raw_info())

    @property
    def notes(self) -> tuple[str, ...]:
        """One sentence about each thing that was repaired, kept or skipped."""
        count = self._raw_info().note_count
        return tuple(_raw.plp_model_note(self._handle, i).decode(errors="replace") for i in range(count))

    @property
    def vertices(self) -> Any:
        """The welded vertices as they are searched: x, y and z of each in metres, a copy. A numpy array of shape
        (n, 3), without numpy a list of tuples."""
        count = self._count(_raw.plp_model_get_vertices, None)
        numbers = (ctypes.c_double * (3 * count))()
        check(_raw.plp_model_get_vertices(self._handle, numbers, count, ctypes.c_size_t()))
        return rows_of_three(numbers)

    @property
    def triangles(self) -> Any:
        """The triangles as they are searched, after repair and in no stated order: three indices into `vertices`
        each, counter-clockwise seen from outside, a copy in the form of `vertices`."""
        count = self._count(_raw.plp_model_get_triangles, None, None)
        corners = (ctypes.c_uint32 * (3 * count))()
        check(_raw.plp_model_get_triangles(self._handle, corners, None, count, ctypes.c_size_t()))
        return rows_of_three(corners)

    def prepare(self) -> None:
        """Builds the hierarchy now rather than when something first comes near."""
        check(_raw.plp_model_prepare(self._handle))

    def _count(self, function: Callable[..., int], *no_arrays: None) -> int:
        count = ctypes.c_size_t()
        check(function(self._handle, *no_arrays, 0, count))
        return count.value

    def _raw_info(self) -> _raw.plp_model_info:
        info = _raw.plp_model_info()
        _raw.plp_model_info_init(info, ctypes.sizeof(info))
        check(_raw.plp_model_get_info(self._handle, info))
        return info

    def __repr__(self) -> str:
        return f"<palpate.Model, {f'{self.info.searched.triangles} triangles' if self._handle else 'closed'}>"
