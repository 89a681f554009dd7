"""What must not be done: an exception or an error code each time, and no crash."""

import ctypes
import math
import tempfile
import threading
import unittest
from ctypes import byref, sizeof
from pathlib import Path

import palpate
from palpate import _raw
from shapes import IDENTITY, beside, box

LONGER = 8  # bytes, as a later version might append


def scene_of_two():
    scene = palpate.Scene(0.2)
    scene.add(box())
    return scene, scene.add(box(), beside(1.1), "tool")


def recorded(folder):
    path = Path(folder, "a.trace")
    scene, _ = scene_of_two()
    with scene:
        scene.record(path)
        scene.step()
    return palpate.Trace(path)


class MisuseTest(unittest.TestCase):
    def test_use_after_close_and_closing_twice(self):
        scene, tool = scene_of_two()
        model, device = box(), palpate.Device("sim:premium6dof")
        with tempfile.TemporaryDirectory() as folder:
            trace = recorded(folder)
            for closed in (scene, model, device, trace):
                closed.close()
                closed.close()
        uses = (scene.step, scene.contacts, scene.start, scene.stop, lambda: scene.bodies, lambda: scene.add(box()),
                lambda: scene.record("a"), lambda: tool.pose, tool.remove, lambda: setattr(tool, "pose", IDENTITY),
                lambda: model.info, lambda: palpate.query(model, box(), IDENTITY, 1.0), device.arm, lambda: device.state,
                lambda: trace[0], lambda: trace.bodies)
        for i, use in enumerate(uses):
            with self.subTest(use=i), self.assertRaises(palpate.InvalidHandle):
                use()

    def test_handles_of_another_kind(self):
        scene, tool = scene_of_two()
        with scene, box() as model, palpate.Device("sim:premium6dof") as device:
            calls = ((_raw.plp_scene_step, model), (_raw.plp_scene_release, device), (_raw.plp_model_prepare, scene),
                     (_raw.plp_model_release, scene), (_raw.plp_device_arm, model), (_raw.plp_trace_release, scene),
                     (_raw.plp_query_result_release, model))
            for function, wrong in calls:
                self.assertEqual(function(wrong._handle), _raw.PLP_ERROR_INVALID_HANDLE, function)
            self.assertEqual(scene.step().set_count, 1, "nothing was released")
            for function, _ in calls:
                for handle in (None, 0x1234):
                    expected = _raw.PLP_OK if handle is None and "release" in function.__name__ else \
                        _raw.PLP_ERROR_INVALID_HANDLE
                    self.assertEqual(function(handle), expected, (function.__name__, handle))
            with self.assertRaises(palpate.InvalidHandle):
                scene.add(scene)
            with palpate.Scene(0.2) as other, self.assertRaises(palpate.InvalidHandle):
                palpate.scene.Body(other, tool.id).remove()

    def test_nothing_where_something_is_needed(self):
        self.assertEqual(_raw.plp_scene_create(None, None), _raw.PLP_ERROR_INVALID_ARGUMENT)
        for wrong in (lambda: palpate.Model.load(None), lambda: palpate.Scene(None), lambda: palpate.Trace(None),
                      lambda: palpate.query(None, box(), IDENTITY, 1.0)):
            with self.assertRaises((TypeError, AttributeError)):
                wrong()

    def test_numbers_that_are_none(self):
        scene, tool = scene_of_two()
        with scene:
            for bad in (math.nan, math.inf, -math.inf):
                for name in ("cutoff", "stiffness", "damping", "friction"):
                    with self.subTest(name=name, bad=bad), self.assertRaises(palpate.InvalidArgument):
                        setattr(scene, name, bad)
                for place in range(7):
                    numbers = list(IDENTITY)
                    numbers[place] = bad
                    with self.assertRaises(palpate.InvalidArgument):
                        tool.pose = numbers
            self.assertEqual(tool.pose.position, (1.1, 0.0, 0.0))
            self.assertEqual(scene.step().set_count, 1)

    def test_structs_of_other_versions(self):
        class Later(ctypes.Structure):
            _fields_ = [("now", _raw.plp_scene_options), ("tail", ctypes.c_uint8 * LONGER)]

        later = Later()
        known = ctypes.cast(byref(later), ctypes.POINTER(_raw.plp_scene_options))
        handle = _raw._handle()

        def created(size):
            _raw.plp_scene_options_init(known, sizeof(_raw.plp_scene_options))
            known.contents.cutoff = 1.0
            known.contents.struct_size = size
            return _raw.plp_scene_create(known, byref(handle))

        self.assertEqual(created(sizeof(Later)), _raw.PLP_OK, "a tail of zeros means what it meant")
        self.assertEqual(_raw.plp_scene_release(handle), _raw.PLP_OK)
        for set_byte in range(LONGER):
            later.tail[set_byte] = 1
            self.assertEqual(created(sizeof(Later)), _raw.PLP_ERROR_INVALID_ARGUMENT, set_byte)
            later.tail[set_byte] = 0
        for size in (0, 3, 55, 2**32 - 1):
            self.assertEqual(created(size), _raw.PLP_ERROR_INVALID_ARGUMENT, size)

    def test_threads(self):
        scene, tool = scene_of_two()
        outcomes = []

        def elsewhere():
            try:
                outcomes.append(scene.step().set_count)
            except palpate.PalpateError as error:
                outcomes.append(type(error))

        def run():
            thread = threading.Thread(target=elsewhere)
            thread.start()
            thread.join()

        run()  # any thread may step, one at a time
        scene.start()
        run()  # none, while a servo does
        scene.close()
        run()
        self.assertEqual(outcomes, [1, palpate.WrongState, palpate.InvalidHandle])

    def test_closing_while_another_thread_steps(self):
        for _ in range(20):
            scene, _ = scene_of_two()
            steps = []

            def work():
                try:
                    while True:
                        steps.append(scene.step().set_count)
                except palpate.InvalidHandle:
                    pass

            thread = threading.Thread(target=work)
            thread.start()
            while not steps:
                pass
            scene.close()
            thread.join()
            self.assertEqual(set(steps), {1})
