"""Bodies, one of which is the tool that the hand moves."""

from collections.abc import Iterable
from ctypes import byref, c_uint64
from typing import Literal

from . import _raw
from ._errors import InvalidArgument, InvalidHandle, check
from ._native import Closing, create
from ._numbers import doubles, uint32
from .contacts import Contacts, new_contacts_struct
from .model import Model
from .pose import Pose, PoseLike, pose_of, pose_struct
from .space import Space, space_struct

Kind = Literal["static", "moving", "tool"]
Mode = Literal["global", "descent", "certified"]
_MODES = {"global": _raw.PLP_MODE_GLOBAL, "descent": _raw.PLP_MODE_DESCENT, "certified": _raw.PLP_MODE_CERTIFIED}
_KINDS = {"static": _raw.PLP_BODY_STATIC, "moving": _raw.PLP_BODY_MOVING, "tool": _raw.PLP_BODY_TOOL}


def _mode(mode: str) -> int:
    if mode not in _MODES:
        raise InvalidArgument(f"mode is {mode!r}, which is none of {', '.join(_MODES)}")
    return _MODES[mode]


class Body:
    """A body of one scene, made by Scene.add(). It keeps its scene's wrapper, but does not keep it open."""

    def __init__(self, scene: "Scene", body_id: int) -> None:
        self._scene = scene
        self._id = body_id

    @property
    def id(self) -> int:
        """What `body_a` and `body_b` of contacts name."""
        return self._id

    @property
    def pose(self) -> Pose:
        """In the scene's space. A static body may be moved, too."""
        struct = _raw.plp_pose()
        check(_raw.plp_scene_get_pose(self._scene._handle, self._id, struct))
        return pose_of(struct)

    @pose.setter
    def pose(self, pose: PoseLike) -> None:
        check(_raw.plp_scene_set_pose(self._scene._handle, self._id, pose_struct(pose)))

    def remove(self) -> None:
        check(_raw.plp_scene_remove_body(self._scene._handle, self._id))

    def __repr__(self) -> str:
        return f"<palpate.Body {self._id:#x}>"


class Scene(Closing):
    """Bodies and a tool. Poses, points and the cutoff are in its `space`. One thread at a time may use it."""

    def __init__(self, cutoff: float, stiffness: float = 1000.0, space: Space | None = None, *,
                 mode: Mode = "certified",
                 global_every: int = 10, max_overlaps: int = 1024, threads: int = 1, tick_budget: int = 0) -> None:
        """`cutoff`: springs begin to push at this distance. `stiffness` in N/m. `space`: None for Palpate's own.
        `mode`: "global" searches from scratch in every step; "certified" keeps the complete set up to date; "descent"
        follows what a search found, repeated after `global_every` steps, and learns of new contacts late.
        `threads` share the searches of a step, whose outcome does not depend on it. `tick_budget`: when "certified", at
        most so many tests in a step, which descent then completes; 0: no limit."""
        options = _raw.plp_scene_options()
        _raw.plp_scene_options_init(options)
        options.cutoff = cutoff
        options.stiffness = stiffness
        options.max_overlaps = uint32(max_overlaps, "max_overlaps")
        options.mode = _mode(mode)
        options.global_every = uint32(global_every, "global_every")
        options.threads = uint32(threads, "threads")
        options.tick_budget = uint32(tick_budget, "tick_budget")
        if space is not None:
            options.space = space_struct(space)
        super().__init__(create(_raw.plp_scene_create, _raw.plp_scene_release, options))
        self._cutoff = options.cutoff
        self._stiffness = options.stiffness
        self._mode: Mode = mode

    @property
    def mode(self) -> Mode:
        return self._mode

    @mode.setter
    def mode(self, mode: Mode) -> None:
        check(_raw.plp_scene_set_mode(self._handle, _mode(mode)))
        self._mode = mode

    @property
    def cutoff(self) -> float:
        return float(self._cutoff)

    @cutoff.setter
    def cutoff(self, cutoff: float) -> None:
        check(_raw.plp_scene_set_cutoff(self._handle, cutoff))
        self._cutoff = cutoff

    @property
    def stiffness(self) -> float:
        """N/m of bodies that have none of their own."""
        return float(self._stiffness)

    @stiffness.setter
    def stiffness(self, stiffness: float) -> None:
        check(_raw.plp_scene_set_stiffness(self._handle, stiffness))
        self._stiffness = stiffness

    def add(self, model: Model, pose: PoseLike = Pose(), kind: Kind = "static", stiffness: float | None = None,
            reference_point: Iterable[float] = (0.0, 0.0, 0.0)) -> Body:
        """Adds a body; the scene keeps the model. `stiffness` against the tool in N/m; None or 0: the scene's.
        `reference_point` is the tool's, in its own frame and the scene's units: torques are about it."""
        if kind not in _KINDS:
            raise InvalidArgument(f"kind is {kind!r}, which is none of {', '.join(_KINDS)}")
        options = _raw.plp_body_options()
        _raw.plp_body_options_init(options)
        options.kind = _KINDS[kind]
        options.model = model._handle
        options.pose = pose_struct(pose)
        options.stiffness = stiffness or 0.0
        options.reference_point = doubles(reference_point, 3, "reference_point")
        body = c_uint64()
        check(_raw.plp_scene_add_body(self._handle, options, byref(body)))
        return Body(self, body.value)

    def step(self) -> Contacts:
        """Searches the tool against every other body that is near. The same inputs give the same bits. The arrays of
        the outcome are valid until the next step; copy() keeps them."""
        native = self._native
        if native is None:
            raise InvalidHandle("the scene is closed")
        check(_raw.plp_scene_step(native.value))
        native.generation += 1
        struct = new_contacts_struct()
        check(_raw.plp_scene_get_contacts(native.value, struct))
        return Contacts(struct, native)
