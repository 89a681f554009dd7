"""Haptic devices behind their safety limits."""

from collections.abc import Iterable
from ctypes import byref, c_double, c_size_t, sizeof
from enum import IntEnum
from typing import NamedTuple

from . import _raw
from ._errors import InvalidArgument, check
from ._native import Closing, create
from ._numbers import doubles, triple
from .contacts import Wrench
from .pose import Pose, PoseLike, pose_of, pose_struct


class Condition(IntEnum):
    """What a device, or the way to it, says of itself."""

    READY = _raw.PLP_CONDITION_READY
    NEEDS_CALIBRATION = _raw.PLP_CONDITION_NEEDS_CALIBRATION
    WARM_MOTORS = _raw.PLP_CONDITION_WARM_MOTORS
    EXCEEDED_FORCE = _raw.PLP_CONDITION_EXCEEDED_FORCE
    EXCEEDED_VELOCITY = _raw.PLP_CONDITION_EXCEEDED_VELOCITY
    LOST = _raw.PLP_CONDITION_LOST
    FAILED = _raw.PLP_CONDITION_FAILED
    NO_LIBRARY = _raw.PLP_CONDITION_NO_LIBRARY
    WRONG_LIBRARY = _raw.PLP_CONDITION_WRONG_LIBRARY
    CANNOT_OPEN = _raw.PLP_CONDITION_CANNOT_OPEN
    WITHHELD = _raw.PLP_CONDITION_WITHHELD


class DeviceInfo(NamedTuple):
    """What a device is and can do. The fields are those of plp_device_info in palpate.h."""

    uri: str
    name: str
    serial: str
    buttons: int
    sensed: int
    actuated: int
    max_force: float
    continuous_force: float
    max_torque: float
    continuous_torque: float
    max_stiffness: float
    max_damping: float
    position_resolution: float
    angle_resolution: float
    update_rate: float
    workspace_min: tuple[float, float, float]
    workspace_max: tuple[float, float, float]
    condition: Condition
    status: str


class Safety(IntEnum):
    """What the safety limits let a device do."""

    DISARMED = _raw.PLP_SAFETY_DISARMED
    RAMPING = _raw.PLP_SAFETY_RAMPING
    ARMED = _raw.PLP_SAFETY_ARMED
    FAULT = _raw.PLP_SAFETY_FAULT


class Limiter(IntEnum):
    """What can change a wrench on its way to the motors."""

    LONG_TICK = _raw.PLP_LIMITER_LONG_TICK
    NON_FINITE_WRENCH = _raw.PLP_LIMITER_NON_FINITE_WRENCH
    NON_FINITE_POSE = _raw.PLP_LIMITER_NON_FINITE_POSE
    POSE_JUMP = _raw.PLP_LIMITER_POSE_JUMP
    STALE_SERVO = _raw.PLP_LIMITER_STALE_SERVO
    STALE_POSE = _raw.PLP_LIMITER_STALE_POSE
    FORCE_CLAMP = _raw.PLP_LIMITER_FORCE_CLAMP
    TORQUE_CLAMP = _raw.PLP_LIMITER_TORQUE_CLAMP
    FORCE_SLEW = _raw.PLP_LIMITER_FORCE_SLEW
    TORQUE_SLEW = _raw.PLP_LIMITER_TORQUE_SLEW
    RAMP = _raw.PLP_LIMITER_RAMP
    DEVICE = _raw.PLP_LIMITER_DEVICE


class DeviceState(NamedTuple):
    """A device after a tick, in its base frame: +x right, +y up, +z to the user, metres."""

    pose: Pose
    linear_velocity: tuple[float, float, float]
    angular_velocity: tuple[float, float, float]
    buttons: int
    time: float
    sequence: int
    calibrated: bool
    safety: Safety
    gain: float
    commanded: Wrench
    applied: Wrench
    unactuated: bool
    ticks: int
    limiters: frozenset[Limiter]
    limiter_ticks: dict[Limiter, int]
    condition: Condition
    temperature: float
    lost: int  # samples that were taken but never arrived


class Grip(IntEnum):
    """How a simulated hand holds the handle."""

    RELEASED = _raw.PLP_GRIP_RELEASED
    LIGHT = _raw.PLP_GRIP_LIGHT
    FIRM = _raw.PLP_GRIP_FIRM


class HandScript(IntEnum):
    """What a simulated hand does."""

    HOLD = _raw.PLP_HAND_HOLD
    TAP = _raw.PLP_HAND_TAP
    PRESS = _raw.PLP_HAND_PRESS
    SLIDE = _raw.PLP_HAND_SLIDE
    WEDGE = _raw.PLP_HAND_WEDGE
    CIRCLE = _raw.PLP_HAND_CIRCLE


def _info_of(struct: _raw.plp_device_info) -> DeviceInfo:
    return DeviceInfo(struct.uri.decode(), struct.name.decode(), struct.serial.decode(), struct.buttons, struct.sensed,
                      struct.actuated, struct.max_force, struct.continuous_force, struct.max_torque,
                      struct.continuous_torque, struct.max_stiffness, struct.max_damping, struct.position_resolution,
                      struct.angle_resolution, struct.update_rate, triple(struct.workspace_min),
                      triple(struct.workspace_max), Condition(struct.condition), struct.status.decode(errors="replace"))


def _wrench_of(struct: _raw.plp_wrench) -> Wrench:
    return Wrench(triple(struct.force), triple(struct.torque))


def devices() -> list[DeviceInfo]:
    """The devices that could be opened now, and the ways to devices that are missing something, with their status."""
    count = c_size_t()
    check(_raw.plp_device_list(None, 0, byref(count)))
    structs = (_raw.plp_device_info * max(count.value, 1))()
    structs[0].struct_size = sizeof(_raw.plp_device_info)
    room = len(structs)
    check(_raw.plp_device_list(structs, room, byref(count)))
    return [_info_of(struct) for struct in structs[:min(room, count.value)]]


