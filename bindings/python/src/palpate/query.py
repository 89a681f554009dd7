"""Contacts between two models at one pose."""

from collections.abc import Iterable
from ctypes import sizeof

from . import _raw
from ._errors import InvalidHandle, check
from ._native import Closing, create
from ._numbers import doubles, uint32
from .contacts import Contacts, new_contacts_struct
from .law import Law, law_number
from .model import Model
from .pose import PoseLike, pose_struct


class QueryResult(Closing):
    """Room for the outcome of a query; reusing one avoids allocations. One thread at a time may use it."""

    def __init__(self) -> None:
        super().__init__(create(_raw.plp_query_result_create, _raw.plp_query_result_release))


def _options(cutoff: float, stiffness: float, reference_point: Iterable[float],
             max_overlaps: int, law: Law) -> _raw.plp_query_options:
    options = _raw.plp_query_options()
    _raw.plp_query_options_init(options, sizeof(options))
    options.cutoff = cutoff
    options.stiffness = stiffness
    options.reference_point = doubles(reference_point, 3, "reference_point")
    options.law = law_number(law)
    options.max_overlaps = uint32(max_overlaps, "max_overlaps")
    return options


def query(a: Model, b: Model, pose: PoseLike, cutoff: float, *, stiffness: float = 1000.0,
          reference_point: Iterable[float] = (0.0, 0.0, 0.0), max_overlaps: int = 1024,
          law: Law = "springs", result: QueryResult | None = None) -> Contacts:
    """Finds every local minimum distance within `cutoff` metres between two models, and the wrench of their springs on
    B: force = stiffness × (cutoff − distance) × weight, in newtons. Under `law` "smooth" what pushes is shared so that it
    is continuous in the pose: see `springs` of the outcome.

    `pose` is B's frame in A's. Points, normals, forces and the torque are in A's frame, the torque about
    `reference_point`, which is in B's. At most `max_overlaps` overlapping pairs are listed. With `result` the outcome
    overwrites that of the last query into it; without, every outcome has memory of its own."""
    room = QueryResult() if result is None else result
    native = room._native
    if native is None:
        raise InvalidHandle("result is closed")
    options = _options(cutoff, stiffness, reference_point, max_overlaps, law)
    a_from_b = pose_struct(pose)
    # A search that fails empties the room, too.
    native.generation += 1
    check(_raw.plp_query(a._handle, b._handle, a_from_b, options, native.value))
    struct = new_contacts_struct()
    check(_raw.plp_query_result_get(native.value, struct))
    return Contacts(struct, native)
