"""The analysis looks at everything, leaves nothing out without a reason, and finds what is planted."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import units

ROOT = Path(__file__).resolve().parents[2]
SOURCE = """\
namespace palpate {
namespace {

constexpr double kSlack = 1e-3;  // m
using Row = std::array<double, 3>;

struct Probe {
  int index = 0;
};

template <class T>
std::vector<T> gathered(const Row& row, int count) {
  const int doubled = 2 * count;
  return {};
}

}  // namespace

void shared(int count) {}

}  // namespace palpate
"""
PLANTED = """\
struct Text {
  Text(Text&& other) noexcept : length(other.length) { other.length = nullptr; }
  int* length;
};
int broken(int* given) {
  if (!given) return *given;
  return 0;
}
"""


class Units(unittest.TestCase):
    def test_own_names(self):
        self.assertEqual(units.own_names(SOURCE), {"kSlack", "Row", "Probe", "gathered"})

    def test_sources_with_one_name_are_apart(self):
        with tempfile.TemporaryDirectory() as folder:
            sources = [Path(folder) / f"{name}.cpp" for name in "abc"]
            for source, text in zip(sources, (SOURCE, SOURCE, SOURCE.replace("kSlack", "kA").replace("Row", "B")
                                              .replace("Probe", "C").replace("gathered", "d"))):
                source.write_text(text)
            found = units._units_of_part("engine", [(source, []) for source in sources])
        self.assertEqual([[source.name for source in unit.sources] for unit in found],
                         [["a.cpp", "c.cpp"], ["b.cpp"]])


    def test_a_source_with_a_name_of_a_header_is_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "row.h").write_text("inline std::vector<int> gathered(int count) {\n")
            sources = [Path(folder) / f"{name}.cpp" for name in "ab"]
            for source, text in zip(sources, (SOURCE, "")):
                source.write_text(text)
            shared = units.shared_names(Path(folder))
            found = units._units_of_part("engine", [(source, []) for source in sources], shared)
        self.assertEqual(shared, {"gathered"})
        self.assertEqual(len(found), 2)


class Reasons(unittest.TestCase):
    def test_clang_tidy(self):
        text = (ROOT / ".clang-tidy").read_text()
        left_out = re.findall(r"^  -([\w.-]+),?$", text, re.MULTILINE)
        self.assertTrue(left_out)
        for check in left_out:
            self.assertRegex(text, rf"(?m)^#   {re.escape(check)}  +\S")

    def test_cppcheck(self):
        reason = False
        for line in (ROOT / "tests" / "analysis" / "cppcheck.txt").read_text().splitlines()[1:]:
            self.assertTrue(reason or not line or line.startswith("//"), f"{line} has no reason")
            reason = line.startswith("//")


class Findings(unittest.TestCase):
    def expect_found(self, program, command, said):
        if not shutil.which(program):
            self.skipTest(f"{program} is not installed")
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "engine" / "planted.cpp"
            source.parent.mkdir()
            source.write_text(PLANTED)
            done = subprocess.run([program, *command, str(source), *(["--"] if "tidy" in program else [])],
                                  capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(said, done.stdout + done.stderr)

    def test_clang_tidy(self):
        self.expect_found("clang-tidy-14", ["--quiet", f"--config-file={ROOT / '.clang-tidy'}"],
                          "Dereference of null pointer")

    def test_cppcheck(self):
        self.expect_found("cppcheck", ["--quiet", "--enable=warning", "--error-exitcode=1"], "nullPointer")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
