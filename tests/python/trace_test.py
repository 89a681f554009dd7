"""Traces: recorded, read, replayed."""

import csv
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import palpate
from shapes import beside, box, gltf


class TraceTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="palpate-trace-")
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "touch.trace"
        self.again = Path(folder.name) / "again.trace"
        self.told = []

    def record(self):
        with palpate.Scene(2.0, 500.0, palpate.Space((1, -3, 2), 0.1), damping=2.0) as scene:
            self.wall = scene.add(box())
            self.tool = scene.add(box(), beside(13), "tool", reference_point=(0.3, 0.1, 0.7))
            scene.record(self.path)
            for i in range(40):
                self.tool.pose = (12.5 - 0.02 * i, 0.1, 0, 0.002 * i, 0.2, 0, 1)
                if i == 20:
                    scene.stiffness = 600.0
                    self.wall.pose = beside(0.01)
                contacts = scene.step()
                self.told.append((contacts.wrench, contacts.min_distance,
                                  [tuple(contact["point_a"]) for contact in contacts.contacts]))
            self.assertTrue(scene.recording.running)
            recording = scene.stop_recording()
            self.assertEqual(recording, (False, 40, 0, self.path.stat().st_size))
            self.assertFalse(scene.recording.running)

    def test_ticks_are_read_as_they_were(self):
        self.record()
        with palpate.Trace(self.path) as trace:
            self.assertEqual((len(trace), trace.lost, trace.complete), (40, 0, True))
            self.assertAlmostEqual(trace.duration, 0.039)
            self.assertEqual(trace.space, palpate.Space((1, -3, 2), 0.1))
            bodies = trace.bodies
            self.assertEqual([body.kind for body in bodies], ["static", "tool"])
            self.assertEqual([body.id for body in bodies], [self.wall.id, self.tool.id])
            for number, given in zip(bodies[1].reference_point, (0.3, 0.1, 0.7)):
                self.assertAlmostEqual(number, given, delta=1e-15)
            self.assertEqual((bodies[0].model_name, bodies[0].model_triangles), ("triangles", 12))
            ticks = list(trace)
            self.assertGreater(sum(len(tick.contacts.contacts) for tick in ticks), 10)
            for tick, (wrench, distance, points) in zip(ticks, self.told):
                self.assertEqual(tick.wrench, wrench)
                self.assertEqual(tick.contacts.min_distance, distance)
                self.assertEqual([tuple(contact["point_a"]) for contact in tick.contacts.contacts], points)
            self.assertEqual([tick.stiffness for tick in ticks], [500.0] * 20 + [600.0] * 20)
            self.assertEqual((ticks[3].mode, ticks[3].law, ticks[3].cutoff), ("certified", "smooth", 2.0))
            self.assertEqual([tick.tick for tick in ticks if tick.moves], [0, 20])
            self.assertAlmostEqual(ticks[20].moves[self.wall.id].position[0], 0.01)
            self.assertAlmostEqual(ticks[5].tool_pose.position[0], 12.4)
            self.assertEqual(trace[-1].tick, 39)
            with self.assertRaises(IndexError):
                trace[40]
        with self.assertRaises(palpate.InvalidHandle):
            trace[0]

    def test_columns(self):
        self.record()
        table = palpate.Trace(self.path).table()
        self.assertEqual(len(table), 40)
        self.assertEqual([tuple(wrench["force"]) for wrench in table["wrench"]] if hasattr(table, "dtype") else
                         [tuple(wrench.force) for wrench in table["wrench"]], [wrench.force for wrench, *_ in self.told])
        self.assertEqual([int(step) for step in table["step"]], list(range(1, 41)))

    def test_a_replay_gives_the_same_bits(self):
        self.record()
        with palpate.Trace(self.path) as trace, trace.new_scene() as scene:
            bodies = [scene.add(box(), kind=body.kind, reference_point=body.reference_point) for body in trace.bodies]
            scene.record(self.again)
            for tick in trace:
                scene.stiffness = tick.stiffness
                for recorded, body in zip(trace.bodies, bodies):
                    trace.place(tick.tick, recorded, body)
                contacts = scene.step()
                self.assertEqual((contacts.wrench, contacts.min_distance), self.told[tick.tick][:2])
            scene.stop_recording()
            again = palpate.Trace(self.again)
            self.assertEqual([tick.wrench for tick in again], [wrench for wrench, *_ in self.told])
            self.assertEqual([tick.tool_pose for tick in again], [tick.tool_pose for tick in trace])

    def record_room(self, **with_tool):
        """A wall and a shelf of one file, and a tool; the path of the file and the wrenches."""
        nodes = [{"name": "wall", "mesh": 0, "children": [1], "extras": {"stiffness": 300}},
                 {"name": "shelf", "mesh": 0, "translation": [0, 1.2, 0], "scale": [1, 0.5, 1]},
                 {"name": "pen", "mesh": 0, "translation": [1.3, 0, 0]}]
        path = self.path.with_name("room.gltf")
        path.write_bytes(gltf(nodes=nodes, scenes=[{"nodes": [0, 2] if with_tool else [0]}]))
        with palpate.Scene(0.2, 500.0, friction=0.1) as scene:
            bodies = scene.load_gltf(path, **with_tool)
            tool = bodies[-1] if with_tool else scene.add(box(), kind="tool")
            scene.record(self.path)
            wrenches = []
            for i in range(60):
                tool.pose = (1.2 - 0.002 * i, 0.01 * i, 0.05, 0.01 * i, 0.1, 0, 1)
                bodies[1].pose = beside(0.001 * i, 1.2)
                wrenches.append(scene.step().wrench)
            scene.stop_recording()
        self.assertGreater(sum(any(wrench.force) for wrench in wrenches), 40)
        return path, wrenches

    @unittest.skipUnless(os.environ.get("PALPATE_CLI"), "the command-line tool is not built")
    def test_the_command_line_replays_a_scene(self):
        def run(*arguments):
            return subprocess.run([os.environ["PALPATE_CLI"], "run", *arguments], capture_output=True, text=True)

        def wrenches_of(*arguments):
            """Of the steps, by their own trace, which has all bits."""
            done = run(*arguments, "--record", self.again)
            self.assertEqual(done.returncode, 0, done.stderr)
            with palpate.Trace(self.again) as trace:
                return [tick.wrench for tick in trace]

        path, told = self.record_room(tool="pen")
        with palpate.Trace(self.path) as trace:
            self.assertEqual([body.model_name for body in trace.bodies], [f"room.gltf#/nodes/{i}" for i in range(3)])
        self.assertEqual(wrenches_of(path, "--trajectory", self.path), told)
        third = self.path.with_name("third.trace")
        self.again.rename(third)
        self.assertEqual(wrenches_of(path, "--trajectory", third), told)
        self.assertNotEqual(wrenches_of(path, "--trajectory", self.path, "--mode", "descent", "--friction", "0"), told)
        self.assertIn("node of the scene", run(path, path, "--trajectory", self.path).stderr)
        other = self.path.with_name("other.gltf")
        other.write_bytes(gltf(nodes=[{"mesh": 0}, {}, {"mesh": 0}], scenes=[{"nodes": [0, 1, 2]}]))
        self.assertIn("/nodes/1", run(other, "--trajectory", self.path).stderr)

        path, told = self.record_room()
        model = self.path.with_name("box.gltf")
        model.write_bytes(gltf())
        self.assertEqual(wrenches_of(path, model, "--trajectory", self.path), told)
        self.assertIn("its tool is no node", run(path, "--trajectory", self.path).stderr)
        poses = self.path.with_name("poses.csv")
        with open(poses, "w", newline="") as file:
            csv.writer(file).writerows(["t px py pz qx qy qz qw".split(), [0, 0, 0, 0, 0, 0, 0, 1]])
        self.assertIn("is missing", run(model, "--trajectory", poses, "--cutoff", "1").stderr)

    def test_what_cannot_be(self):
        with palpate.Scene(0.2) as scene:
            with self.assertRaises(palpate.FileNotFound):
                scene.record("/nowhere/at/all")
            with self.assertRaises(palpate.FileWriteError):
                scene.record("/dev/full")
            with self.assertRaises(palpate.WrongState):
                scene.stop_recording()
        with self.assertRaises(palpate.FileNotFound):
            palpate.Trace("/nowhere/at/all")
        self.path.write_text("this is no trace")
        with self.assertRaises(palpate.BadFormat):
            palpate.Trace(self.path)

    def test_a_trace_that_was_cut_off(self):
        self.record()
        self.path.write_bytes(self.path.read_bytes()[:-3000])
        with palpate.Trace(self.path) as trace:
            self.assertFalse(trace.complete)
            self.assertTrue(0 < len(trace) < 40)
            self.assertEqual([tick.wrench for tick in trace], [wrench for wrench, *_ in self.told[:len(trace)]])


if __name__ == "__main__":
    unittest.main()
