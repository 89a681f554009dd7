"""The viewer without a window: what its pictures show, that its forces are those of the command-line tool, and its
complaints."""

import csv
import math
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

from png import Picture, is_hue
from viewer_run import CLI, LEFT_PANEL, MODELS, RIGHT_PANEL, run, skip

WIDTH, HEIGHT = 960, 600
CRANKSHAFT, GEAR = f"{MODELS}/crankshaft_45k.glb", f"{MODELS}/gear_6k.glb"
BOX, BALL = f"{MODELS}/box.glb", f"{MODELS}/icosphere.glb"
# Hue from and to in degrees, and least saturation.
TOOL, NEAR, FORCE, TORQUE = (25, 42, 0.6), (45, 130, 0.7), (195, 212, 0.7), (270, 290, 0.5)
TIMES = ("local_us", "global_us")


class Film(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="palpate-viewer-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def film(self, *arguments):
        done = run("--headless", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def rows(self, name):
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def without_times(self, name):
        return [{key: value for key, value in row.items() if key not in TIMES} for row in self.rows(name)]

    def counts(self, *arguments):
        """How many pixels between the panels have the colour of each thing, and how many are neither dark nor of any
        hue, as the scene's model is."""
        path = self.folder / "picture.png"
        said = self.film("--experiment", "crankshaft-gear", "--size", WIDTH, HEIGHT, "--screenshot", path, *arguments)
        self.assertIn(f"screenshot: {path}", said)
        picture = Picture(path)
        self.assertEqual((picture.width, picture.height), (WIDTH, HEIGHT))
        counts = dict.fromkeys(("tool", "near", "force", "torque", "scene"), 0)
        for _, _, colour in picture.pixels(LEFT_PANEL, 0, WIDTH - RIGHT_PANEL, HEIGHT):
            for name, hue in (("tool", TOOL), ("near", NEAR), ("force", FORCE), ("torque", TORQUE)):
                counts[name] += is_hue(colour, *hue)
            counts["scene"] += min(colour) > 85 and max(colour) - min(colour) < 60
        return counts

    def test_a_picture_shows_what_is_felt(self):
        touching = self.counts("--frames", 120)
        self.assertGreater(touching["tool"], 3000)
        self.assertGreater(touching["scene"], 5000)
        self.assertGreater(touching["near"], 15)
        self.assertGreater(touching["force"], 200)
        self.assertGreater(touching["torque"], 60)
        apart = self.counts("--frames", 1)
        self.assertGreater(apart["tool"], 3000)
        self.assertGreater(apart["scene"], 5000)
        self.assertEqual((apart["near"], apart["force"], apart["torque"]), (0, 0, 0))

    def test_forces_are_those_of_the_tool_on_the_same_poses(self):
        poses = self.folder / "poses.csv"
        with open(poses, "w") as file:
            file.write("t,px,py,pz,qx,qy,qz,qw\n")
            for i in range(250):
                angle = 0.02 * math.sin(i / 40)
                file.write(f"{i / 1000},{-0.005 + 1e-5 * i},{0.0713 - 4e-6 * i},-0.02,{-0.5 + angle},0,0,0.866\n")
        options = ["--cutoff", 0.003, "--stiffness", 800, "--damping", 0.3, "--stiffness-cap", 2000, "--friction", 0.1]
        for mode, law in (("certified", "smooth"), ("descent", "springs")):
            chosen = [*options, "--mode", mode, "--law", law]
            self.film(CRANKSHAFT, GEAR, "--replay", poses, "--log", self.folder / "viewer.csv", *chosen)
            done = run("run", CRANKSHAFT, GEAR, "--trajectory", poses, "--out", self.folder / "cli.csv", *chosen,
                       program=CLI)
            self.assertEqual(done.returncode, 0, done.stderr)
            seen, expected = self.rows("viewer.csv"), self.rows("cli.csv")
            self.assertEqual(len(seen), 250)
            self.assertEqual(len(expected), 250)
            self.assertTrue(any(float(row["fy"]) > 0.5 for row in seen))
            for ours, theirs in zip(seen, expected):
                for key in ours.keys() - set(TIMES):
                    a, b = float(ours[key]), float(theirs[key])
                    self.assertTrue(a == b or abs(a - b) <= 1e-12 * max(1.0, abs(b)), (mode, key, ours, theirs))

    def test_work_does_not_depend_on_the_frame_rate(self):
        for name, frames, ticks in (("slow.csv", 25, 32), ("fast.csv", 200, 4)):
            self.film(BOX, BALL, "--motion", "slide", "--frames", frames, "--ticks-per-frame", ticks, "--log",
                      self.folder / name)
        slow, fast = self.without_times("slow.csv"), self.without_times("fast.csv")
        self.assertEqual(len(slow), 800)
        self.assertTrue(any(int(row["pairs"]) > 0 for row in slow))
        self.assertEqual(slow, fast)

    def assert_same_forces(self, recorded, replayed):
        keys = set(recorded[0]) - {"t", "age_ticks", *TIMES}
        self.assertEqual(len(recorded), len(replayed))
        self.assertTrue(any(float(row["fy"]) != 0.0 for row in recorded))
        for ours, theirs in zip(recorded, replayed):
            self.assertEqual({key: ours[key] for key in keys}, {key: theirs[key] for key in keys})

    def test_a_recording_replays_to_the_same_forces(self):
        trace = self.folder / "hand.plptrace"
        for mode, law in (("certified", "smooth"), ("descent", "springs")):
            said = self.film(BOX, BALL, "--motion", "slide", "--frames", 120, "--mode", mode, "--law", law,
                             "--stiffness", 700, "--friction", 0.2, "--record", trace, "--log",
                             self.folder / "recorded.csv")
            self.assertIn(f"trace: {trace}", said)
            # Whatever the settings are otherwise, a trace has its own.
            self.film(BOX, BALL, "--replay", trace, "--log", self.folder / "replayed.csv")
            self.assert_same_forces(self.rows("recorded.csv"), self.rows("replayed.csv"))
        done = run("run", BOX, BALL, "--trajectory", trace, "--out", self.folder / "cli.csv", program=CLI)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_forces(self.rows("replayed.csv"), self.rows("cli.csv"))
        self.film(BOX, BALL, "--replay", trace, "--stiffness", 0, "--damping", 0, "--log", self.folder / "changed.csv")
        self.assertTrue(all(float(row["fy"]) == 0.0 for row in self.rows("changed.csv")))

    def test_runs_are_the_same_but_for_their_times(self):
        for name, runs in (("one.csv", 1), ("three.csv", 3)):
            self.film(BOX, BALL, "--motion", "slide", "--frames", 50, "--runs", runs, "--log", self.folder / name)
        self.assertTrue(any(int(row["pairs"]) > 0 for row in self.rows("one.csv")))
        self.assertEqual(self.without_times("one.csv"), self.without_times("three.csv"))

    def test_a_servo_is_recorded(self):
        trace = self.folder / "servo.plptrace"
        self.film(BOX, BALL, "--motion", "press", "--threaded", "--frames", 60, "--size", 320, 320, "--record", trace)
        self.film(BOX, BALL, "--replay", trace, "--log", self.folder / "replayed.csv")
        self.assertGreater(len(self.rows("replayed.csv")), 100)

    def test_a_servo_steps_beside_the_pictures(self):
        said = self.film(BOX, BALL, "--motion", "press", "--threaded", "--frames", 12, "--size", 320, 320)
        self.assertRegex(said, r"the servo ran \d+ steps")

    def test_graphs_are_four_lines(self):
        self.film(BOX, BALL, "--motion", "tap", "--mode", "descent", "--frames", 100, "--graphs",
                  self.folder / "graphs.svg")
        root = xml.etree.ElementTree.parse(self.folder / "graphs.svg").getroot()
        lines = root.findall("{http://www.w3.org/2000/svg}polyline")
        self.assertEqual(len(lines), 4)
        for line in lines:
            self.assertGreater(len(line.get("points").split()), 30)

    def complaint(self, *arguments):
        done = run("--headless", *arguments)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        return done.stderr

    def test_complaints_name_what_is_wrong(self):
        broken = self.folder / "broken.glb"
        broken.write_text("no glTF")
        poses = self.folder / "poses.csv"
        poses.write_text("t,px\n")
        self.assertIn("no_such.glb", self.complaint(self.folder / "no_such.glb", BALL))
        self.assertIn("no_such.glb", self.complaint(BOX, self.folder / "no_such.glb"))
        self.assertIn("broken.glb", self.complaint(broken, BALL))
        self.assertIn("poses.csv:1", self.complaint(BOX, BALL, "--replay", poses))
        self.assertIn("sim:nothing", self.complaint(BOX, BALL, "--device", "sim:nothing"))
        self.assertIn("crankshaft-gear", self.complaint("--experiment", "nothing"))
        self.assertIn("--headless", self.complaint(BOX))
        self.assertIn("--mode fast", self.complaint(BOX, BALL, "--mode", "fast"))
        self.assertIn("--runs", self.complaint(BOX, BALL, "--threaded", "--runs", 2))
        self.assertIn("--cutoff", self.complaint(BOX, BALL, "--cutoff", "-1"))
        broken_trace = self.folder / "broken.plptrace"
        broken_trace.write_bytes(b"PLPTRACE but no more")
        self.assertIn("broken.plptrace", self.complaint(BOX, BALL, "--replay", broken_trace))
        for option in ("--screenshot", "--log", "--graphs", "--record"):
            self.assertIn("no_folder", self.complaint(BOX, BALL, "--frames", 1, option,
                                                      self.folder / "no_folder" / "file"))


if __name__ == "__main__":
    probe = run("--headless", BOX, BALL, "--frames", 1)
    if probe.stderr.startswith("palpate-viewer: EGL"):
        skip(probe.stderr.strip())
    unittest.main(verbosity=2)
