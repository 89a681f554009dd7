"""How the recording of a scene goes."""

from ctypes import sizeof
from typing import NamedTuple

from . import _raw
from ._errors import check


class Recording(NamedTuple):
    """`ticks` are in the file or on their way to it, `lost` ones found no room; `bytes` are of the file."""

    running: bool
    ticks: int
    lost: int
    bytes: int


def _struct() -> _raw.plp_recording:
    struct = _raw.plp_recording()
    _raw.plp_recording_init(struct, sizeof(struct))
    return struct


def _recording_of(struct: _raw.plp_recording) -> Recording:
    return Recording(bool(struct.running), struct.ticks, struct.lost, struct.bytes)


def recording(handle: int | None) -> Recording:
    struct = _struct()
    check(_raw.plp_scene_get_recording(handle, struct))
    return _recording_of(struct)


def stop_recording(handle: int | None) -> Recording:
    struct = _struct()
    check(_raw.plp_scene_stop_recording(handle, struct))
    return _recording_of(struct)
