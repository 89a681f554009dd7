"""Poses in all the forms in which callers have them."""

import math
import unittest

import palpate
from palpate.pose import pose_of, pose_struct

# A third about (1, 1, 1) takes x to y, y to z and z to x.
THIRD = (0.5, 0.5, 0.5, 0.5)
THIRD_MATRIX = [[0, 0, 1, 1], [1, 0, 0, 2], [0, 1, 0, 3], [0, 0, 0, 1]]


def rotation_matrix(q):
    x, y, z, w = q
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0],
            [0, 0, 0, 1]]


class PoseTest(unittest.TestCase):
    def test_all_forms_are_the_same_pose(self):
        pose = palpate.Pose((1.0, 2.0, 3.0), THIRD)
        for form in (pose, (1, 2, 3, *THIRD), [1, 2, 3, *THIRD], THIRD_MATRIX):
            self.assertEqual(pose_of(pose_struct(form)), pose, form)

    def test_default_is_the_identity(self):
        self.assertEqual(palpate.Pose(), palpate.Pose((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)))

    def test_a_matrix_gives_its_rotation_whichever_number_is_largest(self):
        for q in ((0.9, 0.3, 0.2, 0.1), (0.1, -0.9, 0.3, 0.2), (0.2, 0.1, 0.9, -0.3), (0.3, 0.2, 0.1, 0.9),
                  (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0)):
            length = math.hypot(*q)
            q = [value / length for value in q]
            found = palpate.Pose.from_matrix(rotation_matrix(q)).orientation
            # q and -q are the same rotation.
            sign = math.copysign(1, sum(a * b for a, b in zip(q, found)))
            for a, b in zip(q, found):
                self.assertAlmostEqual(a, sign * b, places=14)

    def test_what_is_not_rigid_is_refused(self):
        scaled = [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]
        mirrored = [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
        sheared = [[1, 0.1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
        transposed = [list(column) for column in zip(*THIRD_MATRIX)]
        not_a_number = [[math.nan, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
        for matrix in (scaled, mirrored, sheared, transposed, not_a_number):
            with self.assertRaisesRegex(palpate.InvalidArgument, "rigid"):
                palpate.Pose.from_matrix(matrix)

    def test_other_shapes_are_refused(self):
        for form in ((), (1, 2, 3), (0,) * 8, [[1, 0, 0]] * 4, [[1, 0, 0, 0]] * 3):
            with self.assertRaises(palpate.InvalidArgument):
                pose_struct(form)
        with self.assertRaises(palpate.InvalidArgument):
            pose_struct(palpate.Pose((0, 0), THIRD))
