"""Models from files, bytes and arrays."""

import math
import tempfile
import unittest
from array import array
from pathlib import Path

import palpate
from shapes import BOX_CORNERS, BOX_TRIANGLES, beside, box, box_soup, buffer_of_gltf, gltf


class GltfTest(unittest.TestCase):
    def assert_is_box(self, model):
        self.assertEqual(model.info.searched.triangles, 12)
        self.assertEqual(model.info.searched.vertices, 8)
        self.assertTrue(model.info.searched.watertight)

    def test_from_bytes(self):
        for data in (gltf(), bytearray(gltf()), memoryview(gltf())):
            self.assert_is_box(palpate.Model.from_bytes(data))

    def test_from_a_file_with_a_buffer_beside_it(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "böx.gltf")
            path.write_bytes(gltf(uri="box.bin"))
            Path(folder, "box.bin").write_bytes(buffer_of_gltf())
            for form in (path, str(path), bytes(path)):
                self.assert_is_box(palpate.Model.load(form))
            self.assert_is_box(palpate.Model.from_bytes(path.read_bytes(), folder))

    def test_the_scene_is_chosen_by_index(self):
        two = gltf(scenes=[{"nodes": [0]}, {"nodes": [0, 1]}],
                   nodes=[{"mesh": 0}, {"mesh": 0, "translation": [3, 0, 0]}])
        self.assertEqual(palpate.Model.from_bytes(two).info.searched.components, 1)
        self.assertEqual(palpate.Model.from_bytes(two, scene=1).info.searched.components, 2)
        for scene in (2, 2**32):
            with self.assertRaises(palpate.PalpateError):
                palpate.Model.from_bytes(two, scene=scene)

    def test_a_null_character_does_not_cut_a_path(self):
        with self.assertRaises(palpate.InvalidArgument):
            palpate.Model.load("box.glb\0.txt")


class ArraysTest(unittest.TestCase):
    def test_nested_and_flat_sequences(self):
        flat_corners = [number for corner in BOX_CORNERS for number in corner]
        flat_triangles = [corner for triangle in BOX_TRIANGLES for corner in triangle]
        for positions, indices in ((BOX_CORNERS, BOX_TRIANGLES), (flat_corners, flat_triangles),
                                   (array("f", flat_corners), array("H", flat_triangles)),
                                   (memoryview(array("d", flat_corners)), array("B", flat_triangles))):
            self.assertEqual(palpate.Model.from_arrays(positions, indices).info.searched.vertices, 8)

    def test_without_indices_every_three_positions_are_a_triangle(self):
        info = palpate.Model.from_arrays(box_soup()).info
        self.assertEqual((info.source.triangles, info.source.vertices, info.stored_vertices > 0), (12, 8, True))

    def test_the_space_scales_and_mirrors(self):
        space = palpate.Space((-1, 2, 3), metres_per_unit=0.01)
        shifted = [[x + 10, y, z] for x, y, z in BOX_CORNERS]
        mirrored_triangles = [triangle[::-1] for triangle in BOX_TRIANGLES]
        info = palpate.Model.from_arrays(shifted, BOX_TRIANGLES, space=space).info
        self.assertAlmostEqual(info.bounds_min[0], -0.105, delta=1e-9)
        self.assertAlmostEqual(info.bounds_max[0], -0.095, delta=1e-9)
        self.assertEqual(info.source.orientation, palpate.Orientation.OUTWARD)
        kept = palpate.Model.from_arrays(shifted, mirrored_triangles, space=space, keep_winding=True).info
        self.assertEqual(kept.searched.orientation, palpate.Orientation.INWARD)

    def test_a_space_that_is_none_is_refused(self):
        for axes in ((1, 1, 2), (1, 2), (0, 1, 2), (1, 2, 2**32 + 3)):
            with self.assertRaisesRegex(palpate.InvalidArgument, "axes"):
                palpate.Model.from_arrays(box_soup(), space=palpate.Space(axes))

    def test_what_is_not_three_by_three_is_refused(self):
        for positions, indices in (([1.0, 2.0], None), (BOX_CORNERS, [0, 1])):
            with self.assertRaisesRegex(palpate.InvalidArgument, "positions|indices"):
                palpate.Model.from_arrays(positions, indices)

    def test_indices_are_not_cut_to_their_width(self):
        for index in (-1, 2**32, 2**32 + 1):
            with self.assertRaisesRegex(palpate.InvalidArgument, "indices"):
                palpate.Model.from_arrays(BOX_CORNERS, [[0, 1, index]])
        with self.assertRaisesRegex(palpate.InvalidArgument, "integers"):
            palpate.Model.from_arrays(BOX_CORNERS, [[0.0, 1.0, 2.0]])

    def test_options(self):
        self.assertEqual(palpate.Model.from_arrays(box_soup(), double_sided=True).info.double_sided_triangles, 12)
        cracked = box_soup()
        cracked[0] = [cracked[0][0] + 1e-5, *cracked[0][1:]]
        self.assertFalse(palpate.Model.from_arrays(cracked).info.searched.watertight)
        self.assertTrue(palpate.Model.from_arrays(cracked, weld_tolerance=1e-4).info.searched.watertight)


class InfoTest(unittest.TestCase):
    def test_counts_bounds_and_tree(self):
        model = box()
        self.assertEqual(model.info.source, model.info.searched)
        self.assertEqual(model.info.source.edges, 18)
        self.assertEqual(model.info.bounds_max, (0.5, 0.5, 0.5))
        self.assertAlmostEqual(model.info.diagonal, math.sqrt(3), delta=1e-9)
        self.assertEqual(model.info.tree_bytes, 0)
        model.prepare()
        self.assertGreater(model.info.tree_bytes, 0)
        self.assertIn("12 triangles", repr(model))

    def test_bytes_read_and_decoded(self):
        info = palpate.Model.from_bytes(gltf()).info
        self.assertEqual((info.read_bytes, info.decoded_bytes), (len(gltf()), len(buffer_of_gltf())))
        self.assertEqual((box().info.read_bytes, box().info.decoded_bytes), (0, 0))

    def test_scale(self):
        self.assertEqual(palpate.Model.from_bytes(gltf(), scale=3.0).info.bounds_max, (1.5, 1.5, 1.5))
        self.assertEqual(palpate.Model.from_arrays(box_soup(), scale=0.5).info.bounds_min, (-0.25, -0.25, -0.25))
        with self.assertRaises(palpate.InvalidArgument):
            palpate.Model.from_bytes(gltf(), scale=-1.0)

    def test_notes_tell_what_was_repaired(self):
        self.assertEqual(box().notes, ())
        turned = palpate.Model.from_arrays(BOX_CORNERS, [triangle[::-1] for triangle in BOX_TRIANGLES])
        self.assertEqual(turned.info.flipped_components, 1)
        self.assertGreater(len(turned.notes), 0)
        self.assertTrue(all(turned.notes))

    def test_info_does_not_change(self):
        with self.assertRaises(AttributeError):
            box().info.source.triangles = 1


class CloseTest(unittest.TestCase):
    def test_use_after_close(self):
        with box() as model:
            self.assertEqual(model.info.searched.triangles, 12)
        for use in (lambda: model.info, lambda: model.notes, model.prepare,
                    lambda: palpate.query(box(), model, beside(1.1), 0.2)):
            with self.assertRaises(palpate.InvalidHandle):
                use()
        model.close()
        self.assertIn("closed", repr(model))
