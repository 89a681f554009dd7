"""Each thing that a function's comment may lack is found."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings" / "gen"))

import function_comments  # noqa: E402
import header  # noqa: E402

TYPES = """\
typedef int32_t plp_result;
typedef struct plp_thing_t* plp_thing;
typedef struct plp_list {
  const double* numbers;
} plp_list;
"""
COMPLETE = {
    "plp_result plp_open(const char* path, plp_thing* thing)":
        "@brief Opens. @param thing receives the handle; release it. @return PLP_ERROR_LIMIT. @threadsafety any",
    "plp_result plp_get(plp_thing thing, plp_list* list)":
        "@brief Gets. The arrays are valid until the release. @return as plp_open. @threadsafety object",
    "plp_result plp_set(plp_thing thing, double stiffness)":
        "@brief Sets it (N/m). @return PLP_ERROR_INVALID_HANDLE. @threadsafety servo",
    "const char* plp_name(plp_thing thing)": "@brief Names. Valid as long as the thing. @threadsafety any",
}
# What to leave out of which comment, and what is then said.
LACKING = (
    ("plp_name", "@brief ", "has no @brief"),
    ("plp_name", "@threadsafety any", "does not say @threadsafety"),
    ("plp_set", "@threadsafety servo", "does not say @threadsafety"),
    ("plp_open", "@return PLP_ERROR_LIMIT.", "which errors"),
    ("plp_open", "release", "who releases thing"),
    ("plp_get", "valid", "how long the arrays of list"),
    ("plp_name", "Valid", "how long the pointer"),
    ("plp_set", "N/m", "the unit of stiffness"),
    ("plp_open", "@param thing", "none of its parameters"),
)


def lacks(comments):
    functions = "".join(f"/** {doc} @since 0.1 */\nPLP_API {declaration};\n" for declaration, doc in comments.items())
    return function_comments.lacks(header.parse(TYPES + functions))


class Comments(unittest.TestCase):
    def test_complete(self):
        self.assertEqual(lacks(COMPLETE), [])

    def test_lacking(self):
        for name, left_out, said in LACKING:
            with self.subTest(said):
                replacement = "@param other" if said.startswith("none") else ""
                comments = {declaration: doc.replace(left_out, replacement) if f"{name}(" in declaration else doc
                            for declaration, doc in COMPLETE.items()}
                found = lacks(comments)
                self.assertEqual(len(found), 1, found)
                self.assertIn(said, found[0])


if __name__ == "__main__":
    unittest.main()
