"""Bodies, one of which is the tool that the hand moves."""

import os
from collections.abc import Iterable
from ctypes import byref, c_double, c_size_t, c_uint64, sizeof
from typing import Any, Literal

from . import _raw
from ._errors import InvalidArgument, InvalidHandle, check
from ._native import Closing, Native, create
from ._numbers import doubles, uint32
from .contacts import Contacts, new_contacts_struct
from .device import Device, device_mapping
from .gltf_scene import BodyInfo, body_info, gltf_scene_options, text_bytes
from .law import Law, law_number
from .model import Model, encoded_path, model_options
from .pose import Pose, PoseLike, pose_of, pose_struct
from .recording import Recording, recording, stop_recording
from .servo import ServoState, servo_options, servo_state
from .space import Space, space_struct

Kind = Literal["static", "moving", "tool"]
Mode = Literal["global", "descent", "certified"]
_MODES = {"global": _raw.PLP_MODE_GLOBAL, "descent": _raw.PLP_MODE_DESCENT, "certified": _raw.PLP_MODE_CERTIFIED}
_MOST_NODES = 1_000_000  # of a glTF file
_KINDS = {"static": _raw.PLP_BODY_STATIC, "moving": _raw.PLP_BODY_MOVING, "tool": _raw.PLP_BODY_TOOL}


def _mode(mode: str) -> int:
    if mode not in _MODES:
        raise InvalidArgument(f"mode is {mode!r}, which is none of {', '.join(_MODES)}")
    return _MODES[mode]


class Body:
    """A body of one scene, made by Scene.add() or Scene.load_gltf(). It keeps its scene's wrapper, but does not keep it
    open."""

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

    @property
    def info(self) -> BodyInfo:
        info = _raw.plp_body_info()
        _raw.plp_body_info_init(info, sizeof(info))
        check(_raw.plp_scene_get_body_info(self._scene._handle, self._id, info))
        return body_info(info)

    @property
    def name(self) -> str:
        """Of its node in a glTF file, cut after 255 bytes; "" if it has none."""
        return self.info.name

    @property
    def model(self) -> Model:
        """Its model, which bodies may share, in a wrapper of its own."""
        return Model(create(_raw.plp_scene_get_body_model, _raw.plp_model_release, self._scene._handle, self._id))

    @property
    def node_matrix(self) -> tuple[float, ...]:
        """What `matrix` its node has in its glTF file if that is to show it where it is now: 16 numbers, column by
        column, in metres and the file's axes whatever the space of the scene."""
        matrix = (c_double * 16)()
        check(_raw.plp_scene_get_node_matrix(self._scene._handle, self._id, matrix))
        return tuple(matrix)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Body) and (self._scene, self._id) == (other._scene, other._id)

    def __hash__(self) -> int:
        return hash((id(self._scene), self._id))

    def remove(self) -> None:
        check(_raw.plp_scene_remove_body(self._scene._handle, self._id))

    def __repr__(self) -> str:
        return f"<palpate.Body {self._id:#x}>"