class Device(Closing):
    """A haptic device in its safety limits, which nothing removes. It begins disarmed: arm it with the hand on the
    handle and the face away. `uri` names one of devices(); "" is a simulated PHANToM. Any thread may use it."""

    def __init__(self, uri: str = "") -> None:
        super().__init__(create(_raw.plp_device_open, _raw.plp_device_release, uri.encode()))

    @property
    def info(self) -> DeviceInfo:
        struct = _raw.plp_device_info()
        _raw.plp_device_info_init(struct, sizeof(struct))
        check(_raw.plp_device_get_info(self._handle, struct))
        return _info_of(struct)

    @property
    def state(self) -> DeviceState:
        """After the last tick: a step of the scene that has the device."""
        struct = _raw.plp_device_state()
        _raw.plp_device_state_init(struct, sizeof(struct))
        check(_raw.plp_device_get_state(self._handle, struct))
        return DeviceState(pose_of(struct.pose), triple(struct.linear_velocity), triple(struct.angular_velocity),
                           struct.buttons, struct.time, struct.sequence, bool(struct.calibrated), Safety(struct.safety),
                           struct.gain, _wrench_of(struct.commanded), _wrench_of(struct.applied),
                           bool(struct.unactuated), struct.ticks,
                           frozenset(limiter for limiter in Limiter if struct.limiters >> limiter & 1),
                           {limiter: struct.limiter_ticks[limiter] for limiter in Limiter},
                           Condition(struct.condition), struct.temperature, struct.lost)

    def arm(self) -> None:
        """Lets force fade in from the next tick on."""
        check(_raw.plp_device_arm(self._handle))

    def calibrate(self) -> None:
        """Tells a device that needs it that its handle is now where its maker wants it for calibration."""
        check(_raw.plp_device_calibrate(self._handle))

    def disarm(self) -> None:
        """Ends all force from the next tick on."""
        check(_raw.plp_device_disarm(self._handle))

    def set_limits(self, *, dead_man: int = 0, max_force: float = 0.0, max_torque: float = 0.0,
                   force_slew: float = 0.0, torque_slew: float = 0.0, max_speed: float = 0.0,
                   max_turn_rate: float = 0.0, watchdog: float = 0.0, ramp_time: float = 0.0,
                   fault_hold: float = 0.0) -> None:
        """Tightens the limits; 0 is the device's own. `dead_man`: bits of buttons that must all be held."""
        limits = _raw.plp_safety_limits()
        _raw.plp_safety_limits_init(limits, sizeof(limits))
        limits.dead_man = dead_man
        limits.max_force, limits.max_torque = max_force, max_torque
        limits.force_slew, limits.torque_slew = force_slew, torque_slew
        limits.max_speed, limits.max_turn_rate = max_speed, max_turn_rate
        limits.watchdog, limits.ramp_time, limits.fault_hold = watchdog, ramp_time, fault_hold
        check(_raw.plp_device_set_limits(self._handle, limits))

    def set_hand(self, script: HandScript = HandScript.HOLD, grip: Grip = Grip.LIGHT, *,
                 origin: PoseLike | None = None, into: Iterable[float] = (0.0, -1.0, 0.0),
                 along: Iterable[float] = (1.0, 0.0, 0.0), depth: float = 0.01, travel: float = 0.02,
                 twist: float = 0.0, period: float = 1.0, buttons: int = 0) -> None:
        """Tells the hand that holds a simulated device what to do from the next tick on; metres, seconds, radians in
        the device's base frame. `origin`: None for the middle of the workspace."""
        options = _raw.plp_hand_options()
        _raw.plp_hand_options_init(options, sizeof(options))
        options.script, options.grip, options.buttons = int(script), int(grip), buttons
        if origin is not None:
            options.origin = pose_struct(origin)
        options.into, options.along = doubles(into, 3, "into"), doubles(along, 3, "along")
        options.depth, options.travel, options.twist, options.period = depth, travel, twist, period
        check(_raw.plp_device_set_hand(self._handle, options))

    def set_hand_poses(self, times: Iterable[float], poses: Iterable[PoseLike]) -> None:
        """Lets the hand follow recorded poses; `times` grow, in seconds."""
        seconds = list(times)
        structs = [pose_struct(pose) for pose in poses]
        if len(seconds) != len(structs):
            raise InvalidArgument(f"{len(seconds)} times for {len(structs)} poses")
        count = len(seconds)
        check(_raw.plp_device_set_hand_poses(self._handle, (c_double * count)(*seconds),
                                             (_raw.plp_pose * count)(*structs), count))

    def place_in_hand(self) -> None:
        """Moves the handle at once to where the hand wants it."""
        check(_raw.plp_device_place_in_hand(self._handle))


def device_mapping(scene_from_base: PoseLike, handle_from_tool: PoseLike, motion_scale: float, force_scale: float,
                   clutch_buttons: int, keep_tool_pose: bool,
                   torque_lever: Iterable[float]) -> _raw.plp_device_mapping:
    mapping = _raw.plp_device_mapping()
    _raw.plp_device_mapping_init(mapping, sizeof(mapping))
    mapping.flags = _raw.PLP_DEVICE_KEEP_TOOL_POSE if keep_tool_pose else 0
    mapping.scene_from_base = pose_struct(scene_from_base)
    mapping.handle_from_tool = pose_struct(handle_from_tool)
    mapping.motion_scale, mapping.force_scale = motion_scale, force_scale
    mapping.clutch_buttons = clutch_buttons
    mapping.torque_lever[:] = triple(torque_lever)
    return mapping
