"""The thread that steps a scene by itself."""

from ctypes import sizeof
from typing import NamedTuple

from . import _raw
from ._errors import check


class Latency(NamedTuple):
    """Microseconds: percentiles, which may be an eighth too long, and the maximum."""

    p50: float
    p99: float
    p999: float
    max: float


class ServoState(NamedTuple):
    """How a servo runs or, if it was stopped, ran. The fields are those of plp_servo_state in palpate.h."""

    running: bool
    priority: int | None
    cpu: int | None
    wanted_rate: float
    rate: float
    ticks: int
    missed: int
    skipped: int
    work: Latency
    lateness: Latency
    waiting_ticks: int
    cut_ticks: int
    preparations: int
    searches: int
    result_age: int


def servo_options(rate: float, priority: int | None, cpu: int | None) -> _raw.plp_servo_options:
    options = _raw.plp_servo_options()
    _raw.plp_servo_options_init(options, sizeof(options))
    options.rate = rate
    options.priority = -1 if priority is None else priority
    options.cpu = -1 if cpu is None else cpu
    return options


def servo_state(handle: int | None) -> ServoState:
    struct = _raw.plp_servo_state()
    _raw.plp_servo_state_init(struct, sizeof(struct))
    check(_raw.plp_scene_get_servo(handle, struct))
    return ServoState(bool(struct.running), struct.priority or None, None if struct.cpu < 0 else struct.cpu,
                      struct.wanted_rate, struct.rate, struct.ticks, struct.missed, struct.skipped,
                      Latency(*struct.work_us), Latency(*struct.lateness_us), struct.waiting_ticks, struct.cut_ticks,
                      struct.preparations, struct.searches, struct.result_age)


def shutdown_all() -> None:
    """Stops the servos of all scenes, which also happens when the process exits."""
    check(_raw.plp_shutdown_all())
