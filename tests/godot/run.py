"""Packs the add-on, puts it into the sample project, and runs both in Godot: the tests of scripts/tests.gd, the forces
over a hand's motion beside those of `palpate run`, and the sample."""

import argparse
import csv
import math
import os
import re
import shutil
import struct
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.append(str(ROOT / "tests" / "support"))

from commands import run  # noqa: E402  (its folder was not in the path before)

CUTOFF = 0.003  # as in scripts/tests.gd
TOLERANCE = 1e-6  # of force and torque, relative
FRAME = re.compile(r"^frame (\d+): x (\S+) y (\S+), (\d+) contacts, force (\S+) (\S+) (\S+), overlap (\w+)$",
                   re.MULTILINE)
OUTCOME = re.compile(r"^(passed|failed) (test_\w+) (.*)$", re.MULTILINE)


def make_project(folder):
    """The sample and the tests in one, with the add-on."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for path in [*(ROOT / "samples" / "godot").iterdir(), *(HERE / "scripts").iterdir()]:
        if path.suffix != ".sh":
            shutil.copy(path, folder)
    run(sys.executable, "-B", ROOT / "bindings" / "godot" / "pack.py", GIVEN.plugin, folder)
    (folder / "home").mkdir()
    return folder


def godot(program, *arguments, prefix=()):
    environment = dict(os.environ, HOME=str(PROJECT / "home"), XDG_DATA_HOME=str(PROJECT / "home"),
                       LIBGL_ALWAYS_SOFTWARE="1")
    return run(*prefix, program, "--path", PROJECT, *arguments, env=environment, timeout=300)


def norm(vector):
    return math.sqrt(sum(part * part for part in vector))


class Godot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.poses, cls.ticks, cls.trace = (PROJECT / name for name in ("poses.csv", "ticks.csv", "trace.bin"))
        models = [GIVEN.models / name for name in ("crankshaft_45k.glb", "gear_6k.glb")]
        run(GIVEN.make_motion, *models, cls.poses, "--cutoff", CUTOFF, "--seconds", 0.4)
        run(GIVEN.palpate, "run", *models, "--trajectory", cls.poses, "--cutoff", CUTOFF, "--stiffness", 1000,
            "--mode", "certified", "--out", cls.ticks)
        arguments = [f"--models={GIVEN.models}", f"--trajectory={cls.poses}", f"--trace={cls.trace}"]
        vectors = ROOT / "tests" / "golden" / "space_vectors.json"
        if vectors.exists():
            arguments.append(f"--vectors={vectors}")
        cls.printed = godot("godot3-server", "-s", "res://tests.gd", *arguments)
        cls.outcomes = OUTCOME.findall(cls.printed)

    def test_the_scripts(self):
        failed = [f"{name}: {why}" for outcome, name, why in self.outcomes if outcome == "failed"]
        self.assertFalse(failed, "\n".join(failed))
        written = re.findall(r"^func (test_\w+)", (HERE / "scripts" / "tests.gd").read_text(), re.MULTILINE)
        self.assertEqual(sorted(written), sorted(name for _, name, _ in self.outcomes), self.printed)

    def test_forces_are_those_of_the_command_line(self):
        wrenches = list(struct.iter_unpack("<6d", self.trace.read_bytes()))
        with open(self.ticks, newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(wrenches), len(rows))
        worst = 0.0
        for wrench, row in zip(wrenches, rows):
            for found, names in ((wrench[:3], ("fx", "fy", "fz")), (wrench[3:], ("tx", "ty", "tz"))):
                expected = [float(row[name]) for name in names]
                error = norm([a - b for a, b in zip(found, expected)])
                self.assertLessEqual(error, TOLERANCE * norm(expected))
                worst = max(worst, error / norm(expected) if norm(expected) else 0.0)
        touching = sum(norm(wrench[:3]) > 0 for wrench in wrenches)
        self.assertGreater(touching, len(wrenches) // 2)
        print(f"{len(wrenches)} wrenches, {touching} in contact, largest relative difference {worst:.1e}")

    def test_the_sample_slides_and_forces_come_back(self):
        frames = FRAME.findall(godot("godot3-server", "--fixed-fps", 60, f"--models={GIVEN.models}", "--frames=180"))
        self.assertEqual(len(frames), 180)
        self.assertNotIn("True", {frame[7] for frame in frames}, "the gear goes into the crankshaft")
        touching = [frame for frame in frames if float(frame[5]) > 0]
        self.assertGreater(len(touching), 120, "the gear is held up")
        self.assertGreater(float(touching[-1][1]) - float(touching[0][1]), 0.15, "metres along the crankshaft")

    @unittest.skipUnless(shutil.which("godot3-runner") and shutil.which("xvfb-run"),
                         "godot3-runner or xvfb is not installed")
    def test_the_sample_draws(self):
        picture = PROJECT / "touch.png"
        godot("godot3-runner", "--audio-driver", "Dummy", "--fixed-fps", 60, f"--models={GIVEN.models}", "--frames=90",
              f"--screenshot={picture}", prefix=("xvfb-run", "-a", "-s", "-screen 0 1024x768x24"))
        header = picture.read_bytes()[:24]
        self.assertEqual(struct.unpack(">II", header[16:24]), (960, 600))
        # A window of one colour takes a few thousand bytes; this one has two models, an arrow and a text.
        self.assertGreater(picture.stat().st_size, 15000)


def main():
    missing = [program for program in ("godot3-server", "patchelf", "strip") if not shutil.which(program)]
    if missing:
        print(f"Godot: skipped: {missing[0]} is not installed")
        return 0
    make_project(PROJECT)
    result = unittest.main(argv=["run.py"], verbosity=2, exit=False).result
    failed, skipped = len(result.failures) + len(result.errors), len(result.skipped)
    scripts = getattr(Godot, "outcomes", [])
    failed_scripts = sum(outcome == "failed" for outcome, _, _ in scripts)
    print(f"Godot: {result.testsRun - failed - skipped + len(scripts) - failed_scripts} passed, "
          f"{failed + failed_scripts} failed")
    if skipped:
        print(f"Godot under Xvfb: skipped: {result.skipped[0][1]}")
    return 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for name in ("plugin", "palpate", "make_motion", "models", "folder"):
        parser.add_argument("--" + name.replace("_", "-"), type=lambda text: Path(text).resolve(), required=True)
    GIVEN = parser.parse_args()
    PROJECT = GIVEN.folder / "project"
    sys.exit(main())
