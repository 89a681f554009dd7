"""The counts of each runtime are added up, and one that is missing is named."""

import tempfile
import unittest
from pathlib import Path

import count_runtimes


class CountRuntimes(unittest.TestCase):
    def test_counts_are_added_up(self):
        self.assertEqual(count_runtimes.summary(["noise\nA: 2 passed, 0 failed\nB b: 1 passed, 1 failed\n",
                                                 "A: 3 passed, 1 failed\nnoise: 4 passed", ""]),
                         ["A: 5 passed, 1 failed", "B b: 1 passed, 1 failed"])

    def test_what_is_missing_is_named(self):
        self.assertEqual(count_runtimes.summary(["A: 1 passed, 0 failed", "C: skipped: it is not there (why: so)"]),
                         ["A: 1 passed, 0 failed", "C: skipped: it is not there (why: so)"])

    def test_a_report_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            report = Path(folder, "tests.xml")
            report.write_text("<testsuite>"
                              "<testcase name='a'><system-out>A: 1 passed, 0 failed\nx</system-out></testcase>"
                              "<testcase name='b'><system-out/></testcase></testsuite>")
            self.assertEqual(count_runtimes.outputs(report), ["A: 1 passed, 0 failed\nx", ""])
            self.assertEqual(count_runtimes.outputs(Path(folder, "none.xml")), [])


if __name__ == "__main__":
    unittest.main()
