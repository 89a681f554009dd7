"""Scenes: bodies, their poses, and what the tool feels."""

import math
import time
import unittest

import palpate
from shapes import beside, box


class SceneTest(unittest.TestCase):
    def setUp(self):
        self.scene = palpate.Scene(0.2, law="springs")
        self.wall = self.scene.add(box())
        self.tool = self.scene.add(box(), beside(1.1), "tool")

    def test_a_step_finds_what_a_query_finds(self):
        contacts = self.scene.step()
        found = palpate.query(box(), box(), beside(1.1), 0.2)
        self.assertEqual(contacts.set_count, found.set_count)
        self.assertEqual(contacts.wrench, found.wrench)
        self.assertEqual([tuple(contact["point_b"]) for contact in contacts.contacts],
                         [tuple(contact["point_b"]) for contact in found.contacts])
        for contact in contacts.contacts:
            self.assertEqual((contact["body_a"], contact["body_b"]), (self.wall.id, self.tool.id))

    def test_poses_are_read_and_set(self):
        self.assertEqual(self.tool.pose, palpate.Pose((1.1, 0.0, 0.0)))
        self.tool.pose = beside(1.05)
        self.assertAlmostEqual(self.scene.step().min_distance, 0.05, delta=1e-9)
        self.wall.pose = palpate.Pose((-0.1, 0.0, 0.0))
        self.assertAlmostEqual(self.scene.step().min_distance, 0.15, delta=1e-9)
        with self.assertRaises(palpate.InvalidArgument):
            self.tool.pose = (math.nan, 0, 0, 0, 0, 0, 1)
        self.assertEqual(self.tool.pose, palpate.Pose((1.05, 0.0, 0.0)))

    def test_cutoff_and_stiffness(self):
        self.assertEqual((self.scene.cutoff, self.scene.stiffness), (0.2, 1000.0))
        self.scene.cutoff, self.scene.stiffness = 0.3, 50.0
        self.assertEqual((self.scene.cutoff, self.scene.stiffness), (0.3, 50.0))
        self.assertAlmostEqual(self.scene.step().wrench.force[0], 50 * (0.3 - 0.1), delta=1e-6)
        for wrong in (math.nan, -1.0):
            with self.assertRaises(palpate.InvalidArgument):
                self.scene.cutoff = wrong
            with self.assertRaises(palpate.InvalidArgument):
                self.scene.stiffness = wrong
        self.assertEqual((self.scene.cutoff, self.scene.stiffness), (0.3, 50.0))

    def test_every_mode_feels_the_same(self):
        forces = {}
        for mode in ("global", "descent", "certified"):
            self.scene.mode = mode
            self.assertEqual(self.scene.mode, mode)
            forces[mode] = []
            for step in range(20):
                self.tool.pose = beside(1.1 - 0.002 * step)
                forces[mode].append(self.scene.step().wrench.force)
        self.assertEqual(forces["certified"], forces["global"])
        for one, other in zip(forces["descent"], forces["global"]):
            self.assertAlmostEqual(one[0], other[0], delta=1e-9)
        with self.assertRaises(palpate.InvalidArgument):
            self.scene.mode = "telepathic"
        with self.assertRaises(palpate.InvalidArgument):
            palpate.Scene(0.2, mode="telepathic")
        with self.assertRaises(palpate.InvalidArgument):
            palpate.Scene(0.2, law="telepathic")
        self.assertEqual(self.scene.mode, "certified")

    def test_a_body_has_its_own_stiffness(self):
        self.wall.remove()
        self.scene.add(box(), kind="moving", stiffness=10.0)
        self.assertAlmostEqual(self.scene.step().wrench.force[0], 10 * (0.2 - 0.1), delta=1e-9)

    def test_damping_friction_and_cap(self):
        scene = palpate.Scene(0.2, law="springs", damping=30.0, friction=0.1, stiffness_cap=400.0)
        scene.add(box())
        tool = scene.add(box(), beside(1.102, -0.002), "tool")
        self.assertEqual((scene.damping, scene.friction, scene.stiffness_cap), (30.0, 0.1, 400.0))
        scene.step()
        tool.pose = beside(1.1)
        contacts = scene.step()
        pressed = (1000 * 0.1 + 30 * 0.002 / 0.001) / (1 + 2 * 1000 / 400)
        self.assertAlmostEqual(contacts.wrench.force[0], pressed, delta=1e-6)
        self.assertAlmostEqual(contacts.wrench.force[1], -0.1 * pressed, delta=1e-6)
        self.assertAlmostEqual(sum(spring["force"][0] for spring in contacts.springs), pressed, delta=1e-6)
        self.assertFalse(contacts.walled)
        scene.damping = scene.friction = scene.stiffness_cap = 0.0
        tool.pose = beside(1.09)
        self.assertAlmostEqual(scene.step().wrench.force[0], 110, delta=1e-6)
        for name, wrong in (("damping", -1.0), ("friction", -1.0), ("stiffness_cap", float("nan"))):
            with self.assertRaises(palpate.InvalidArgument):
                setattr(scene, name, wrong)
            self.assertEqual(getattr(scene, name), 0.0)

    def test_a_body_has_its_own_material(self):
        self.wall.remove()
        self.scene.add(box(), damping=10.0, friction=-1.0)
        self.scene.friction = 0.5
        self.scene.step()
        self.tool.pose = beside(1.095, 0.001)
        force = self.scene.step().wrench.force
        self.assertAlmostEqual(force[0], 105 + 10 * 0.005 / 0.001, delta=1e-6)
        self.assertAlmostEqual(force[1], 0, delta=1e-9)

    def test_a_wall_holds_the_tool_inside(self):
        self.tool.pose = beside(1.01)
        self.assertFalse(self.scene.step().walled)
        self.tool.pose = beside(0.99)
        contacts = self.scene.step()
        self.assertTrue(contacts.overlap and contacts.walled)
        self.assertAlmostEqual(contacts.wrench.force[0], 1000 * (0.2 + 0.01), delta=1e-3)
        self.assertAlmostEqual(sum(spring["weight"] for spring in contacts.springs), 1, delta=1e-9)

    def test_a_removed_body_is_gone(self):
        self.wall.remove()
        self.assertEqual(self.scene.step().set_count, 0)
        for use in (self.wall.remove, lambda: self.wall.pose):
            with self.assertRaises(palpate.InvalidHandle):
                use()

    def test_there_is_one_tool(self):
        with self.assertRaises(palpate.InvalidArgument):
            self.scene.add(box(), kind="tool")
        with self.assertRaisesRegex(palpate.InvalidArgument, "hammer"):
            self.scene.add(box(), kind="hammer")

    def test_torque_is_about_the_tools_reference_point(self):
        self.tool.remove()
        self.scene.add(box(), beside(1.1, 0.25), "tool", reference_point=(0, 1, 0))
        # The force of 100 N along x acts at y = -0.125 of the tool, which is 1.125 below the point.
        self.assertAlmostEqual(self.scene.step().wrench.torque[2], 112.5, delta=1e-6)

    def test_another_space(self):
        millimetres_z_up = palpate.Space((1, -3, 2), metres_per_unit=0.001)
        scene = palpate.Scene(200.0, space=millimetres_z_up, law="springs")
        scene.add(box())
        tool = scene.add(box(), beside(0, 0, 1100), "tool")
        contacts = scene.step()
        self.assertAlmostEqual(contacts.min_distance, 100, delta=1e-6)
        self.assertAlmostEqual(contacts.wrench.force[2], 100, delta=1e-6)
        self.assertAlmostEqual(contacts.contacts[0]["normal"][2], 1, delta=1e-9)
        self.assertAlmostEqual(tool.pose.position[2], 1100, delta=1e-9)

    def test_the_next_step_overwrites_the_last_outcome(self):
        first = self.scene.step()
        kept = first.copy()
        self.tool.pose = beside(1.05)
        self.scene.step()
        with self.assertRaises(palpate.InvalidHandle):
            first.contacts
        self.assertAlmostEqual(first.min_distance, 0.1, delta=1e-9)
        self.assertAlmostEqual(kept.contacts[0]["distance"], 0.1, delta=1e-9)

    def test_contacts_outlive_a_closed_scene(self):
        with self.scene as scene:
            records = scene.step().contacts
        self.assertAlmostEqual(records[0]["distance"], 0.1, delta=1e-9)
        for use in (scene.step, lambda: self.tool.pose, lambda: scene.add(box())):
            with self.assertRaises(palpate.InvalidHandle):
                use()
        scene.close()

    def test_a_scene_keeps_its_models(self):
        with box() as model:
            body = self.scene.add(model, beside(1.1, 1.1))
        self.assertGreater(self.scene.step().set_count, 1)
        self.assertNotEqual(body.id, 0)

    def test_a_servo_steps_the_scene(self):
        expected = self.scene.step().wrench
        self.assertFalse(self.scene.servo.running)
        self.scene.start(rate=500, priority=None)
        self.addCleanup(self.scene.stop)
        with self.assertRaises(palpate.WrongState):
            self.scene.step()
        with self.assertRaises(palpate.WrongState):
            self.scene.start()
        while self.scene.servo.ticks < 3:
            time.sleep(0.001)
        self.assertEqual(self.scene.contacts().wrench, expected)
        self.assertEqual(self.scene.contacts().status, 0)
        state = self.scene.servo
        self.assertTrue(state.running)
        self.assertEqual((state.wanted_rate, state.priority, state.cpu), (500.0, None, None))
        self.assertGreater(state.work.max, 0.0)
        self.tool.pose = beside(1.05)
        while abs(self.scene.contacts().min_distance - 0.05) > 1e-9:
            time.sleep(0.001)
        palpate.shutdown_all()
        self.assertFalse(self.scene.servo.running)
        self.assertAlmostEqual(self.scene.step().min_distance, 0.05, delta=1e-9)
        for wrong in ({"rate": -1.0}, {"rate": math.nan}, {"priority": 100}, {"cpu": 5000}):
            with self.assertRaises(palpate.InvalidArgument):
                self.scene.start(**wrong)
