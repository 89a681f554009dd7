"""Every rule accepts a clean tree and finds a planted violation."""

import shutil
import tempfile
import unittest
from pathlib import Path

import layers
import rules

PROJECT = Path(__file__).resolve().parents[2]
CLEAN_TREE = {
    "README.md": "# A tree\n",
    "engine/base/log.h": "#pragma once\nvoid log();\n",
    "engine/mesh/mesh.h": '#pragma once\n#include "engine/base/log.h"\n',
    "engine/exchange/slot.h": "#pragma once\n#include <atomic>\nextern std::atomic<int> slot;\n",
    "capi/src/model.cpp": '#include "engine/mesh/mesh.h"\n#include "palpate/palpate.h"\n',
    "samples/cli/main.cpp": '#include <palpate/palpate.h>\n#include "samples/cli/table.h"\n',
    "build/leftover.cpp": "\tint x ; // TO" "DO\n",
}


class Rules(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in (".clang-format", ".gitignore"):
            shutil.copy(PROJECT / name, self.root)
        for path, text in CLEAN_TREE.items():
            self.plant(path, text)

    def plant(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text)

    def expect_found(self, rule, path, text, place):
        """The rule accepts the clean tree; after planting it names the place, and only that."""
        self.assertEqual(rule(self.root), [])
        self.plant(path, text)
        found = rule(self.root)
        self.assertEqual(len(found), 1, found)
        self.assertIn(place, found[0])

    def test_atomic_in_capi(self):
        self.expect_found(rules.atomics, "capi/src/a.cpp", "int x;\nstd::atomic<int> y;\n", "capi/src/a.cpp:2")

    def test_atomic_header_in_engine(self):
        self.expect_found(rules.atomics, "engine/mesh/a.h", "#include <atomic>\n", "engine/mesh/a.h:1")

    def test_atomic_builtin_in_sample(self):
        self.expect_found(rules.atomics, "samples/a.c", "int f(int* p) { return __atomic_load_n(p, 0); }\n",
                          "samples/a.c:1")

    def test_formatting(self):
        self.expect_found(rules.formatting, "engine/base/a.cpp", "int  x;\n", "engine/base/a.cpp:1")

    def test_formatting_of_c(self):
        self.expect_found(rules.formatting, "tests/a.c", "int f(){return 0;}\n", "tests/a.c:1")

    def test_include_of_a_higher_layer(self):
        self.expect_found(rules.includes, "engine/base/a.h", '#include "engine/mesh/mesh.h"\n', "engine/base/a.h:1")

    def test_include_of_a_sibling_layer(self):
        self.expect_found(rules.includes, "engine/contact/a.h", '#include "engine/mesh/mesh.h"\n',
                          "engine/contact/a.h:1")

    def test_include_around_the_corner(self):
        self.expect_found(rules.includes, "engine/base/a.h", '#include "../mesh/mesh.h"\n', "engine/base/a.h:1")

    def test_include_of_the_interface_by_the_engine(self):
        self.expect_found(rules.includes, "engine/scene/a.cpp", "#include <palpate/palpate.h>\n",
                          "engine/scene/a.cpp:1")

    def test_include_of_the_engine_by_a_sample(self):
        self.expect_found(rules.includes, "samples/cli/a.cpp", '#include "engine/base/log.h"\n',
                          "samples/cli/a.cpp:1")

    def test_include_in_an_unknown_layer(self):
        self.expect_found(rules.includes, "engine/helpers/a.cpp", '#include "engine/base/log.h"\n',
                          "engine/helpers/a.cpp:1")

    def test_link_to_a_higher_layer(self):
        self.expect_found(rules.includes, "engine/math/CMakeLists.txt", "palpate_layer(math LINKS palpate_scene)\n",
                          "engine/math/CMakeLists.txt:1")

    def test_tab(self):
        self.expect_found(rules.tabs, "samples/a.py", "if True:\n\tpass\n", "samples/a.py:2")

    def test_unfinished_work(self):
        self.expect_found(rules.unfinished, "assets/a.py", "# FIX" "ME: later\n", "assets/a.py:1")

    def test_top_level_file(self):
        self.expect_found(rules.top_level, "notes.txt", "", "notes.txt")

    def test_top_level_folder(self):
        self.expect_found(rules.top_level, "utils/a.h", "", "utils")

    def test_layers_have_no_cycle(self):
        for layer in layers.BELOW:
            for lower in layers.all_below(layer) - {layer}:
                self.assertNotIn(layer, layers.all_below(lower))


if __name__ == "__main__":
    unittest.main()
