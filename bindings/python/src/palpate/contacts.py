"""The outcome of a search."""

import ctypes
import enum
from typing import NamedTuple

from . import _raw
from ._errors import InvalidHandle
from ._native import Native
from ._numbers import triple
from ._records import Records, Span, view


class Feature(enum.IntEnum):
    """What kind of place a point of a contact is on: `feature_a` and `feature_b`."""

    FACE = _raw.PLP_FEATURE_FACE
    EDGE = _raw.PLP_FEATURE_EDGE
    VERTEX = _raw.PLP_FEATURE_VERTEX


class Status(enum.IntFlag):
    """What is not as it should be in an outcome; 0: all is well."""

    BY_DESCENT = _raw.PLP_STATUS_BY_DESCENT
    """The tick budget ran out: local descent completed the set, which may lack new contacts."""
    CUT = _raw.PLP_STATUS_CUT
    WAITING = _raw.PLP_STATUS_WAITING


class Wrench(NamedTuple):
    """A force in newtons and a torque in newton-metres."""

    force: tuple[float, float, float]
    torque: tuple[float, float, float]


class Work(NamedTuple):
    """Work that a search did."""

    bodies: int
    body_pairs: int
    node_pairs: int
    triangle_pairs: int
    descents: int
    descent_steps: int
    front_entries: int
    front_expired: int
    age: int
    global_us: float
    rebuilds: int


class _Copy:
    """Memory of a copied outcome. Nothing ever overwrites it."""

    generation = 0

    def __init__(self, *spans: Span) -> None:
        self.memories = [ctypes.create_string_buffer(ctypes.string_at(span.address, span.size), span.size)
                         for span in spans]


class Contacts:
    """The outcome of one search. Its numbers stay what they are. Its arrays are views of native memory, which they keep
    alive. That of a scene, or of a QueryResult that is used again, is overwritten by the next search: from then on
    `contacts`, `springs` and `overlaps` raise InvalidHandle, and an array taken from them earlier must no longer be read. Keep a
    copy() instead."""

    def __init__(self, struct: _raw.plp_contacts, owner: Native | _Copy) -> None:
        self._struct = struct
        self._owner = owner
        self._generation = owner.generation

    @property
    def contacts(self) -> Records:
        """The local minimum distances (LMDs), a plateau's points one by one: read-only, a numpy structured array, or
        without numpy a sequence of records. The fields are those of plp_lmd in palpate.h: point_a, point_b, normal,
        distance, weight, force, body_a, body_b, set, feature_a, feature_b, corner_a, corner_b, triangle_a,
        triangle_b."""
        return view(self._lmd_span())

    @property
    def springs(self) -> Records:
        """All that pushes, each with its whole force: with the fields of `contacts`."""
        return view(self._spring_span())

    @property
    def overlaps(self) -> Records:
        """Pairs of triangles that touch or cross: body_a, body_b, triangle_a, triangle_b."""
        return view(self._overlap_span())

    @property
    def overlap(self) -> bool:
        """Whether surfaces touch or cross."""
        return bool(self._struct.overlap)

    @property
    def walled(self) -> bool:
        """Whether walls hold the tool where surfaces overlap: they are among `springs`, with a distance below 0 while
        they are pressed in."""
        return bool(self._struct.status & _raw.PLP_STATUS_WALL)

    @property
    def overlaps_cut(self) -> bool:
        """Whether more pairs overlap than are listed."""
        return bool(self._struct.overlaps_cut)

    @property
    def set_count(self) -> int:
        """The number of LMDs, a plateau counted once."""
        return int(self._struct.set_count)

    @property
    def min_distance(self) -> float:
        """Of the LMDs; infinite if there is none."""
        return float(self._struct.min_distance)

    @property
    def wrench(self) -> Wrench:
        wrench = self._struct.wrench
        return Wrench(triple(wrench.force), triple(wrench.torque))

    @property
    def status(self) -> Status:
        """Zero if all is well."""
        return Status(self._struct.status)

    @property
    def search_us(self) -> float:
        return float(self._struct.search_us)

    @property
    def work(self) -> Work:
        work = self._struct.work
        return Work(*(getattr(work, name) for name in Work._fields))

    def copy(self) -> "Contacts":
        """The same outcome in memory of its own."""
        owner = _Copy(self._lmd_span(), self._overlap_span(), self._spring_span())
        struct = _raw.plp_contacts.from_buffer_copy(self._struct)
        struct.lmds, struct.overlaps, struct.springs = map(ctypes.addressof, owner.memories)
        return Contacts(struct, owner)

    def __repr__(self) -> str:
        return f"<palpate.Contacts: {self.set_count} within the cutoff, nearest {self.min_distance:.6g}>"

    def _lmd_span(self) -> Span:
        struct = self._struct
        return self._span(_raw.plp_lmd, struct.lmds, struct.lmd_count, struct.lmd_stride)

    def _overlap_span(self) -> Span:
        struct = self._struct
        return self._span(_raw.plp_overlap, struct.overlaps, struct.overlap_count, struct.overlap_stride)

    def _spring_span(self) -> Span:
        struct = self._struct
        return self._span(_raw.plp_lmd, struct.springs, struct.spring_count, struct.lmd_stride)

    def _span(self, record: type[ctypes.Structure], address: int | None, count: int, stride: int) -> Span:
        if self._generation != self._owner.generation:
            raise InvalidHandle("these contacts were overwritten by a later search; keep a copy()")
        return Span(record, address or 0, count, stride, self._owner)


def new_contacts_struct() -> _raw.plp_contacts:
    struct = _raw.plp_contacts()
    _raw.plp_contacts_init(struct, ctypes.sizeof(struct))
    return struct
