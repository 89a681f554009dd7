"""The receiver of log messages."""

import threading
import unittest

import palpate
from shapes import box


class LogTest(unittest.TestCase):
    def tearDown(self):
        palpate.set_log_callback(None)

    def test_messages_arrive_until_the_receiver_is_removed(self):
        received = []
        palpate.set_log_callback(lambda level, message: received.append((level, message)))
        box()
        self.assertIn("12 triangles", " ".join(message for _, message in received))
        self.assertTrue(all(isinstance(level, palpate.LogLevel) for level, _ in received))
        count = len(received)
        palpate.set_log_callback(None)
        box()
        self.assertEqual(len(received), count)

    def test_there_is_one_receiver(self):
        first, second = [], []
        palpate.set_log_callback(lambda *message: first.append(message))
        palpate.set_log_callback(lambda *message: second.append(message))
        box()
        self.assertEqual(first, [])
        self.assertNotEqual(second, [])

    def test_receivers_change_while_other_threads_log(self):
        received = []
        threads = [threading.Thread(target=lambda: [box() for _ in range(200)]) for _ in range(2)]
        palpate.set_log_callback(lambda *message: received.append(message))
        for thread in threads:
            thread.start()
        while any(thread.is_alive() for thread in threads):
            palpate.set_log_callback(lambda *message: received.append(message))
        self.assertEqual(sum("12 triangles" in message for _, message in received), 400)

    def test_errors_of_threads_are_their_own(self):
        sentences = {}

        def fail(name):
            for _ in range(100):
                with self.assertRaises(palpate.FileNotFound) as caught:
                    palpate.Model.load(name)
                sentences.setdefault(name, set()).add(name in str(caught.exception))

        threads = [threading.Thread(target=fail, args=(f"nowhere_{i}.glb",)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(list(sentences.values()), [{True}] * 4)
