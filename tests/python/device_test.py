"""Devices: listed, opened, armed, and felt through a scene."""

import os
import unittest

import palpate
from shapes import IDENTITY, beside, box


class DeviceTest(unittest.TestCase):
    def test_simulated_devices_are_always_there(self):
        uris = [info.uri for info in palpate.devices()]
        self.assertIn("sim:premium6dof", uris)
        self.assertIn("sim:touch", uris)
        with palpate.Device("sim:touch") as device:
            self.assertEqual(device.info.max_torque, 0.0)
            self.assertGreater(device.info.max_force, 1.0)
            self.assertEqual(device.info.actuated, 0b000111)
        with self.assertRaises(palpate.InvalidHandle):
            device.arm()

    def test_what_is_missing_is_listed(self):
        os.environ["PALPATE_OPENHAPTICS_LIBRARY"] = "/nonexistent/libHD.so"
        try:
            listed = {info.uri: info for info in palpate.devices()}["openhaptics:Default Device"]
        finally:
            del os.environ["PALPATE_OPENHAPTICS_LIBRARY"]
        self.assertEqual(listed.condition, palpate.Condition.NO_LIBRARY)
        self.assertIn("install OpenHaptics", listed.status)
        with palpate.Device() as device:
            self.assertEqual(device.info.condition, palpate.Condition.READY)
            self.assertEqual(device.state.condition, palpate.Condition.READY)
            self.assertEqual(device.state.temperature, 0.0)
            with self.assertRaises(palpate.Unsupported):
                device.calibrate()

    def test_a_device_that_is_none(self):
        with self.assertRaisesRegex(palpate.DeviceError, "sim:"):
            palpate.Device("sim:nothing")

    def test_a_hand_feels_a_wall(self):
        scene = palpate.Scene(0.01, stiffness=150.0, law="springs")
        scene.add(box(), beside(0, -1.005))
        tool = scene.add(box(), IDENTITY, "tool")
        device = palpate.Device()
        self.assertEqual(device.state.safety, palpate.Safety.DISARMED)
        device.set_hand(palpate.HandScript.PRESS, depth=0.002, period=0.1, origin=IDENTITY)
        device.place_in_hand()
        scene.set_device(device)
        for _ in range(20):
            scene.step()
        self.assertEqual(device.state.applied.force, (0.0, 0.0, 0.0), "disarmed")
        device.arm()
        for _ in range(1500):
            scene.step()
        state = device.state
        self.assertEqual(state.safety, palpate.Safety.ARMED)
        self.assertGreater(state.applied.force[1], 0.3, "pushed up")
        self.assertGreater(state.limiter_ticks[palpate.Limiter.RAMP], 100)
        self.assertAlmostEqual(tool.pose.position[1], state.pose.position[1], delta=1e-3)
        device.disarm()
        scene.step()
        self.assertEqual(device.state.applied.force, (0.0, 0.0, 0.0))
        scene.set_device(None)
        with self.assertRaises(palpate.InvalidArgument):
            device.set_limits(max_force=1000.0)
        with self.assertRaises(palpate.InvalidArgument):
            device.set_hand_poses([0.0, 1.0], [IDENTITY])

    def test_a_servo_moves_the_tool_with_the_hand(self):
        scene = palpate.Scene(0.01)
        tool = scene.add(box(), IDENTITY, "tool")
        device = palpate.Device()
        device.set_hand_poses([0.0, 0.05], [IDENTITY, beside(0.02)])
        scene.set_device(device)
        scene.start()
        while device.state.ticks < 400:
            pass
        self.assertGreater(tool.pose.position[0], 0.015)
        with self.assertRaises(palpate.WrongState):
            palpate.Scene(0.01).set_device(device)
        with self.assertRaisesRegex(palpate.InvalidArgument, "torque_lever"):
            scene.set_device(device, torque_lever=(2.0, 0.0, 0.0))
        scene.set_device(device, torque_lever=(0.0, 0.1, 0.0))
        scene.set_device(None)
        scene.stop()
        ticks = device.state.ticks
        scene.step()
        self.assertEqual(device.state.ticks, ticks)


if __name__ == "__main__":
    unittest.main()
