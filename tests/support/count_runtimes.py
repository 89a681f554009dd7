"""count_runtimes.py REPORT: what the tests of a JUnit report of ctest say of the runtimes that they ran under.

A test prints "RUNTIME: N passed, N failed" or "RUNTIME: skipped: WHY"; the counts of one runtime are added up."""

import re
import sys
import xml.etree.ElementTree as ElementTree

COUNT = re.compile(r"^([^:\n]+): (\d+) passed, (\d+) failed$", re.MULTILINE)
SKIPPED = re.compile(r"^([^:\n]+): skipped: (.+)$", re.MULTILINE)


def summary(outputs):
    counts, skipped = {}, {}
    for output in outputs:
        for runtime, passed, failed in COUNT.findall(output):
            before = counts.get(runtime, (0, 0))
            counts[runtime] = (before[0] + int(passed), before[1] + int(failed))
        skipped.update(SKIPPED.findall(output))
    return ([f"{runtime}: {passed} passed, {failed} failed" for runtime, (passed, failed) in sorted(counts.items())]
            + [f"{runtime}: skipped: {why}" for runtime, why in sorted(skipped.items())])


def outputs(report):
    """Of each test; none if there is no report, which is counted elsewhere."""
    try:
        return [output.text or "" for output in ElementTree.parse(report).getroot().iter("system-out")]
    except (OSError, ElementTree.ParseError):
        return []


if __name__ == "__main__":
    for line in summary(outputs(sys.argv[1])):
        print(line)
