"""Panda3D's own glTF loader beside Palpate's, and its task loop beside `palpate run`. Run by run.py."""

import csv
import json
import math
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import gltf
import numpy
from direct.showbase.ShowBase import ShowBase
from panda3d.core import (Geom, GeomEnums, GeomNode, GeomTriangles, GeomVertexData, GeomVertexFormat, GeomVertexWriter,
                          NodePath, load_prc_file_data)

import palpate

ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "samples" / "panda3d"
sys.path.insert(0, str(SAMPLE))

import panda_space  # noqa: E402  (its folder was not in the path before)

MODELS, PALPATE, MAKE_MOTION = (
    Path(os.environ[name]) for name in ("PALPATE_MODELS", "PALPATE_CLI", "PALPATE_MAKE_MOTION"))
CUTOFF = 0.003  # m
TOLERANCE = 1e-6
SEED = 5
POSES = 12
FRAME = re.compile(r"^frame \d+: x (\S+) z (\S+), \d+ contacts, force (\S+) (\S+) (\S+), overlap (\w+)$", re.MULTILINE)
load_prc_file_data("", "audio-library-name null\nwindow-type none\nnotify-level-device fatal")


def norm(vector):
    return math.sqrt(sum(part * part for part in vector))


def panda_model(path):
    root = NodePath(gltf.load_model(str(path)))
    return panda_space.model_of(root)


def counts(model):
    """All but times and sizes of memory."""
    return model.info.source, model.info.searched, model.info.double_sided_triangles


def random_poses(seed, reach, count):
    source = random.Random(seed)
    for _ in range(count):
        turn = [source.gauss(0, 1) for _ in range(4)]
        away = [source.gauss(0, 1) for _ in range(3)]
        yield palpate.Pose(tuple(reach * part / norm(away) for part in away), tuple(part / norm(turn) for part in turn))


def rewritten(path, folder):
    """The same triangles below two nodes that turn, move and scale them, with normals, which keeps Panda3D's indices."""
    content = path.read_bytes()
    length, = struct.unpack_from("<I", content, 12)
    document = json.loads(content[20:20 + length])
    document["nodes"] = [
        {"children": [1], "rotation": [0.5, 0.5, 0.5, 0.5], "translation": [0.25, -0.5, 1.0]},
        {"mesh": 0, "rotation": [0.6, 0.0, 0.0, 0.8], "scale": [2.0, 2.0, 2.0]}]
    # The positions once more: neither loader looks at what they are.
    attributes = document["meshes"][0]["primitives"][0]["attributes"]
    normals = dict(document["accessors"][attributes["POSITION"]])
    document["bufferViews"].append(document["bufferViews"][normals["bufferView"]])
    normals["bufferView"] = len(document["bufferViews"]) - 1
    attributes["NORMAL"] = len(document["accessors"])
    document["accessors"].append(normals)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I", len(text)) + b"JSON" + text + content[20 + length:]
    target = Path(folder, path.name)
    target.write_bytes(b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks)
    return target


