"""Many ticks against what C gets from the library, bit for bit, and what a call costs."""

import os
import struct
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import palpate
from palpate import _raw

MODELS = Path(os.environ["PALPATE_MODELS"])
BATCHES = 50
CALLS = 200  # of each
TICK = struct.Struct("<7dQ7d")


class Reference:
    """What tests/abi/reference.c wrote, in order."""

    def __init__(self, content):
        self.content = content
        self.place = 0

    def read(self, form):
        values = struct.unpack_from("<" + form, self.content, self.place)
        self.place += struct.calcsize("<" + form)
        return values


def nanoseconds(function):
    """Of the quickest batch, which other work of the machine disturbed least."""
    def batch():
        start = time.perf_counter_ns()
        for _ in range(CALLS):
            function()
        return time.perf_counter_ns() - start

    return min(batch() for _ in range(BATCHES)) // CALLS


class TicksTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "reference.bin")
            subprocess.run([os.environ["PALPATE_REFERENCE"], MODELS, file], check=True)
            cls.content = file.read_bytes()
        cls.body = palpate.Model.load(MODELS / "torus.glb")
        cls.tool = palpate.Model.load(MODELS / "organic_2200.glb")

    def test_queries_and_wrenches_equal_those_of_c_bit_for_bit(self):
        reference = Reference(self.content)
        distance, = reference.read("d")
        self.compare_queries(reference, 0.05 * distance)
        ticks = [self.compare_ticks(reference, 0.05 * distance, mode) for mode in ("global", "descent", "certified")]
        self.assertEqual(reference.place, len(self.content))
        self.assertGreaterEqual(max(ticks), 10000)

    def compare_queries(self, reference, cutoff):
        queries, = reference.read("Q")
        result = palpate.QueryResult()
        for _ in range(queries):
            found = palpate.query(self.body, self.tool, reference.read("7d"), cutoff, result=result)
            self.assertEqual(reference.read("2Q"), (len(found.contacts), found.set_count))
            self.assertEqual(reference.read("d"), (found.min_distance,))
            self.assertEqual(reference.read("6d"), (*found.wrench.force, *found.wrench.torque))
            for contact in found.contacts:
                self.assertEqual(reference.read("14d"), (
                    *contact["point_a"], *contact["point_b"], *contact["normal"], contact["distance"],
                    contact["weight"], *contact["force"]))

    def compare_ticks(self, reference, cutoff, mode):
        count, = reference.read("Q")
        with palpate.Scene(cutoff, mode=mode) as scene:
            scene.add(self.body)
            tool = scene.add(self.tool, kind="tool")
            for _ in range(count):
                pose = reference.read("7d")
                tool.pose = pose
                found = scene.step()
                tick = (*pose, found.set_count, found.min_distance, *found.wrench.force, *found.wrench.torque)
                # As bytes, which tell -0 from 0.
                self.assertEqual(TICK.pack(*tick), self.content[reference.place - 56:reference.place + 64])
                reference.read("Q7d")
        return count

    def test_calls_are_timed(self):
        with palpate.Scene(0.2) as scene:
            tool = scene.add(self.body, kind="tool")
            pose = palpate.Pose()

            def tick():
                tool.pose = pose
                return scene.step().wrench

            call, raw = nanoseconds(_raw.plp_version), nanoseconds(lambda: _raw.plp_scene_step(scene._handle))
            step, ticked = nanoseconds(lambda: scene.step().wrench), nanoseconds(tick)
            print(f"ns: a call {call}; alone in a scene, the step of C {raw}, step and wrench {step}, "
                  f"pose, step and wrench {ticked}; of its own {step - raw} a step")
            self.assertEqual(tick().force, (0, 0, 0))
