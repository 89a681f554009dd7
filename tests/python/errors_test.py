"""One exception for each error code, with the library's own sentence."""

import math
import tempfile
import unittest
from pathlib import Path

import palpate
from palpate import _raw
from palpate._errors import EXCEPTIONS, check
from shapes import BOX_CORNERS, IDENTITY, box, gltf


class MappingTest(unittest.TestCase):
    def test_every_code_has_an_exception_of_its_own(self):
        codes = [value for name, value in vars(_raw).items() if name.startswith("PLP_ERROR_")]
        self.assertEqual(set(EXCEPTIONS), set(codes))
        for code in codes:
            with self.assertRaises(palpate.PalpateError) as caught:
                check(code)
            self.assertIs(type(caught.exception), EXCEPTIONS[code])
            self.assertEqual(caught.exception.code, code)
            self.assertTrue(str(caught.exception))

    def test_success_and_remarks_do_not_raise(self):
        check(_raw.PLP_OK)
        check(1)

    def test_what_python_has_a_name_for(self):
        self.assertTrue(issubclass(palpate.InvalidArgument, ValueError))
        self.assertTrue(issubclass(palpate.FileNotFound, FileNotFoundError))
        self.assertTrue(issubclass(palpate.FileReadError, OSError))
        self.assertTrue(issubclass(palpate.OutOfMemory, MemoryError))


class ProvokedTest(unittest.TestCase):
    def expect(self, error, sentence, function, *arguments, **options):
        with self.assertRaisesRegex(error, sentence) as caught:
            function(*arguments, **options)
        self.assertIs(type(caught.exception), error)

    def test_invalid_argument(self):
        for cutoff in (math.nan, -1.0, 0.0, math.inf):
            self.expect(palpate.InvalidArgument, "cutoff", palpate.query, box(), box(), IDENTITY, cutoff)
        self.expect(palpate.InvalidArgument, "position", palpate.query, box(), box(), (math.nan, 0, 0, 0, 0, 0, 1), 1.0)
        self.expect(palpate.InvalidArgument, "stiffness", palpate.query, box(), box(), IDENTITY, 1.0, stiffness=-1.0)
        self.expect(palpate.InvalidArgument, "indices|vertex", palpate.Model.from_arrays, BOX_CORNERS, [[0, 1, 8]])

    def test_invalid_handle(self):
        model = box()
        model.close()
        self.expect(palpate.InvalidHandle, "a ", palpate.query, model, box(), IDENTITY, 1.0)

    def test_file_not_found(self):
        self.expect(palpate.FileNotFound, "nowhere.glb", palpate.Model.load, "nowhere.glb")

    def test_file_read(self):
        with tempfile.TemporaryDirectory() as folder:
            self.expect(palpate.FileReadError, ".", palpate.Model.load, folder)

    def test_bad_format(self):
        self.expect(palpate.BadFormat, ".", palpate.Model.from_bytes, b"this is not glTF")

    def test_unsupported(self):
        document = gltf(extensionsUsed=["EXT_of_nobody"], extensionsRequired=["EXT_of_nobody"])
        self.expect(palpate.Unsupported, "EXT_of_nobody", palpate.Model.from_bytes, document)

    def test_no_triangles(self):
        self.expect(palpate.NoTriangles, ".", palpate.Model.from_arrays, [[0, 0, 0]] * 3)

    def test_non_finite(self):
        self.expect(palpate.NonFinite, ".", palpate.Model.from_arrays, [[0, 0, 0], [1, 0, 0], [0, math.nan, 0]])

    def test_limit(self):
        self.expect(palpate.LimitExceeded, ".", palpate.Model.from_bytes, gltf(), max_triangles=11)

    def test_unsafe_path(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "box.gltf")
            path.write_bytes(gltf(uri="../outside.bin"))
            self.expect(palpate.UnsafePath, "outside", palpate.Model.load, path)
