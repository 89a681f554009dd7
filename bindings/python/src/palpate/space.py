"""Spaces other than Palpate's own."""

from ctypes import c_int32
from dataclasses import dataclass

from . import _raw
from ._errors import InvalidArgument
from ._numbers import int32


@dataclass(frozen=True)
class Space:
    """The space of poses, points and wrenches. `axes[i]` says along which Palpate axis the i-th axis points: ±1, ±2 or
    ±3 for ±x, ±y or ±z, each once. Palpate's own is (1, 2, 3), right-handed with +y up as glTF; (1, -3, 2) has z up
    (Blender, Panda3D). Forces stay in newtons and torques in newton-metres."""

    axes: tuple[int, int, int] = (1, 2, 3)
    metres_per_unit: float = 1.0


def space_struct(space: Space) -> _raw.plp_space:
    axes = [int32(axis, "space.axes") for axis in space.axes]
    if len(axes) != 3:
        raise InvalidArgument(f"space.axes has {len(axes)} numbers instead of 3")
    return _raw.plp_space(axes=(c_int32 * 3)(*axes), metres_per_unit=space.metres_per_unit)
