"""Scenes from glTF files, and what their bodies are."""

import ctypes
from dataclasses import dataclass

from . import _raw
from ._errors import InvalidArgument
from .pose import PoseLike, pose_struct

_KINDS = {_raw.PLP_BODY_STATIC: "static", _raw.PLP_BODY_MOVING: "moving", _raw.PLP_BODY_TOOL: "tool"}


@dataclass(frozen=True)
class BodyInfo:
    """What a body is, as it was added."""

    name: str
    """Of its node, cut after 255 bytes; "" if it has none."""
    kind: str
    """"static", "moving" or "tool"."""
    node: int | None
    """Index in the glTF file that it comes from; None: from none."""
    intangible: bool
    """The tool passes through it."""
    above: int
    """Id of the nearest body above it in the file's hierarchy; 0: none."""
    triangles: int
    """Of its model, as it is searched."""
    stiffness: float
    """N/m against the tool; 0: the scene's."""
    damping: float
    """N·s/m against the tool; 0: the scene's."""
    friction: float
    """Coefficient against the tool; 0: the scene's, negative: none."""


def body_info(struct: _raw.plp_body_info) -> BodyInfo:
    return BodyInfo(name=struct.name.decode(errors="replace"), kind=_KINDS[struct.kind],
                    node=struct.node if struct.node >= 0 else None, intangible=bool(struct.intangible),
                    above=struct.above, triangles=struct.triangles, stiffness=struct.stiffness,
                    damping=struct.damping, friction=struct.friction)


def text_bytes(text: str, name: str) -> bytes:
    """With no null character inside, which would end it early."""
    if "\0" in text:
        raise InvalidArgument(f"{name} holds a null character")
    return text.encode()


def gltf_scene_options(tool: bytes | None, pose: PoseLike, cutoff: float | None,
                       model: _raw.plp_model_options) -> _raw.plp_gltf_scene_options:
    """`tool` and `model` must live as long as what is returned."""
    options = _raw.plp_gltf_scene_options()
    _raw.plp_gltf_scene_options_init(options, ctypes.sizeof(options))
    options.model = ctypes.addressof(model)
    options.tool = ctypes.cast(ctypes.c_char_p(tool), ctypes.c_void_p)
    options.pose = pose_struct(pose)
    options.cutoff = cutoff or 0.0
    return options
