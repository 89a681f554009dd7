"""What was recorded of a scene, and how to replay it."""

import ctypes
import os
from collections.abc import Iterator
from ctypes import sizeof
from typing import Any, NamedTuple

from . import _raw
from ._errors import check
from ._native import Closing, create
from ._numbers import triple, uint64
from ._records import Records, Span, view
from .contacts import Contacts, Status, Wrench, new_contacts_struct
from .law import Law
from .pose import Pose, pose_of
from .scene import Body, Kind, Mode, Scene
from .space import Space

_MODES: tuple[Mode, ...] = ("global", "descent", "certified")
_LAWS: tuple[Law, ...] = ("springs", "smooth")
_KINDS: tuple[Kind, ...] = ("static", "moving", "tool")


class TraceBody(NamedTuple):
    """A body of a trace: `id` as its scene called it. It is there from tick `first_tick` on, before `end_tick`.
    `model_name` is that of a file or, of a body that load_gltf() made, such as "room.glb#/nodes/5"."""

    id: int
    kind: Kind
    model_name: str
    model_triangles: int
    model_hash: int
    stiffness: float
    damping: float
    friction: float
    reference_point: tuple[float, float, float]
    first_tick: int
    end_tick: int
    intangible: bool


class TraceTick(NamedTuple):
    """One step of a trace. `moves` are the bodies that were added or placed anew before it, but for the tool; `removed`
    those that were removed. `contacts` has no springs and no list of overlaps. The rest is as in plp_trace_tick in
    palpate.h."""

    tick: int  # its place in the trace
    step: int
    time: float
    clock: float
    time_step: float
    lost: int
    mode: Mode
    law: Law
    cutoff: float
    stiffness: float
    damping: float
    stiffness_cap: float
    friction: float
    tool: int
    tool_pose: Pose
    moves: dict[int, Pose]
    removed: tuple[int, ...]
    wrench: Wrench
    status: Status
    overlap_count: int
    step_us: float
    contacts: Contacts


class Trace(Closing):
    """The trace of a scene: a sequence of TraceTick, read from its file when they are asked for. One thread at a time.

        with palpate.Trace("touch.trace") as trace:
            for tick in trace:
                print(tick.time, tick.wrench.force)
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        super().__init__(create(_raw.plp_trace_open, _raw.plp_trace_release, os.fsencode(path)))
        info = _raw.plp_trace_info()
        _raw.plp_trace_info_init(info, sizeof(info))
        check(_raw.plp_trace_get_info(self._handle, info))
        self._info = info
        self._options = _raw.plp_scene_options()
        _raw.plp_scene_options_init(self._options, sizeof(self._options))
        check(_raw.plp_trace_get_options(self._handle, self._options))

    @property
    def complete(self) -> bool:
        """False if it was cut off, as by a crash: the scene went on behind the last tick."""
        return bool(self._info.complete)

    @property
    def lost(self) -> int:
        """Steps that were not recorded, because the file was too slow."""
        return int(self._info.lost)

    @property
    def duration(self) -> float:
        """Seconds of the scene from the first tick to the last."""
        return float(self._info.duration)

    @property
    def space(self) -> Space:
        """Of the scene; all that the trace gives is in it."""
        space = self._options.space
        x, y, z = space.axes
        return Space((x, y, z), space.metres_per_unit)

    @property
    def bodies(self) -> list[TraceBody]:
        """All that there ever were, in the order in which they were added."""
        return [self._body(index) for index in range(self._info.bodies)]

    def _body(self, index: int) -> TraceBody:
        body = _raw.plp_trace_body()
        _raw.plp_trace_body_init(body, sizeof(body))
        check(_raw.plp_trace_get_body(self._handle, index, body))
        name = ctypes.string_at(body.model_name).decode(errors="replace")
        return TraceBody(body.body, _KINDS[body.kind], name, body.model_triangles, body.model_hash, body.stiffness,
                         body.damping, body.friction, triple(body.reference_point), body.first_tick, body.end_tick,
                         bool(body.intangible))

    def new_scene(self) -> Scene:
        """A scene as the recorded one was when the recording began, without its bodies."""
        options = self._options
        return Scene(options.cutoff, options.stiffness, self.space, mode=_MODES[options.mode], law=_LAWS[options.law],
                     global_every=options.global_every, max_overlaps=options.max_overlaps, damping=options.damping,
                     stiffness_cap=options.stiffness_cap, friction=options.friction, fade_time=options.fade_time,
                     time_step=options.time_step, tick_budget=options.tick_budget)

    def place(self, tick: int, recorded: TraceBody, body: Body) -> None:
        """Places a body of a scene where a recorded one was in that tick, bit by bit, which the pose of a TraceTick may
        miss by its rounding."""
        index = range(len(self))[tick]
        check(_raw.plp_trace_place(self._handle, index, recorded.id, body._scene._handle, body._id))

    def table(self) -> Records:
        """All ticks in one: a numpy structured array with a column for each field of plp_trace_tick in palpate.h that is
        a number, or without numpy a sequence of records, as in `trace.table()["wrench"]["force"]`. Its pointers are
        null."""
        rows = (_raw.plp_trace_tick * len(self))()
        for index, row in enumerate(rows):
            self._read(index, row)
            row.moves = row.removed = None
        return view(Span(_raw.plp_trace_tick, ctypes.addressof(rows), len(rows), sizeof(_raw.plp_trace_tick), rows))

    def __len__(self) -> int:
        return int(self._info.ticks)

    def __iter__(self) -> Iterator[TraceTick]:
        return map(self._tick, range(len(self)))

    def __getitem__(self, index: int) -> TraceTick:
        return self._tick(range(len(self))[index])

    def _read(self, index: int, tick: Any) -> None:
        _raw.plp_trace_tick_init(tick, sizeof(tick))
        check(_raw.plp_trace_read(self._handle, uint64(index, "index"), tick))

    def _tick(self, index: int) -> TraceTick:
        tick = _raw.plp_trace_tick()
        self._read(index, tick)
        moves = (_raw.plp_trace_move.from_address(tick.moves + i * tick.move_stride) for i in range(tick.move_count))
        placed = {move.body: pose_of(move.pose) for move in moves}
        removed = tuple((ctypes.c_uint64 * tick.removed_count).from_address(tick.removed)) if tick.removed_count else ()
        wrench = Wrench(triple(tick.wrench.force), triple(tick.wrench.torque))
        return TraceTick(index, tick.step, tick.time, tick.clock, tick.time_step, tick.lost, _MODES[tick.mode],
                         _LAWS[tick.law], tick.cutoff, tick.stiffness, tick.damping, tick.stiffness_cap, tick.friction,
                         tick.tool, pose_of(tick.tool_pose), placed, removed, wrench, Status(tick.status),
                         tick.overlap_count, tick.step_us, self._contacts())

    def _contacts(self) -> Contacts:
        native = self._native
        assert native is not None  # a tick was read from it
        struct = new_contacts_struct()
        check(_raw.plp_trace_get_contacts(native.value, struct))
        return Contacts(struct, native).copy()

    def __repr__(self) -> str:
        return f"<palpate.Trace: {len(self)} ticks of {len(self.bodies)} bodies>"
