"""Models for the tests."""

import base64
import json
import math
from array import array

import palpate

BOX_CORNERS = [[x, y, z] for z in (-0.5, 0.5) for y in (-0.5, 0.5) for x in (-0.5, 0.5)]
BOX_TRIANGLES = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                 [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]
IDENTITY = (0, 0, 0, 0, 0, 0, 1)


def box():
    """The unit cube about the origin."""
    return palpate.Model.from_arrays(BOX_CORNERS, BOX_TRIANGLES)


def beside(x, y=0.0, z=0.0):
    return (x, y, z, 0, 0, 0, 1)


def box_soup():
    """The box as positions alone, three a triangle."""
    return [BOX_CORNERS[corner] for triangle in BOX_TRIANGLES for corner in triangle]


def wavy_sheet(size):
    """Positions and triangles of an open sheet with 2 size² triangles."""
    positions = [[i / size, j / size, 0.05 * math.sin(9 * i / size) * math.cos(7 * j / size)]
                 for i in range(size + 1) for j in range(size + 1)]
    corners = [i * (size + 1) + j for i in range(size) for j in range(size)]
    triangles = [triangle for c in corners
                 for triangle in ([c, c + size + 1, c + 1], [c + 1, c + size + 1, c + size + 2])]
    return positions, triangles


def gltf(uri=None, **changes):
    """The bytes of a .gltf file with the box; `uri` names the buffer, None embeds it; `changes` replace members."""
    content = buffer_of_gltf()
    uri = uri or "data:application/octet-stream;base64," + base64.b64encode(content).decode()
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 36, "type": "VEC3",
                       "min": [-0.5, -0.5, -0.5], "max": [0.5, 0.5, 0.5]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(content)}],
        "buffers": [{"uri": uri, "byteLength": len(content)}],
    }
    return json.dumps(document | changes).encode()


def buffer_of_gltf():
    return array("f", [number for position in box_soup() for number in position]).tobytes()
