"""Rigid poses and the forms in which callers have them."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from . import _raw
from ._errors import InvalidArgument
from ._numbers import doubles, quadruple, triple

# How far a matrix may be from rigid: single-precision rounding, with room for a product of several.
_RIGID_TOLERANCE = 1e-5


@dataclass(frozen=True)
class Pose:
    """x ↦ rotate(orientation, x) + position. `orientation` is a quaternion x y z w, which need not be normalised."""

    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)

    @classmethod
    def from_matrix(cls, matrix: Iterable[Iterable[float]]) -> "Pose":
        """From the four rows of a 4×4 matrix that multiplies column vectors: a rotation, a translation, no scale."""
        rows = [[float(value) for value in row] for row in matrix]
        if [len(row) for row in rows] != [4, 4, 4, 4]:
            raise InvalidArgument("pose is no 4×4 matrix")
        if not _is_rigid(rows):
            raise InvalidArgument("pose is a matrix that is not rigid: it scales, shears, mirrors, or is transposed")
        return cls((rows[0][3], rows[1][3], rows[2][3]), _quaternion(rows))


# A Pose, its seven numbers px py pz qx qy qz qw, or a 4×4 matrix; numpy arrays are as good as sequences.
PoseLike: TypeAlias = Pose | Iterable[float] | Iterable[Iterable[float]]


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return math.fsum(x * y for x, y in zip(a, b))


def _is_rigid(rows: list[list[float]]) -> bool:
    """Written so that a NaN anywhere is not rigid."""
    x, y, z = (row[:3] for row in rows[:3])
    cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]
    errors = [_dot(x, x) - 1, _dot(y, y) - 1, _dot(x, y), *(a - b for a, b in zip(cross, z)),
              *(a - b for a, b in zip(rows[3], (0, 0, 0, 1)))]
    return all(abs(error) <= _RIGID_TOLERANCE for error in errors)


def _quaternion(rows: list[list[float]]) -> tuple[float, float, float, float]:
    """S. W. Shepperd, "Quaternion from rotation matrix", 1978: divides by the largest of the four, never by a small
    number."""
    m = rows
    squares = (1 + m[0][0] - m[1][1] - m[2][2], 1 - m[0][0] + m[1][1] - m[2][2],
               1 - m[0][0] - m[1][1] + m[2][2], 1 + m[0][0] + m[1][1] + m[2][2])
    largest = squares.index(max(squares))
    xy, yz, zx = m[1][0] + m[0][1], m[2][1] + m[1][2], m[0][2] + m[2][0]
    x, y, z = m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]
    unscaled = ((squares[0], xy, zx, x), (xy, squares[1], yz, y), (zx, yz, squares[2], z), (x, y, z, squares[3]))
    scale = 0.5 / math.sqrt(squares[largest])
    qx, qy, qz, qw = (value * scale for value in unscaled[largest])
    return qx, qy, qz, qw


def pose_struct(pose: PoseLike) -> _raw.plp_pose:
    if not isinstance(pose, Pose):
        values: list[Any] = list(pose)
        if len(values) == 4:
            pose = Pose.from_matrix(values)
        elif len(values) == 7:
            pose = Pose(triple(values[:3]), quadruple(values[3:]))
        else:
            raise InvalidArgument("pose is neither a Pose nor 7 numbers nor a 4×4 matrix")
    return _raw.plp_pose(doubles(pose.position, 3, "pose.position"), doubles(pose.orientation, 4, "pose.orientation"))


def pose_of(struct: _raw.plp_pose) -> Pose:
    return Pose(triple(struct.position), quadruple(struct.orientation))
