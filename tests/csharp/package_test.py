"""The project file of the NuGet package says what the rest of the project says."""

import re
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
BINDING = PROJECT / "bindings" / "csharp"


class PackageTest(unittest.TestCase):
    def setUp(self):
        self.root = ElementTree.parse(BINDING / "Palpate.csproj").getroot()

    def property(self, name):
        found, = self.root.iter(name)
        return found.text

    def test_its_version_is_the_projects(self):
        version, = re.findall(r"project\(palpate VERSION (\S+)", (PROJECT / "CMakeLists.txt").read_text())
        self.assertEqual(self.property("Version"), version)

    def test_its_library_is_the_one_that_is_imported(self):
        asset, = self.root.iter("None")
        imported, = re.findall(r'const string Library = "(\w+)"', (BINDING / "src" / "Raw.cs").read_text())
        self.assertEqual(asset.get("PackagePath"), "runtimes/linux-x64/native/")
        self.assertEqual(asset.get("Include"), "$(PalpateNative)*.so")
        required, = self.root.iter("Target")
        self.assertIn(f"$(PalpateNative)lib{imported}.so", required.get("Condition"))

    def test_its_folder_is_the_one_that_the_readme_makes(self):
        folder = re.search(r"\)../../(\w+/\w+)/$", self.property("PalpateNative"))[1]
        commands = (PROJECT / "README.md").read_text().splitlines()
        self.assertEqual([line.split()[-1] for line in commands if line.startswith("python3 bindings/bundle/bundle.py")],
                         [folder])

    def test_it_is_compiled_as_the_tests_compile_it(self):
        self.assertEqual(self.property("LangVersion"), "7.2")
        self.assertIn('"-langversion:7.2"', (PROJECT / "tests" / "csharp" / "run.py").read_text())
        self.assertEqual(self.property("TargetFramework"), "netstandard2.1")


if __name__ == "__main__":
    unittest.main()