class Scene(Closing):
    """Bodies and a tool. Poses, points and the cutoff are in its `space`. Any thread may change it; one at a time may
    step it and read contacts."""

    def __init__(self, cutoff: float, stiffness: float = 1000.0, space: Space | None = None, *,
                 mode: Mode = "certified", law: Law = "smooth", global_every: int = 10, max_overlaps: int = 1024,
                 damping: float = 0.0, stiffness_cap: float = 0.0, friction: float = 0.0, fade_time: float = 0.02,
                 time_step: float = 0.001, threads: int = 1, tick_budget: int = 0) -> None:
        """`cutoff`: springs begin to push at this distance. `stiffness` in N/m. `space`: None for Palpate's own.
        `mode`: "global" searches from scratch in every step; "certified" keeps the complete set up to date; "descent"
        follows what a search found, repeated after `global_every` steps, and learns of new contacts late.
        `law`: under "smooth" force and torque are continuous in the pose; under "springs" every contact pushes for
        itself and jumps as it comes and goes. `damping` in N·s/m: what a spring adds while it closes. `stiffness_cap`
        in N/m: all springs together are no stiffer in any direction; a face by itself is at most half as stiff. 0: what
        the device that holds the tool can render; negative: no cap. `friction`: Coulomb's coefficient.
        `fade_time`: seconds in which a spring fades that "descent" loses or finds late, or that hands over from a
        wall. `time_step`: seconds from one step to the next, for velocities. `threads` share the searches of a step,
        whose outcome does not depend on it. `tick_budget`: when "certified", at most so many tests in a step, which
        descent then completes; 0: no limit."""
        options = _raw.plp_scene_options()
        _raw.plp_scene_options_init(options, sizeof(options))
        options.cutoff = cutoff
        options.stiffness = stiffness
        options.max_overlaps = uint32(max_overlaps, "max_overlaps")
        options.mode = _mode(mode)
        options.global_every = uint32(global_every, "global_every")
        options.law = law_number(law)
        options.damping = damping
        options.stiffness_cap = stiffness_cap
        options.friction = friction
        options.fade_time = fade_time
        options.time_step = time_step
        options.threads = uint32(threads, "threads")
        options.tick_budget = uint32(tick_budget, "tick_budget")
        if space is not None:
            options.space = space_struct(space)
        super().__init__(create(_raw.plp_scene_create, _raw.plp_scene_release, options))
        self._cutoff = options.cutoff
        self._stiffness = options.stiffness
        self._mode: Mode = mode
        self._law: Law = law
        self._damping = options.damping
        self._stiffness_cap = options.stiffness_cap
        self._friction = options.friction

    @property
    def mode(self) -> Mode:
        return self._mode

    @mode.setter
    def mode(self, mode: Mode) -> None:
        check(_raw.plp_scene_set_mode(self._handle, _mode(mode)))
        self._mode = mode

    @property
    def law(self) -> Law:
        return self._law

    @law.setter
    def law(self, law: Law) -> None:
        check(_raw.plp_scene_set_law(self._handle, law_number(law)))
        self._law = law

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

    @property
    def damping(self) -> float:
        """N·s/m of a closing spring, of bodies that have none of their own."""
        return float(self._damping)

    @damping.setter
    def damping(self, damping: float) -> None:
        check(_raw.plp_scene_set_damping(self._handle, damping))
        self._damping = damping

    @property
    def stiffness_cap(self) -> float:
        """N/m that all springs together do not exceed in any direction; 0: what a device can render; negative: no cap."""
        return float(self._stiffness_cap)

    @stiffness_cap.setter
    def stiffness_cap(self, stiffness_cap: float) -> None:
        check(_raw.plp_scene_set_stiffness_cap(self._handle, stiffness_cap))
        self._stiffness_cap = stiffness_cap

    @property
    def friction(self) -> float:
        """Coulomb's coefficient of bodies that have none of their own."""
        return float(self._friction)

    @friction.setter
    def friction(self, friction: float) -> None:
        check(_raw.plp_scene_set_friction(self._handle, friction))
        self._friction = friction

    def add(self, model: Model, pose: PoseLike = Pose(), kind: Kind = "static", stiffness: float | None = None,
            reference_point: Iterable[float] = (0.0, 0.0, 0.0), *, damping: float | None = None,
            friction: float | None = None, intangible: bool = False) -> Body:
        """Adds a body; the scene keeps the model. `stiffness` against the tool in N/m; None or 0: the scene's.
        `damping` in N·s/m and `friction` likewise; a negative friction is none. `reference_point` is the tool's, in its
        own frame and the scene's units: torques are about it. The tool passes through what is `intangible`."""
        if kind not in _KINDS:
            raise InvalidArgument(f"kind is {kind!r}, which is none of {', '.join(_KINDS)}")
        options = _raw.plp_body_options()
        _raw.plp_body_options_init(options, sizeof(options))
        options.kind = _KINDS[kind]
        options.model = model._handle
        options.pose = pose_struct(pose)
        options.stiffness = stiffness or 0.0
        options.damping = damping or 0.0
        options.friction = friction or 0.0
        options.reference_point = doubles(reference_point, 3, "reference_point")
        options.intangible = bool(intangible)
        body = c_uint64()
        check(_raw.plp_scene_add_body(self._handle, options, byref(body)))
        return Body(self, body.value)

    def load_gltf(self, path: str | bytes | os.PathLike[Any], *, tool: str | None = None, pose: PoseLike = Pose(),
                  cutoff: float | None = None, weld_tolerance: float = 0.0, double_sided: bool = False,
                  keep_winding: bool = False, scene: int | None = None, max_triangles: int = 0,
                  scale: float = 1.0) -> list[Body]:
        """Adds the nodes of a .gltf or .glb file that have meshes as bodies, parents before children; all or, on an
        error, none. Nodes that share a mesh and a scale share a model. `tool` names the node that is the tool, with all
        that is below it, or tells its index, as "/nodes/5". `pose` is that of the file's scene in this one. `cutoff`: None leaves it as it is. Materials
        come from `extras` (stiffness, damping, friction), MPEG_material_haptic and KHR_physics_rigid_bodies, as
        palpate.h tells. The other options are those of Model.load()."""
        model = model_options(weld_tolerance, double_sided, keep_winding, scene, max_triangles, scale)
        name = None if tool is None else text_bytes(tool, "tool")
        options = gltf_scene_options(name, pose, cutoff, model)
        ids = (c_uint64 * _MOST_NODES)()
        count = c_size_t()
        check(_raw.plp_scene_load_gltf(self._handle, encoded_path(path), options, ids, len(ids), byref(count)))
        if cutoff:
            self._cutoff = options.cutoff
        return [Body(self, body) for body in ids[:count.value]]

    @property
    def bodies(self) -> list[Body]:
        """All, in the order in which they were added, as long as none was removed."""
        count = c_size_t()
        check(_raw.plp_scene_list_bodies(self._handle, None, 0, byref(count)))
        ids = (c_uint64 * count.value)()
        check(_raw.plp_scene_list_bodies(self._handle, ids, count.value, byref(count)))
        return [Body(self, body) for body in ids[:count.value]]

    def find(self, name: str) -> Body:
        """The body whose node has this name; of several the first. InvalidArgument if there is none."""
        body = c_uint64()
        check(_raw.plp_scene_find_body(self._handle, text_bytes(name, "name"), byref(body)))
        return Body(self, body.value)

    def step(self) -> Contacts:
        """Searches the tool against every other body that is near. The same inputs give the same bits. The arrays of
        the outcome are valid until the next step; copy() keeps them."""
        native = self._native
        if native is None:
            raise InvalidHandle("the scene is closed")
        check(_raw.plp_scene_step(native.value))
        return self._newest(native)

    def contacts(self) -> Contacts:
        """The outcome of the last step, that of a running servo too. Its arrays are valid until the next call of this or
        of step(); copy() keeps them."""
        native = self._native
        if native is None:
            raise InvalidHandle("the scene is closed")
        return self._newest(native)

    def _newest(self, native: Native) -> Contacts:
        native.generation += 1
        struct = new_contacts_struct()
        check(_raw.plp_scene_get_contacts(native.value, struct))
        return Contacts(struct, native)

    def set_device(self, device: Device | None, *, scene_from_base: PoseLike = Pose(),
                   handle_from_tool: PoseLike = Pose(), motion_scale: float = 1.0, force_scale: float = 1.0,
                   clutch_buttons: int = 0, keep_tool_pose: bool = False,
                   torque_lever: Iterable[float] = (0.0, 0.0, 0.0)) -> None:
        """Gives the tool to a device, whose hand feels it in every step from then on; None takes it away. The poses are in
        the scene's space: where the device stands, and how the tool lies in its handle. `motion_scale`: metres of the
        scene for one of the handle; `force_scale`: newtons on the hand for one on the tool. While all `clutch_buttons`
        are held the handle moves without the tool. `keep_tool_pose` takes the tool up where it is. `torque_lever`, metres
        in the handle's frame: a device without motors for torque has it felt as force at the end of this lever."""
        mapping = device_mapping(scene_from_base, handle_from_tool, motion_scale, force_scale, clutch_buttons,
                                 keep_tool_pose, torque_lever)
        check(_raw.plp_scene_set_device(self._handle, device._handle if device is not None else None, mapping))

    def start(self, rate: float = 1000.0, *, priority: int | None = 0, cpu: int | None = None) -> None:
        """Starts a servo: a native thread that steps the scene `rate` times a second, and another that searches beside
        it. Bodies and settings may be changed meanwhile; contacts() reads the newest outcome. `priority`: of SCHED_FIFO,
        0 for a usual one, None for none. `cpu`: the only one it runs on. Both only if the system allows: see servo."""
        check(_raw.plp_scene_start(self._handle, servo_options(rate, priority, cpu)))

    def stop(self) -> None:
        """Stops the servo, if one runs, and waits until it rests."""
        check(_raw.plp_scene_stop(self._handle))

    @property
    def servo(self) -> ServoState:
        """How the servo runs or, if it was stopped, ran."""
        return servo_state(self._handle)

    def record(self, path: str | os.PathLike[str]) -> None:
        """Records every step from now on into a file that Trace reads, a servo's too, which never waits for it. Closing the
        scene ends it."""
        check(_raw.plp_scene_record(self._handle, os.fsencode(path)))

    def stop_recording(self) -> Recording:
        """Ends the recording and its file. Raises FileWriteError if something went wrong since it began, such as a full
        disk: it has ended all the same."""
        return stop_recording(self._handle)

    @property
    def recording(self) -> Recording:
        """How the recording goes."""
        return recording(self._handle)