class Loader(unittest.TestCase):
    def compare(self, path, tool_name):
        ours, theirs = palpate.Model.load(path), panda_model(path)
        self.assertEqual(counts(ours), counts(theirs))
        tool = palpate.Model.load(MODELS / tool_name)
        cutoff = 0.1 * ours.info.diagonal
        centre = [(low + high) / 2 for low, high in zip(ours.info.bounds_min, ours.info.bounds_max)]
        found = 0
        for pose in random_poses(SEED, 0.25 * (ours.info.diagonal + tool.info.diagonal), POSES):
            at = palpate.Pose(tuple(a + b for a, b in zip(pose.position, centre)), pose.orientation)
            mine, other = (palpate.query(model, tool, at, cutoff) for model in (ours, theirs))
            with self.subTest(path=path.name, seed=SEED, pose=at):
                self.assertEqual((mine.set_count, len(mine.contacts), mine.overlap),
                                 (other.set_count, len(other.contacts), other.overlap))
                self.match(mine.contacts, other.contacts, TOLERANCE * ours.info.diagonal)
            found += mine.set_count
        print(f"{path.name}: {ours.info.searched.triangles} triangles, {found} minima in {POSES} poses")
        return found

    def match(self, mine, other, tolerance):
        """One to one, because triangles come in another order."""
        rest = [numpy.concatenate((contact["point_a"], contact["point_b"])) for contact in other]
        for contact in mine:
            points = numpy.concatenate((contact["point_a"], contact["point_b"]))
            errors = [numpy.abs(points - candidate).max() for candidate in rest]
            best = int(numpy.argmin(errors))
            self.assertLessEqual(errors[best], tolerance)
            del rest[best]

    def test_its_vertex_buffers_are_our_models(self):
        names = ("gear_6k", "organic_2200", "teapot_5600", "spring_23k", "voxels", "two_sided_sheet", "nested_cavities")
        self.assertGreater(sum(self.compare(MODELS / f"{name}.glb", "l_bracket.glb") for name in names), 5 * len(names))

    def test_nodes_that_move_scale_and_share_vertices(self):
        with tempfile.TemporaryDirectory() as folder:
            path = rewritten(MODELS / "gear_6k.glb", folder)
            root = NodePath(gltf.load_model(str(path)))
            geom = root.find("**/+GeomNode").node().get_geom(0)
            self.assertTrue(geom.get_primitive(0).is_indexed())
            # A model in the frame of its own node is smaller and elsewhere: the comparison can fail.
            inner = panda_space.model_of(root.find("**/+GeomNode"))
            self.assertLess(inner.info.diagonal, 0.6 * palpate.Model.load(path).info.diagonal)
            self.assertGreater(self.compare(path, "organic_2200.glb"), 5)


def panda_pose(numbers):
    """Of a glTF's numbers, in Panda3D's frame: z up."""
    x, y, z, qx, qy, qz, qw = numbers
    return palpate.Pose((x, -z, y), (qx, -qz, qy, qw))


def gltf_vector(vector):
    x, y, z = vector
    return x, z, -y


def geom_of(told):
    """What Panda3D draws of the vertices and triangles of a golden body."""
    data = GeomVertexData("told", GeomVertexFormat.get_v3(), Geom.UH_static)
    writer = GeomVertexWriter(data, "vertex")
    for vertex in told["vertices"]:
        writer.add_data3(*vertex)
    triangles = GeomTriangles(Geom.UH_static)
    for corners in told["triangles"]:
        triangles.add_vertices(*corners)
    geom = Geom(data)
    geom.add_primitive(triangles)
    return geom


