"""The raw layer against what the C compiler makes of palpate.h: a line for each size, offset and value."""

import ctypes
import os
import subprocess
import unittest

from palpate import _raw


def structs():
    return {name: value for name, value in vars(_raw).items()
            if isinstance(value, type) and issubclass(value, ctypes.Structure) and value is not ctypes.Structure}


class LayoutTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = subprocess.run([os.environ["PALPATE_LAYOUT"]], check=True, capture_output=True, text=True)
        cls.lines = [line.split() for line in done.stdout.splitlines()]

    def of_kind(self, kind, at_least):
        """The words of each line of one kind, the last as a number."""
        found = [(*words[1:-1], int(words[-1])) for words in self.lines if words[0] == kind]
        self.assertGreaterEqual(len(found), at_least)
        return found

    def test_every_struct_has_the_compilers_layout(self):
        fields = {name: [] for name, _ in self.of_kind("struct", 10)}
        self.assertEqual(fields.keys(), structs().keys())
        for name, size in self.of_kind("struct", 10):
            self.assertEqual(ctypes.sizeof(getattr(_raw, name)), size, name)
        for name, field, offset in self.of_kind("offset", 50):
            self.assertEqual(getattr(getattr(_raw, name), field).offset, offset, f"{name}.{field}")
            fields[name].append(field)
        for name, field, size in self.of_kind("size", 50):
            self.assertEqual(getattr(getattr(_raw, name), field).size, size, f"{name}.{field}")
        for name, names in fields.items():
            self.assertEqual([field[0] for field in getattr(_raw, name)._fields_], names)

    def test_every_constant_has_the_compilers_value(self):
        for name, value in self.of_kind("value", 30):
            self.assertEqual(getattr(_raw, name), value, name)

    def test_handles_ids_and_enums_have_the_size_they_are_passed_with(self):
        for name, size in self.of_kind("handle", 3):
            self.assertEqual(ctypes.sizeof(_raw._handle), size, name)
        for name, size in self.of_kind("enum", 3):
            self.assertEqual(ctypes.sizeof(ctypes.c_int), size, name)
        for name, size in self.of_kind("alias", 2):
            self.assertEqual(ctypes.sizeof(getattr(_raw, name.replace("plp_", "_"))), size, name)
