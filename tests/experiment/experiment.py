"""experiment.py A B --palpate FILE --make-motion FILE [--seconds S]: slides B over A, both scaled to 0.3 m, and compares
each mode with the complete set of every tick. What certified ticks find is that set and their force its force; what
descent finds is in it. PALPATE_LONG=1 makes the motion 5 s long and compares by both laws."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SIZE = 0.3  # metres, diagonal
CUTOFF = 0.006
SPEEDS = (0.1, 0.3)  # metres a second, of a hand
LONG = os.environ.get("PALPATE_LONG", "0") not in ("", "0")


def model(name):
    """A file; data:NAME is one in the folder that PALPATE_DATA names."""
    if not name.startswith("data:"):
        return Path(name)
    if not os.environ.get("PALPATE_DATA"):
        print("skipped: PALPATE_DATA")
        sys.exit()
    return Path(os.environ["PALPATE_DATA"], name.removeprefix("data:"))


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("a", type=model)
    parser.add_argument("b", type=model)
    parser.add_argument("--palpate", required=True)
    parser.add_argument("--make-motion", required=True)
    parser.add_argument("--seconds", type=float, default=0.5)
    return parser.parse_args()


def output(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    assert done.returncode == 0, f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}"
    return done.stdout


class Experiment(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scales = [SIZE / json.loads(output(GIVEN.palpate, "info", model, "--json"))["diagonal"] for model in (GIVEN.a, GIVEN.b)]
        cls.models = (GIVEN.a, GIVEN.b, "--scale-a", scales[0], "--scale-b", scales[1], "--cutoff", CUTOFF)
        cls.folder = tempfile.TemporaryDirectory(prefix="palpate-experiment-")
        cls.addClassCleanup(cls.folder.cleanup)
        seconds = 5.0 if LONG else GIVEN.seconds
        cls.motions = {speed: cls.make_motion(f"{speed}.csv", speed, seconds) for speed in SPEEDS}

    @classmethod
    def make_motion(cls, name, speed, seconds, seed=1):
        path = Path(cls.folder.name, name)
        output(GIVEN.make_motion, cls.models[0], cls.models[1], path, *cls.models[2:], "--speed", speed,
               "--seconds", seconds, "--seed", seed)
        return path

    def compare(self, speed, mode, law):
        run = json.loads(output(GIVEN.palpate, "run", *self.models, "--trajectory", self.motions[speed], "--mode", mode,
                                "--law", law, "--compare", "--json"))
        compared = run["comparison"]
        work = " ".join(f"{name} {run['work'][name]:.1f}/{run['work_p99'][name]:.0f}/{run['work_max'][name]:.0f}"
                        for name in ("node_pairs", "triangle_pairs", "descent_steps", "front_expired", "age_ticks"))
        print(f"{GIVEN.a.stem} - {GIVEN.b.stem} {speed} m/s {mode} {law}: {run['ticks']} ticks, {compared['sets']} LMDs, "
              f"missed {compared['missed']}, spurious {compared['spurious']}, force error / (k cutoff) RMS "
              f"{compared['force_error_rms']:.2e} max {compared['force_error_max']:.2e}; a tick, mean/p99/max: {work}; "
              f"us p50/p99/max {run['local_us']['p50']:.0f}/{run['local_us']['p99']:.0f}/{run['local_us']['max']:.0f}",
              flush=True)
        self.assertGreaterEqual(compared["sets"], run["ticks"] // 2, "they slide past each other")
        self.assertEqual(compared["spurious"], 0)
        return compared

    def for_each_run(self):
        return [(speed, law) for speed in SPEEDS for law in (("smooth", "springs") if LONG else ("smooth",))]

    def test_certified_ticks_have_the_complete_set(self):
        for speed, law in self.for_each_run():
            compared = self.compare(speed, "certified", law)
            self.assertEqual(compared["missed"], 0)
            self.assertEqual((compared["force_error_max"], compared["torque_error_max"]), (0, 0))

    def test_what_descent_finds_is_in_the_complete_set(self):
        for speed, law in self.for_each_run():
            compared = self.compare(speed, "descent", law)
            self.assertLess(compared["missed"], compared["sets"])

    def test_a_motion_is_what_its_seed_makes(self):
        def poses(name, seed):
            return self.make_motion(name, 0.2, 0.01, seed).read_bytes()
        self.assertEqual(poses("one.csv", 7), poses("again.csv", 7))
        self.assertNotEqual(poses("one.csv", 7), poses("other.csv", 8))

    def test_what_cannot_be_made_into_a_motion_is_told(self):
        poses = Path(self.folder.name, "none.csv")
        for models, options, told in ((("missing.glb", GIVEN.b), ("--cutoff", "0.01"), "missing.glb"),
                                      ((GIVEN.a, GIVEN.b), ("--cutoff", "-1"), "--cutoff"),
                                      ((GIVEN.a, GIVEN.b), (), "--cutoff")):
            done = subprocess.run([GIVEN.make_motion, *models, poses, *options], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout, poses.exists()), (1, "", False))
            self.assertIn(told, done.stderr)


if __name__ == "__main__":
    GIVEN = arguments()
    unittest.main(argv=sys.argv[:1])