class Loop(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.base = ShowBase(windowType="none")
        cls.addClassCleanup(cls.base.destroy)

    def trace(self, poses, place):
        """A step for each pose, in a task; the wrenches in the frame of the glTF."""
        scene = palpate.Scene(CUTOFF, 1000.0, panda_space.SPACE)
        nodes = [self.base.render.attach_new_node(gltf.load_model(str(MODELS / f"{name}.glb")))
                 for name in ("crankshaft_45k", "gear_6k")]
        scene.add(panda_space.model_of(nodes[0]))
        tool = scene.add(panda_space.model_of(nodes[1]), kind="tool")
        wrenches = []

        def touch(task):
            if len(wrenches) == len(poses):
                self.base.task_mgr.stop()
                return task.done
            place(tool, nodes[1], panda_pose(poses[len(wrenches)]))
            wrench = scene.step().wrench
            wrenches.append((gltf_vector(wrench.force), gltf_vector(wrench.torque)))
            return task.cont

        self.base.task_mgr.add(touch, "touch")
        self.base.task_mgr.run()
        for node in nodes:
            node.remove_node()
        return wrenches

    def test_forces_are_those_of_the_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            models = [MODELS / name for name in ("crankshaft_45k.glb", "gear_6k.glb")]
            motion, ticks = Path(folder, "poses.csv"), Path(folder, "ticks.csv")
            subprocess.run([MAKE_MOTION, *models, motion, "--cutoff", str(CUTOFF), "--seconds", "0.3"], check=True,
                           capture_output=True)
            subprocess.run([PALPATE, "run", *models, "--trajectory", motion, "--cutoff", str(CUTOFF), "--stiffness",
                            "1000", "--mode", "certified", "--out", ticks], check=True, capture_output=True)
            with open(motion, newline="") as file:
                poses = [[float(text) for text in row[1:]] for row in list(csv.reader(file))[1:]]
            with open(ticks, newline="") as file:
                rows = list(csv.DictReader(file))
        wanted = [([float(row[name]) for name in ("fx", "fy", "fz")], [float(row[name]) for name in ("tx", "ty", "tz")])
                  for row in rows]
        self.assertGreater(sum(norm(force) > 0 for force, _ in wanted), len(wanted) // 2)
        exact = self.trace(poses, lambda tool, node, pose: setattr(tool, "pose", pose))
        self.expect_equal(exact, wanted)

        # A node keeps its pose in single precision.
        def by_node(tool, node, pose):
            panda_space.set_pose(node, self.base.render, pose)
            tool.pose = panda_space.pose_of(node, self.base.render)

        rounded = self.trace(poses, by_node)
        self.assertEqual(len(rounded), len(wanted))
        for (found, _), (force, _) in zip(rounded, wanted):
            self.assertLessEqual(norm([a - b for a, b in zip(found, force)]), 1e-3)

    def expect_equal(self, found, wanted):
        self.assertEqual(len(found), len(wanted))
        worst = 0.0
        for wrench, expected in zip(found, wanted):
            for vector, reference in zip(wrench, expected):
                error = norm([a - b for a, b in zip(vector, reference)])
                self.assertLessEqual(error, TOLERANCE * norm(reference))
                worst = max(worst, error / norm(reference) if norm(reference) else 0.0)
        print(f"{len(found)} wrenches, largest relative difference {worst:.1e}")

    def test_poses_come_back(self):
        node = self.base.render.attach_new_node("posed")
        for pose in random_poses(SEED, 2.0, 100):
            panda_space.set_pose(node, self.base.render, pose)
            back = panda_space.pose_of(node, self.base.render)
            self.assertLess(norm([a - b for a, b in zip(back.position, pose.position)]), 1e-6)
            self.assertAlmostEqual(abs(sum(a * b for a, b in zip(back.orientation, pose.orientation))), 1, delta=1e-6)

    def test_golden_vectors(self):
        path = ROOT / "tests" / "golden" / "space_vectors.json"
        if not path.exists():
            self.skipTest("there are no golden vectors")
        vectors = json.loads(path.read_text())
        told, = (space for space in vectors["spaces"] if "Panda3D" in space["name"])
        self.assertEqual(tuple(told["axes"]), panda_space.SPACE.axes)
        scene = palpate.Scene(told["cutoff"], vectors["stiffness"], panda_space.SPACE)
        for kind in ("body", "tool"):
            node = GeomNode(kind)
            node.add_geom(geom_of(told[kind]))
            pose = palpate.Pose(tuple(told[kind]["position"]), tuple(told[kind]["orientation"]))
            scene.add(panda_space.model_of(NodePath(node)), pose, "static" if kind == "body" else "tool")
        outcome = scene.step()
        for found, expected in ((outcome.wrench.force, told["force"]), (outcome.wrench.torque, told["torque"])):
            self.assertLess(norm([a - b for a, b in zip(found, expected)]), 1e-3)

    def test_the_sample_slides_and_forces_come_back(self):
        done = subprocess.run([sys.executable, "-B", SAMPLE / "touch.py", MODELS, "--headless", "--frames", "180"],
                              capture_output=True, text=True, timeout=120)
        frames = FRAME.findall(done.stdout)
        self.assertEqual((done.returncode, len(frames)), (0, 180), done.stdout + done.stderr)
        self.assertNotIn("True", {frame[5] for frame in frames}, "the gear goes into the crankshaft")
        touching = [frame for frame in frames if float(frame[4]) > 0]
        self.assertGreater(len(touching), 120, "the gear is held up")
        self.assertGreater(float(touching[-1][0]) - float(touching[0][0]), 0.15, "metres along the crankshaft")


if __name__ == "__main__":
    result = unittest.main(verbosity=2, exit=False).result
    failed, skipped = len(result.failures) + len(result.errors), len(result.skipped)
    print(f"Panda3D: {result.testsRun - failed - skipped} passed, {failed} failed")
    sys.exit(not result.wasSuccessful())
