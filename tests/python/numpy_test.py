"""What numpy is given without a copy, and what is taken from it without one."""

import unittest

import numpy

import palpate
from palpate import _raw
from palpate._errors import check
from palpate._triangles import index_rows, position_rows
from palpate.contacts import new_contacts_struct
from shapes import BOX_CORNERS, BOX_TRIANGLES, beside, box


class ContactsTest(unittest.TestCase):
    def setUp(self):
        self.result = palpate.QueryResult()
        self.contacts = palpate.query(box(), box(), beside(1.1), 0.2, result=self.result)

    def test_the_array_is_the_librarys_memory(self):
        struct = new_contacts_struct()
        check(_raw.plp_query_result_get(self.result._handle, struct))
        array = self.contacts.contacts
        self.assertEqual(array.ctypes.data, struct.lmds)
        self.assertEqual(array.strides, (struct.lmd_stride,))
        self.assertTrue(numpy.shares_memory(array, self.contacts.contacts))
        self.assertFalse(numpy.shares_memory(array, self.contacts.copy().contacts))

    def test_columns(self):
        array = self.contacts.contacts
        self.assertEqual(array["point_a"].shape, (4, 3))
        self.assertEqual(array["point_a"].dtype, numpy.float64)
        self.assertEqual(array.dtype.names, tuple(field[0] for field in _raw.plp_lmd._fields_))
        numpy.testing.assert_allclose(array["point_b"] - array["point_a"],
                                      array["normal"] * array["distance"][:, None], atol=1e-12)
        numpy.testing.assert_allclose(array["force"].sum(axis=0), self.contacts.wrench.force)

    def test_it_is_read_only(self):
        with self.assertRaises(ValueError):
            self.contacts.contacts["distance"] = 0

    def test_an_empty_outcome_has_the_same_fields(self):
        none = palpate.query(box(), box(), beside(9), 0.2).contacts
        self.assertEqual(none.dtype, self.contacts.contacts.dtype)


class InputTest(unittest.TestCase):
    def assert_in_place(self, rows, array):
        self.assertEqual(rows.address.value, array.ctypes.data)
        self.assertEqual(rows.stride, array.strides[0])

    def test_suitable_layouts_are_read_in_place(self):
        interleaved = numpy.zeros((8, 6), numpy.float32)
        interleaved[:, :3] = BOX_CORNERS
        interleaved.flags.writeable = False
        for positions in (interleaved[:, :3], numpy.array(BOX_CORNERS), interleaved[::2, :3]):
            self.assert_in_place(position_rows(positions), positions)
        for kind in (numpy.uint8, numpy.uint16, numpy.uint32):
            indices = numpy.zeros((12, 4), kind)[:, 1:]
            self.assert_in_place(index_rows(indices), indices)

    def test_other_layouts_give_the_same_model(self):
        corners, triangles = numpy.array(BOX_CORNERS), numpy.array(BOX_TRIANGLES)
        apart = numpy.full((8, 6), 9.0)
        apart[:, ::2] = corners
        layouts = [(corners[::-1], 7 - triangles), (numpy.asfortranarray(corners), triangles),
                   (corners.astype(">f4"), triangles.astype(">u2")), (corners.astype(numpy.float16), triangles),
                   ((2 * corners).astype(int), triangles.astype(numpy.uint64)),
                   (apart[:, ::2], numpy.asfortranarray(triangles.astype(numpy.uint8)))]
        for positions, indices in layouts:
            info = palpate.Model.from_arrays(positions, indices).info
            self.assertEqual((info.source.vertices, info.source.watertight), (8, True))

    def test_strided_input_gives_the_contacts_of_the_packed(self):
        interleaved = numpy.full((8, 5), 9.0)
        interleaved[:, 1:4] = BOX_CORNERS
        indices = numpy.full((12, 7), 200, numpy.uint8)
        indices[:, 2:5] = BOX_TRIANGLES
        model = palpate.Model.from_arrays(interleaved[:, 1:4], indices[:, 2:5])
        found = palpate.query(model, box(), beside(1.1), 0.2).contacts
        numpy.testing.assert_array_equal(found, palpate.query(box(), box(), beside(1.1), 0.2).contacts)

    def test_types_that_are_no_numbers_are_refused(self):
        for positions in (numpy.zeros((3, 3), complex), numpy.array([["a", "b", "c"]]), numpy.zeros((3, 4))):
            with self.assertRaisesRegex(palpate.InvalidArgument, "positions"):
                palpate.Model.from_arrays(positions)

    def test_poses_from_arrays(self):
        matrix = numpy.eye(4, dtype=numpy.float32)
        matrix[0, 3] = 1.125
        for pose in (matrix, numpy.array(beside(1.125))):
            self.assertAlmostEqual(palpate.query(box(), box(), pose, 0.2).min_distance, 0.125, delta=1e-9)
