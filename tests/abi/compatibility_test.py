"""What breaks a program is found, and what does not is told apart from it."""

import unittest

import baseline
import compatibility
import description

OLD = description.parse("""\
soname libpalpate.so.0
constant PLP_OK 0
enum plp_type 4
handle plp_model 8
struct plp_pose 56 fixed
field plp_pose position 0 24 double[3]
field plp_pose orientation 24 32 double[4]
struct plp_options 32 grows from 16
field plp_options struct_size 0 4 uint32_t
field plp_options cutoff 8 8 double
field plp_options reserved 16 8 uint64_t
field plp_options mode 24 4 int32_t
struct plp_lmd 16 grows by stride
field plp_lmd distance 0 8 double
callback plp_heard void(const char*)
function plp_open PALPATE_0.1 plp_result(const char*)
""")


def changed(*lines, without=()):
    """OLD with some facts removed, and others put in their place or added."""
    kept = {about: says for about, says in OLD.items() if " ".join(about) not in without}
    return kept | description.parse("\n".join(lines))


class Compatibility(unittest.TestCase):
    def expect_broken(self, new, place, released=()):
        found = compatibility.breaks(OLD, new, released)
        self.assertEqual(len(found), 1, found)
        self.assertIn(place, found[0])

    def expect_added(self, new, place):
        self.assertEqual(compatibility.breaks(OLD, new), [])
        self.assertIn(place, "\n".join(compatibility.additions(OLD, new)))

    def test_nothing_changed(self):
        self.assertEqual(compatibility.breaks(OLD, dict(OLD)), [])
        self.assertEqual(compatibility.additions(OLD, dict(OLD)), [])
        self.assertEqual(description.parse(description.render(OLD)), OLD)

    def test_removals(self):
        for about in OLD:
            name = " ".join(about)
            if about[0] not in ("soname", "struct") and "reserved" not in about:
                with self.subTest(name):
                    self.expect_broken(changed(without=[name]), "was removed")

    def test_changes(self):
        for line in ("constant PLP_OK 1", "enum plp_type 8", "handle plp_model 4",
                     "field plp_pose position 8 24 double[3]", "field plp_options cutoff 8 8 int64_t",
                     "callback plp_heard void(char*)", "function plp_open PALPATE_0.2 plp_result(const char*)",
                     "function plp_open PALPATE_0.1 plp_result(const void*)"):
            with self.subTest(line):
                self.expect_broken(changed(line), line.split()[1])

    def test_struct_that_may_not_grow(self):
        self.expect_broken(changed("struct plp_pose 64 fixed"), "had 56 bytes and has 64")

    def test_struct_that_shrinks(self):
        self.expect_broken(changed("struct plp_options 24 grows from 16"), "had 32 bytes")

    def test_first_size(self):
        self.expect_broken(changed("struct plp_options 32 grows from 32"), "grows from 16")

    def test_struct_that_grows(self):
        self.expect_added(changed("struct plp_options 40 grows from 16", "field plp_options law 32 4 int32_t"),
                          "plp_options law is new")
        self.expect_added(changed("struct plp_lmd 24 grows by stride", "field plp_lmd weight 16 8 double"),
                          "plp_lmd: 24 grows by stride was 16")

    def test_field_in_what_was_padding(self):
        self.expect_broken(changed("field plp_options law 28 4 int32_t"), "put where plp_options had other bytes")

    def test_field_in_what_was_reserved(self):
        self.expect_added(changed("field plp_options rate 16 8 double", without=["field plp_options reserved"]),
                          "plp_options rate is new")

    def test_reserved_field_that_is_not_filled(self):
        self.expect_broken(changed("field plp_options rate 16 4 float", without=["field plp_options reserved"]),
                           "reserved was removed")

    def test_new_names(self):
        for line in ("constant PLP_NEW 7", "enum plp_new 4", "handle plp_new 8", "struct plp_new 8 fixed",
                     "callback plp_new void()", "function plp_new PALPATE_0.2 void()"):
            with self.subTest(line):
                self.expect_added(changed(line), line.split()[1])

    def test_function_in_a_released_version(self):
        new = changed("function plp_new PALPATE_0.1 void()")
        self.assertEqual(compatibility.breaks(OLD, new), [])
        self.expect_broken(new, "PALPATE_0.1, which is released", baseline.released_versions(
            "## [Unreleased]\n## [0.1.3] - 2030-01-01\n"))

    def test_another_soname_is_another_interface(self):
        self.assertEqual(compatibility.breaks(OLD, {("soname",): "libpalpate.so.1"}), [])


if __name__ == "__main__":
    unittest.main()
