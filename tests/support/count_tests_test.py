"""count_tests tells apart what ctest reports alike."""

import tempfile
import unittest
from pathlib import Path

from count_tests import count

REPORT = """<testsuite tests="6" failures="1" disabled="1" skipped="3">
  <testcase name="passed" status="run"/>
  <testcase name="failed" status="fail"><failure message=""/></testcase>
  <testcase name="skipped" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/></testcase>
  <testcase name="skipped by exit code" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/></testcase>
  <testcase name="not built" status="notrun"><skipped message="Unable to find executable"/></testcase>
  <testcase name="disabled" status="disabled"/>
</testsuite>"""


class CountTests(unittest.TestCase):
    def count(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as report:
            report.write(text)
            report.flush()
            return count(report.name)

    def test_program_that_was_not_built_is_a_failure(self):
        self.assertEqual(self.count(REPORT), [1, 2, 3])

    def test_report_cut_short_is_a_failure(self):
        self.assertEqual(self.count(REPORT[:200]), [0, 1, 0])

    def test_missing_report_is_a_failure(self):
        self.assertEqual(count(Path("no such report.xml")), [0, 1, 0])


if __name__ == "__main__":
    unittest.main()
