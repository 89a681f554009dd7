"""Queries whose answers are known."""

import math
import unittest

import palpate
from shapes import BOX_CORNERS, BOX_TRIANGLES, beside, box


class QueryTest(unittest.TestCase):
    def assert_close(self, found, expected):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=1e-9)

    def test_two_unit_boxes_a_tenth_apart(self):
        gap, cutoff, stiffness = 0.1, 0.25, 400.0
        contacts = palpate.query(box(), box(), beside(1 + gap), cutoff, stiffness=stiffness)
        self.assertEqual(contacts.set_count, 1)
        self.assertEqual(len(contacts.contacts), 4)
        self.assertAlmostEqual(sum(contact["weight"] for contact in contacts.contacts), 1, delta=1e-12)
        for contact in contacts.contacts:
            self.assertAlmostEqual(contact["distance"], gap, delta=1e-9)
            self.assert_close(contact["normal"], (1, 0, 0))
            self.assert_close(contact["force"], (stiffness * (cutoff - gap) * contact["weight"], 0, 0))
            self.assertAlmostEqual(contact["point_a"][0], 0.5, delta=1e-9)
            self.assertAlmostEqual(contact["point_b"][0], 0.5 + gap, delta=1e-9)
            self.assertEqual(contact["set"], 0)
        self.assert_close(contacts.wrench.force, (stiffness * (cutoff - gap), 0, 0))
        self.assert_close(contacts.wrench.torque, (0, 0, 0))
        self.assertAlmostEqual(contacts.min_distance, gap, delta=1e-9)
        self.assertFalse(contacts.overlap)
        self.assertGreater(contacts.search_us, 0)
        self.assertGreater(contacts.work.triangle_pairs, 0)

    def test_torque_is_about_the_reference_point(self):
        pose, cutoff = beside(1.1, 0.25), 0.2
        # The faces overlap over y from -0.25 to 0.5; in B's frame its middle is at y = -0.125.
        contacts = palpate.query(box(), box(), pose, cutoff)
        self.assert_close(contacts.wrench.force, (100, 0, 0))
        self.assert_close(contacts.wrench.torque, (0, 0, 12.5))
        contacts = palpate.query(box(), box(), pose, cutoff, reference_point=(0, -0.125, 0))
        self.assert_close(contacts.wrench.torque, (0, 0, 0))

    def test_corners_name_their_vertices(self):
        contacts = palpate.query(box(), box(), beside(1.0625, 1.0625, 1.0625), 0.2)
        contact, = contacts.contacts
        self.assertEqual(contact["feature_a"], palpate.Feature.VERTEX)
        self.assertEqual(contact["feature_b"], palpate.Feature.VERTEX)
        self.assertEqual(BOX_CORNERS[BOX_TRIANGLES[contact["triangle_a"]][contact["corner_a"]]], [0.5, 0.5, 0.5])
        self.assertEqual(BOX_CORNERS[BOX_TRIANGLES[contact["triangle_b"]][contact["corner_b"]]], [-0.5, -0.5, -0.5])
        self.assertAlmostEqual(contact["distance"], 0.0625 * math.sqrt(3), delta=1e-9)

    def test_out_of_reach_there_is_nothing(self):
        contacts = palpate.query(box(), box(), beside(5), 0.2)
        self.assertEqual(len(contacts.contacts), 0)
        self.assertEqual(list(contacts.contacts), [])
        self.assertEqual(contacts.set_count, 0)
        self.assertEqual(contacts.min_distance, math.inf)
        self.assertEqual(contacts.wrench, ((0, 0, 0), (0, 0, 0)))

    def test_overlaps_are_listed_up_to_the_given_number(self):
        contacts = palpate.query(box(), box(), beside(0.5, 0.25, 0.125), 0.2)
        self.assertTrue(contacts.overlap)
        self.assertFalse(contacts.overlaps_cut)
        self.assertGreater(len(contacts.overlaps), 3)
        for overlap in contacts.overlaps:
            self.assertLess(overlap["triangle_a"], 12)
            self.assertLess(overlap["triangle_b"], 12)
        cut = palpate.query(box(), box(), beside(0.5, 0.25, 0.125), 0.2, max_overlaps=3)
        self.assertTrue(cut.overlaps_cut)
        self.assertEqual(len(cut.overlaps), 3)

    def test_numbers_that_do_not_fit_are_refused(self):
        for count in (-1, 2**32):
            with self.assertRaisesRegex(palpate.InvalidArgument, "max_overlaps"):
                palpate.query(box(), box(), beside(1.1), 0.2, max_overlaps=count)
        with self.assertRaisesRegex(palpate.InvalidArgument, "reference_point"):
            palpate.query(box(), box(), beside(1.1), 0.2, reference_point=(0, 0))

    def test_a_closed_result_is_refused(self):
        with palpate.QueryResult() as result:
            palpate.query(box(), box(), beside(1.1), 0.2, result=result)
        with self.assertRaises(palpate.InvalidHandle):
            palpate.query(box(), box(), beside(1.1), 0.2, result=result)
