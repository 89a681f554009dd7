"""Views of arrays of structs, in the form that this Python has."""

import ctypes
import sys
import unittest

from palpate import _raw
from palpate._records import Span, view

STRIDE = ctypes.sizeof(_raw.plp_overlap) + 40
WITH_NUMPY = sys.modules.get("numpy") is not None


class RecordsTest(unittest.TestCase):
    def setUp(self):
        """Three structs farther apart than they are long, as a later version of the library may have them."""
        self.memory = ctypes.create_string_buffer(b"\xff" * (3 * STRIDE), 3 * STRIDE)
        for i in range(3):
            overlap = _raw.plp_overlap.from_buffer(self.memory, i * STRIDE)
            overlap.body_a, overlap.body_b, overlap.triangle_a, overlap.triangle_b = 10 + i, 20 + i, 30 + i, 40 + i
        self.records = view(Span(_raw.plp_overlap, ctypes.addressof(self.memory), 3, STRIDE, self.memory))

    def test_the_stride_is_respected(self):
        self.assertEqual(len(self.records), 3)
        self.assertEqual([record["triangle_b"] for record in self.records], [40, 41, 42])
        self.assertEqual(list(self.records["body_a"]), [10, 11, 12])
        self.assertEqual(self.records[-1]["body_b"], 22)
        self.assertEqual([record["triangle_a"] for record in self.records[1:]], [31, 32])

    def test_it_is_the_same_memory(self):
        _raw.plp_overlap.from_buffer(self.memory, STRIDE).triangle_a = 99
        self.assertEqual(self.records[1]["triangle_a"], 99)

    def test_what_is_not_there_is_an_error(self):
        with self.assertRaises(IndexError):
            self.records[3]
        with self.assertRaises(ValueError if WITH_NUMPY else KeyError):
            self.records[0]["colour"]

    def test_it_is_read_only(self):
        with self.assertRaises((TypeError, ValueError)):
            self.records[0]["triangle_a"] = 1

    def test_three_numbers_are_readable_as_such(self):
        lmd = _raw.plp_lmd(point_a=(1, 2, 3))
        record = view(Span(_raw.plp_lmd, ctypes.addressof(lmd), 1, ctypes.sizeof(lmd), lmd))[0]
        self.assertEqual(tuple(record["point_a"]), (1, 2, 3))
        self.assertRegex(repr(record), r"\b3\.")
