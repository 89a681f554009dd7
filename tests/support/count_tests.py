"""count_tests.py REPORT...: prints "passed failed skipped" summed over JUnit reports of ctest.

A report that is missing or not readable counts as one failure: something ended before it could tell."""

import sys
import xml.etree.ElementTree as ElementTree

PASSED, FAILED, SKIPPED = range(3)


def outcome(case):
    """ctest says run or fail; notrun is a skip only if it says why, for a missing program is notrun, too."""
    if case.get("status") == "run":
        return PASSED
    if case.get("status") == "disabled":
        return SKIPPED
    skipped = case.find("skipped")
    if skipped is not None and skipped.get("message", "").startswith("SKIP_"):
        return SKIPPED
    return FAILED


def count(report):
    counts = [0, 0, 0]
    try:
        for case in ElementTree.parse(report).getroot().iter("testcase"):
            counts[outcome(case)] += 1
    except (OSError, ElementTree.ParseError):
        counts[FAILED] += 1
    return counts


if __name__ == "__main__":
    print(*map(sum, zip(*map(count, sys.argv[1:]))))
