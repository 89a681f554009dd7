"""picture.py PALPATE MODELS SVG: draws the crankshaft, the gear and the local minimum distances between them.

The contacts are those that the tool reports. Needs nothing but Python; takes some seconds."""

import json
import math
import struct
import subprocess
import sys
from pathlib import Path

# Of the gear in the crankshaft's frame, metres; the cutoff is wide, so that the lines are long enough to see.
POSE = (-0.005, 0.0703, -0.02, -0.5, 0.0, 0.0, math.sqrt(0.75))
CUTOFF = 0.015
YAW, PITCH = math.radians(-35), math.radians(30)
WIDTH, MARGIN = 1100, 24  # of the drawing; its height follows
SHADES = 12
COLOURS = ((104, 128, 160), (196, 164, 112))  # crankshaft, gear
LIGHT = (0.35, 0.75, 0.56)
COMPONENTS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}  # glTF component types


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def rotated(quaternion, v):
    axis, w = quaternion[:3], quaternion[3]
    t = tuple(2 * x for x in cross(axis, v))
    return tuple(x + w * y + z for x, y, z in zip(v, t, cross(axis, t)))


def glb_chunks(data):
    """The JSON and the binary chunk."""
    json_size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + json_size]), data[28 + json_size:]


def accessor(gltf, binary, index):
    """All numbers of a tightly packed accessor."""
    described = gltf["accessors"][index]
    view = gltf["bufferViews"][described["bufferView"]]
    count = described["count"] * {"SCALAR": 1, "VEC3": 3}[described["type"]]
    start = view.get("byteOffset", 0) + described.get("byteOffset", 0)
    return struct.unpack_from(f"<{count}{COMPONENTS[described['componentType']]}", binary, start)


def triangles(path):
    """The triangles of a file with one mesh that stands where it is, as ours do."""
    gltf, binary = glb_chunks(path.read_bytes())
    primitive = gltf["meshes"][0]["primitives"][0]
    numbers = accessor(gltf, binary, primitive["attributes"]["POSITION"])
    indices = accessor(gltf, binary, primitive["indices"])
    points = [numbers[i:i + 3] for i in range(0, len(numbers), 3)]
    return [[points[i] for i in indices[k:k + 3]] for k in range(0, len(indices), 3)]


def moved(model, pose):
    def place(point):
        return tuple(x + y for x, y in zip(rotated(pose[3:], point), pose[:3]))

    return [[place(point) for point in triangle] for triangle in model]


def turned(point):
    """Into the camera's frame: x right, y up, z towards the eye."""
    x, y, z = point
    x, z = x * math.cos(YAW) + z * math.sin(YAW), z * math.cos(YAW) - x * math.sin(YAW)
    return (x, y * math.cos(PITCH) - z * math.sin(PITCH), y * math.sin(PITCH) + z * math.cos(PITCH))


class Screen:
    """Orthographic, as wide as the given points."""

    def __init__(self, points):
        xs, ys, _ = zip(*points)
        self.scale = (WIDTH - 2 * MARGIN) / (max(xs) - min(xs))
        self.left, self.top = min(xs), max(ys)
        self.height = math.ceil((self.top - min(ys)) * self.scale) + 2 * MARGIN

    def place(self, p):
        return (MARGIN + (p[0] - self.left) * self.scale, MARGIN + (self.top - p[1]) * self.scale, p[2])


def shade(triangle):
    """0 … SHADES - 1 by the angle to the light; None for a triangle that faces away."""
    normal = cross(subtract(triangle[1], triangle[0]), subtract(triangle[2], triangle[0]))
    length = math.sqrt(dot(normal, normal))
    if length == 0 or normal[2] <= 0:
        return None
    return min(SHADES - 1, int((0.5 + 0.5 * dot(normal, LIGHT) / length) * SHADES))


def covered(a, b, c):
    """Pixels whose centres lie in a triangle on the screen, with their depth."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if area == 0:
        return
    for y in range(math.ceil(min(a[1], b[1], c[1]) - 0.5), math.floor(max(a[1], b[1], c[1]) - 0.5) + 1):
        for x in range(math.ceil(min(a[0], b[0], c[0]) - 0.5), math.floor(max(a[0], b[0], c[0]) - 0.5) + 1):
            px, py = x + 0.5, y + 0.5
            v = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area
            w = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area
            if v >= 0 and w >= 0 and v + w <= 1:
                yield x, y, a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2])


def paint(canvas, screen, model, which):
    """Into the canvas: pixel → (depth, (model, shade))."""
    for triangle in model:
        seen = [turned(point) for point in triangle]
        brightness = shade(seen)
        if brightness is None:
            continue
        for x, y, depth in covered(*map(screen.place, seen)):
            if (x, y) not in canvas or depth > canvas[x, y][0]:
                canvas[x, y] = (depth, (which, brightness))


def runs(canvas, height):
    """One path a colour: horizontal strokes of equal pixels."""
    paths = {}
    for y in range(height):
        x = 0
        while x < WIDTH:
            colour = canvas.get((x, y), (0, None))[1]
            end = x + 1
            while end < WIDTH and canvas.get((end, y), (0, None))[1] == colour:
                end += 1
            if colour:
                paths.setdefault(colour, []).append(f"M{x} {y}h{end - x}")
            x = end
    return paths


def hexadecimal(colour):
    which, brightness = colour
    factor = 0.35 + 0.85 * brightness / (SHADES - 1)
    return "#" + "".join(f"{min(255, round(c * factor)):02x}" for c in COLOURS[which])


def lmd_lines(lmds, screen):
    parts = []
    for lmd in lmds:
        (ax, ay, _), (bx, by, _) = (screen.place(turned(lmd[side])) for side in "ab")
        parts.append(f'<path d="M{ax:.1f} {ay:.1f}L{bx:.1f} {by:.1f}"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3"/>' for x, y in ((ax, ay), (bx, by))]
    return "\n".join(parts)


def query(tool, pair):
    command = [tool, "query", *pair, "--pose", *map(str, POSE), "--cutoff", str(CUTOFF), "--json"]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)


def drawing(models, lmds):
    screen = Screen([turned(point) for model in models for triangle in model for point in triangle])
    canvas = {}
    for which, model in enumerate(models):
        paint(canvas, screen, model, which)
    paths = "\n".join(f'<path stroke="{hexadecimal(colour)}" d="{"".join(path)}"/>'
                      for colour, path in sorted(runs(canvas, screen.height).items()))
    # Pixel rows are strokes through the middle of the row, a little wider than it so that no seams show.
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {screen.height}">\n'
            f'<title>Local minimum distances between a crankshaft and a gear</title>\n'
            f'<rect width="100%" height="100%" fill="#fff"/>\n'
            f'<g transform="translate(0 .5)" stroke-width="1.2" fill="none">\n{paths}\n</g>\n'
            f'<g stroke="#d01818" fill="#d01818" stroke-width="2.5">\n{lmd_lines(lmds, screen)}\n</g>\n</svg>\n')


def main():
    tool, folder, target = sys.argv[1:]
    pair = [Path(folder) / name for name in ("crankshaft_45k.glb", "gear_6k.glb")]
    crankshaft, gear = map(triangles, pair)
    Path(target).write_text(drawing([crankshaft, moved(gear, POSE)], query(tool, pair)["lmds"]))


if __name__ == "__main__":
    main()
