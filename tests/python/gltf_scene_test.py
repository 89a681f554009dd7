"""Scenes from glTF files: bodies by name, materials, poses back in the file."""

import os
import tempfile
import threading
import unittest
from pathlib import Path

import palpate
from shapes import beside, box, gltf

NODES = [
    {"name": "wall", "mesh": 0, "children": [2], "extras": {"stiffness": 500, "friction": 0}},
    {"name": "probe", "mesh": 0, "translation": [1.1, 0, 0]},
    {"name": "knob", "mesh": 0, "translation": [0, 5, 0], "scale": [2, 2, 2]},
]


def document(nodes=NODES):
    return gltf(nodes=nodes, scenes=[{"nodes": [0, 1]}])


class GltfSceneTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "scene.gltf"
        self.path.write_bytes(document())
        self.scene = palpate.Scene(0.05, law="springs")

    def test_nodes_become_bodies(self):
        bodies = self.scene.load_gltf(self.path, tool="probe", cutoff=0.2)
        self.assertEqual([body.name for body in bodies], ["wall", "knob", "probe"])
        self.assertEqual(self.scene.bodies, bodies)
        self.assertEqual(self.scene.cutoff, 0.2)
        wall, knob, probe = bodies
        self.assertEqual(wall.info, palpate.BodyInfo(name="wall", kind="static", node=0, intangible=False, above=0,
                                                     triangles=12, stiffness=500.0, damping=0.0, friction=-1.0))
        self.assertEqual((knob.info.above, knob.info.node), (wall.id, 2))
        self.assertEqual(probe.info.kind, "tool")
        self.assertAlmostEqual(self.scene.step().wrench.force[0], 500 * 0.1, delta=1e-4)

    def test_bodies_are_found_by_name(self):
        wall, knob, probe = self.scene.load_gltf(os.fsencode(self.path))
        self.assertEqual(self.scene.find("knob"), knob)
        self.assertEqual(len({wall, knob, probe, self.scene.find("wall")}), 3)
        self.assertEqual(self.scene.add(box()).info.node, None)
        for wrong in ("nobody", "", "kn\0ob"):
            with self.assertRaises(palpate.InvalidArgument):
                self.scene.find(wrong)

    def test_models_can_be_used_elsewhere(self):
        wall, knob, probe = self.scene.load_gltf(self.path)
        with probe.model as model:
            self.assertAlmostEqual(palpate.query(model, model, beside(1.1), 0.2).min_distance, 0.1, delta=1e-6)
        self.assertAlmostEqual(knob.model.info.diagonal, 2 * wall.model.info.diagonal, delta=1e-6)

    def test_node_matrices_go_back_into_the_file(self):
        wall, knob, probe = self.scene.load_gltf(self.path, pose=(3, 0, 0, 0, 0, 0, 1))
        self.assertEqual(wall.pose.position, (3.0, 0.0, 0.0))
        wall.pose = (3, 0, 1, 0, 0, 0, 1)
        knob.pose = (3, 5.5, 1, 0, 0, 0, 1)
        self.assertEqual(knob.node_matrix, (2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 5.5, 0, 1))
        self.assertEqual(wall.node_matrix[12:], (0, 0, 1, 1))
        with self.assertRaises(palpate.InvalidArgument):
            self.scene.add(box()).node_matrix

    def test_an_error_adds_nothing(self):
        for arguments in ({"tool": "nobody"}, {"tool": ""}, {"tool": "pro\0be"}, {"cutoff": -1.0}, {"scene": 7}):
            with self.assertRaises(palpate.InvalidArgument, msg=arguments):
                self.scene.load_gltf(self.path, **arguments)
        with self.assertRaises(palpate.LimitExceeded):
            self.scene.load_gltf(self.path, max_triangles=30)
        with self.assertRaises(palpate.FileNotFound):
            self.scene.load_gltf(self.path.with_name("nowhere.glb"))
        self.path.write_bytes(document(NODES[:2] + [{"children": [0], "mesh": 0}]))
        with self.assertRaises(palpate.BadFormat):
            self.scene.load_gltf(self.path)
        self.assertEqual(self.scene.bodies, [])
        self.assertEqual(self.scene.cutoff, 0.05)
        self.scene.close()
        with self.assertRaises(palpate.InvalidHandle):
            self.scene.load_gltf(self.path)

    def test_what_is_intangible_is_not_touched(self):
        self.scene.cutoff = 0.2
        self.scene.add(box(), intangible=True)
        self.scene.add(box(), beside(1.1), "tool")
        self.assertEqual(self.scene.step().set_count, 0)
        self.assertTrue(self.scene.bodies[0].info.intangible)

    def test_each_thread_gets_the_bodies_that_it_loads(self):
        loaded = [None] * 4
        def load(place):
            loaded[place] = self.scene.load_gltf(self.path)
        threads = [threading.Thread(target=load, args=(place,)) for place in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([[body.name for body in bodies] for bodies in loaded], [["wall", "knob", "probe"]] * 4)
        self.assertEqual(len({body for bodies in loaded for body in bodies}), 12)
