"""Palpate: every place where one triangle model comes close to another, and the force of the springs between them.

    import palpate

    box = palpate.Model.load("box.glb")
    result = palpate.query(box, box, (1.1, 0, 0, 0, 0, 0, 1), cutoff=0.2)
    print(result.contacts["distance"], result.wrench.force)

Units are metres, seconds, newtons and newton-metres; frames are right-handed; quaternions are x y z w.
"""

from . import _raw
from ._errors import (BadFormat, DeviceError, FileNotFound, FileReadError,
                      FileWriteError, InternalError, InvalidArgument, InvalidHandle,
                      LimitExceeded, NonFinite, NoTriangles, OutOfMemory, PalpateError, UnsafePath, Unsupported,
                      WrongState)
from ._records import Records
from .contacts import Contacts, Feature, Status, Work, Wrench
from .device import Condition, Device, DeviceInfo, DeviceState, Grip, HandScript, Limiter, Safety, devices
from .gltf_scene import BodyInfo
from .log import LogLevel, set_log_callback
from .model import Model, ModelInfo, Orientation, SurfaceCounts
from .pose import Pose, PoseLike
from .query import QueryResult, query
from .recording import Recording
from .scene import Body, Scene
from .servo import Latency, ServoState, shutdown_all
from .space import Space
from .trace import Trace, TraceBody, TraceTick


def version() -> str:
    """The version of the native library, such as "0.1.0"."""
    return str(_raw.plp_version_string().decode())


__all__ = [
    "BadFormat", "Body", "BodyInfo", "Condition", "Contacts", "Device", "DeviceError", "DeviceInfo", "DeviceState",
    "Feature", "FileNotFound", "FileReadError", "FileWriteError", "Grip", "HandScript", "InternalError",
    "InvalidArgument", "InvalidHandle", "Latency", "LimitExceeded", "Limiter", "LogLevel", "Model", "ModelInfo",
    "NoTriangles", "NonFinite", "Orientation", "OutOfMemory", "PalpateError", "Pose", "PoseLike", "QueryResult",
    "Recording", "Records", "Safety", "Scene", "ServoState", "Space", "Status", "SurfaceCounts", "Trace", "TraceBody",
    "TraceTick", "UnsafePath", "Unsupported", "Work", "Wrench", "WrongState", "devices", "query", "set_log_callback",
    "shutdown_all", "version",
]
