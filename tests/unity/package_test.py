"""package_test.py LIBRARY: what Unity's package manager and importer need of the package."""

import io
import json
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path, PurePosixPath

ROOT = Path(__file__).resolve().parents[2]
UNITY = ROOT / "bindings" / "unity"
LIBRARY = Path(sys.argv.pop(1)).resolve()
PLUGINS = "Runtime/Plugins/x86_64/"
# In the scenes of users: they are for ever.
GUIDS = {
    "Runtime/HapticBody.cs": "4416596fce65292d0a43d03eb8746fa5",
    "Runtime/HapticDevice.cs": "b530a64f2580553868b271a08126223b",
    "Runtime/HapticMaterial.cs": "1ddf696326f1357d914736a15f0af798",
    "Runtime/HapticTool.cs": "00c1fd430946cac36c8426570f4d52e6",
    "Runtime/PalpateScene.cs": "ebbaa36452402f994c7fe0919467ff5d",
}


def pack():
    with tempfile.TemporaryDirectory() as folder:
        archive = Path(folder) / "package.tgz"
        subprocess.run([sys.executable, "-B", UNITY / "pack.py", LIBRARY, archive], check=True, capture_output=True)
        return archive.read_bytes()


class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.packed = pack()
        with tarfile.open(fileobj=io.BytesIO(cls.packed)) as tar:
            cls.files = {entry.name.removeprefix("package/"): tar.extractfile(entry).read() for entry in tar}

    def assets(self):
        """Files and folders that Unity imports."""
        files = {path for path in self.files if not path.endswith(".meta")}
        folders = {str(parent) for path in files for parent in PurePosixPath(path).parents} - {"."}
        return {path for path in files | folders if "~" not in path}

    def guid(self, path):
        text = self.files[path + ".meta"].decode()
        return re.fullmatch(r"fileFormatVersion: 2\nguid: ([0-9a-f]{32})\n.*", text, re.DOTALL)[1]

    def test_the_same_inputs_give_the_same_bytes(self):
        self.assertEqual(self.packed, pack())

    def test_every_asset_has_its_meta_and_every_meta_its_asset(self):
        self.assertEqual({path for path in self.files if path.endswith(".meta")},
                         {path + ".meta" for path in self.assets()})

    def test_guids_are_unique_and_stay_what_they_are(self):
        guids = [self.guid(path) for path in self.assets()]
        self.assertEqual(len(guids), len(set(guids)))
        self.assertEqual({path: self.guid(path) for path in GUIDS}, GUIDS)

    def test_components_are_in_files_of_their_names(self):
        for path in self.assets():
            for name in re.findall(r"class (\w+) : (?:MonoBehaviour|ScriptableObject|HapticBody)",
                                   self.files.get(path, b"").decode("utf-8", "replace") if path.endswith(".cs") else ""):
                self.assertEqual(PurePosixPath(path).stem, name)
                self.assertIn(path, GUIDS)

    def test_the_manifest_says_what_is_there(self):
        manifest = json.loads(self.files["package.json"])
        self.assertEqual(manifest["name"], "com.palpate.haptics")
        version = re.search(r"project\(palpate VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertEqual(manifest["version"], version)
        for sample in manifest["samples"]:
            self.assertTrue(any(path.startswith(sample["path"] + "/") for path in self.files))
        for name in ("README.md", "LICENSE.md", "CHANGELOG.md", "Documentation~/com.palpate.haptics.md"):
            self.assertIn(name, self.files)

    def test_the_page_of_documentation_is_the_readme(self):
        self.assertEqual(self.files["README.md"], self.files["Documentation~/com.palpate.haptics.md"])

    def test_assemblies_are_where_unity_looks_for_them(self):
        definitions = {json.loads(data)["name"]: path for path, data in self.files.items() if path.endswith(".asmdef")}
        for path in definitions.values():
            described = json.loads(self.files[path])
            self.assertEqual(PurePosixPath(path).stem, described["name"])
            self.assertLessEqual(set(described["references"]), set(definitions))
            self.assertEqual(path.startswith("Editor/"), described["includePlatforms"] == ["Editor"])

    def test_libraries_are_for_linux_alone(self):
        libraries = [path for path in self.files if path.endswith(".so")]
        self.assertIn(PLUGINS + "libpalpate.so", libraries)
        for path in libraries:
            self.assertTrue(path.startswith(PLUGINS), path)
            text = self.files[path + ".meta"].decode()
            self.assertIn("Any:\n    second:\n      enabled: 0", text)
            self.assertIn("Editor: Editor\n    second:\n      enabled: 1", text)
            self.assertIn("Standalone: Linux64\n    second:\n      enabled: 1", text)

    def test_libraries_find_each_other_and_nothing_else(self):
        with tempfile.TemporaryDirectory() as folder:
            for path in self.files:
                if path.endswith(".so"):
                    (Path(folder) / PurePosixPath(path).name).write_bytes(self.files[path])
            found = subprocess.run(["ldd", Path(folder) / "libpalpate.so"], check=True, capture_output=True, text=True)
            for name, path in re.findall(r"(\S+) => (\S+)", found.stdout):
                system = re.match(r"(libc|libm|libstdc\+\+|libgcc_s|libdl|libpthread|librt)\.so", name)
                self.assertTrue(system or path.startswith(folder), f"{name} is {path}")

    def test_licences_of_others_are_told(self):
        notices = self.files["Third Party Notices.md"].decode()
        for name in ("libembree", "libtbb", "libhwy", "libdraco"):
            self.assertIn(f"# {name}", notices)


if __name__ == "__main__":
    absent = [program for program in ("patchelf", "strip", "ldd") if not shutil.which(program)]
    if absent:
        print(f"Unity package: skipped: {absent[0]} is not installed")
        sys.exit(0)
    unittest.main()
