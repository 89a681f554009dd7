"""One scene in the spaces of several engines, against the numbers that the C interface is held to as well."""

import json
import unittest
from pathlib import Path

import palpate

VECTORS = json.loads((Path(__file__).resolve().parents[1] / "golden" / "space_vectors.json").read_text())


def model_of(body, space):
    """The winding is trusted, so that a wrong one is not repaired."""
    return palpate.Model.from_arrays(body["vertices"], body["triangles"], space=space, keep_winding=True)


class SpaceTest(unittest.TestCase):
    def assert_vectors_near(self, actual, expected, tolerance):
        for number, other in zip(actual, expected, strict=True):
            self.assertAlmostEqual(number, other, delta=tolerance)

    def test_every_engine_feels_the_same(self):
        for told in VECTORS["spaces"]:
            with self.subTest(told["name"]):
                space = palpate.Space(tuple(told["axes"]), told["metres_per_unit"])
                scene = palpate.Scene(told["cutoff"], VECTORS["stiffness"], space, law="springs")
                for part, kind in (("body", "static"), ("tool", "tool")):
                    model = model_of(told[part], space)
                    self.assertEqual(model.info.searched.orientation, palpate.Orientation.OUTWARD)
                    body = scene.add(model, palpate.Pose(told[part]["position"], told[part]["orientation"]), kind)
                contacts = scene.step()
                self.assertAlmostEqual(contacts.min_distance, told["distance"], delta=1e-5 * told["cutoff"])
                self.assert_vectors_near(contacts.wrench.force, told["force"], 1e-3)
                self.assert_vectors_near(contacts.wrench.torque, told["torque"], 1e-3)
                self.assert_vectors_near(body.pose.position, told["tool"]["position"], 1e-9)
