"""Nothing grows."""

import gc
import os
import unittest
from pathlib import Path

import palpate
from palpate._native import Native
from shapes import beside, box, wavy_sheet

# What the allocator may keep for itself. A leak of 1 KiB each time would be more.
ROOM_BYTES = 512 * 1024


def resident_bytes():
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def native_count():
    return sum(isinstance(thing, Native) for thing in gc.get_objects())


class LeakTest(unittest.TestCase):
    def assert_flat(self, action, times):
        """After as many times again for allocators to settle."""
        for _ in range(times):
            action()
        gc.collect()
        natives, resident = native_count(), resident_bytes()
        for _ in range(times):
            action()
        self.assertEqual(native_count(), natives)
        self.assertLess(resident_bytes() - resident, ROOM_BYTES)

    def test_queries(self):
        a, b = box(), box()
        pose = beside(1.1, 0.25)
        self.assert_flat(lambda: palpate.query(a, b, pose, 0.2).contacts["distance"], 1000)
        self.assert_flat(lambda: palpate.query(a, b, pose, 0.2).copy(), 1000)

    def test_models(self):
        positions, triangles = wavy_sheet(12)
        self.assert_flat(lambda: palpate.Model.from_arrays(positions, triangles).prepare(), 500)

    def test_scenes(self):
        model = box()

        def live():
            scene = palpate.Scene(0.2)
            scene.add(model)
            scene.add(model, beside(1.1), "tool")
            self.assertEqual(len(scene.step().contacts), 4)

        self.assert_flat(live, 1000)

    def test_errors(self):
        def fail():
            with self.assertRaises(palpate.BadFormat):
                palpate.Model.from_bytes(b"this is not glTF")

        self.assert_flat(fail, 1000)
