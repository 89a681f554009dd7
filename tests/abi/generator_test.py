"""The generator reads the header's plain style, and refuses whatever else it meets."""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
GEN = PROJECT / "bindings" / "gen"
sys.path.insert(0, str(GEN))

import csharp_errors  # noqa: E402
import csharp_raw  # noqa: E402
import generate  # noqa: E402
import header  # noqa: E402
import layout_program  # noqa: E402
import python_raw  # noqa: E402
import version_script  # noqa: E402
from interface import Constant, Field, Type  # noqa: E402
from lexer import HeaderError  # noqa: E402

PLAIN = """
#define PLP_LIMIT 16
/** A result. */
typedef int32_t plp_result;
enum {
  PLP_OK = 0,
  PLP_ERROR_BAD_FORMAT = -6, /**< not a < b &
                                never */
  PLP_BOTH = 1 << 3 | 2
};
typedef enum plp_kind { PLP_KIND_A, PLP_KIND_B = 5, PLP_KIND_C } plp_kind;
typedef struct plp_thing_t* plp_thing;
typedef void (*plp_heard)(plp_kind kind, const char* text, void* user);
typedef struct plp_point {
  double x[3]; /**< metres */
  plp_kind kind;
} plp_point;
typedef struct plp_line {
  char name[PLP_LIMIT];
  const plp_point* points;
  plp_thing in;
} plp_line;
/* -----------------------------------------------------------------------------------------------------------
 * things */
/** @brief Makes. @threadsafety any @since 0.1 */
PLP_API plp_result plp_thing_create(const plp_line* line, plp_thing* thing);
/** @brief Listens. @threadsafety any
 *  @since 0.2 */
PLP_API void plp_listen(plp_heard heard, const double* numbers, size_t count);
/** @brief Names. @since 0.1 */
PLP_API const char* plp_name(void);
"""
# What the header's style has no place for, each with what the message must say.
REFUSED = {
    "typedef union plp_u { double a; } plp_u;": "union",
    "typedef struct plp_s { double a, b; } plp_s;": "','",
    "typedef struct plp_s { int a : 3; } plp_s;": "unknown text",
    "typedef struct plp_s { double a[2][3]; } plp_s;": "'['",
    "typedef struct plp_s { struct plp_s* next; } plp_s;": "unknown type struct",
    "typedef struct plp_s { plp_none a; } plp_s;": "unknown type plp_none",
    "typedef struct plp_s { void a; } plp_s;": "a is a field of type void",
    "typedef struct plp_s { } plp_s;": "a field",
    "typedef struct plp_s { double a; } plp_other;": "'plp_s'",
    "typedef struct plp_other_t* plp_s;": "handle",
    "typedef long plp_s;": "long",
    "typedef double s;": "plp_",
    "enum { PLP_A = sizeof(int) };": "a constant",
    "enum { OTHER = 1 };": "PLP_",
    "enum { PLP_A = 1.5 };": "unknown text",
    "enum { PLP_A = 010 };": "unknown text",
    "enum { PLP_A, PLP_A };": "twice",
    "enum { };": "a constant",
    "int plp_f(void);": "a declaration",
    "static inline int plp_f(void) { return 0; }": "a declaration",
    "PLP_API int plp_f(void);": "@since",
    "/** @since 0.1 */ PLP_API int plp_f(double);": "a parameter's name",
    "/** @since 0.1 */ PLP_API int plp_f(double a, ...);": "unknown text",
    "/** @since 0.1 */ PLP_API int plp_f(unsigned a);": "unknown type unsigned",
    "/** @since 0.1 */ PLP_API int plp_f(void) __attribute__((pure));": "';'",
    "/** @since 0.1 */ PLP_API int plp_f(void); PLP_API int plp_g(void);": "@since",
    "#define PLP_NUMBER (1 + 2)": "unknown directive",
    "#pragma pack(1)": "unknown directive",
    "#include <stdbool.h>": "unknown directive",
    "#ifdef PLP_OTHER\n#endif": "unknown condition",
    "#endif": "without #if",
    "#ifdef __cplusplus\n": "without #endif",
    "// a comment": "unknown text",
    "// a comment\n#ifdef __cplusplus\n#endif": "unknown text",
}


class ParserTest(unittest.TestCase):
    def setUp(self):
        self.interface = header.parse(PLAIN)

    def test_constants(self):
        self.assertEqual(self.interface.constants(), [
            Constant("PLP_LIMIT", 16), Constant("PLP_OK", 0), Constant("PLP_ERROR_BAD_FORMAT", -6, "not a < b & never"),
            Constant("PLP_BOTH", 10), Constant("PLP_KIND_A", 0), Constant("PLP_KIND_B", 5), Constant("PLP_KIND_C", 6)])

    def test_structs(self):
        point, line = self.interface.structs
        self.assertEqual(point.fields, (Field("x", Type("double"), 3), Field("kind", Type("plp_kind"))))
        self.assertEqual(line.fields, (Field("name", Type("char"), 16), Field("points", Type("plp_point", 1, True)),
                                       Field("in", Type("plp_thing"))))

    def test_functions(self):
        create, listen, name = self.interface.functions
        self.assertEqual((create.since, listen.since, name.since), ("0.1", "0.2", "0.1"))
        self.assertEqual(create.parameters,
                         (Field("line", Type("plp_line", 1, True)), Field("thing", Type("plp_thing", 1))))
        self.assertEqual((name.result, name.parameters), (Type("char", 1, True), ()))

    def test_what_a_c_compiler_does_not_see_is_not_read(self):
        text = '#ifdef __cplusplus\nextern "C" {\n#endif\nenum { PLP_A = 1 };\n#ifdef __cplusplus\n}\n#endif\n'
        self.assertEqual(header.parse(text).constants(), [Constant("PLP_A", 1)])

    def test_what_is_not_understood_is_an_error(self):
        for text, message in REFUSED.items():
            with self.subTest(text), self.assertRaises(HeaderError) as caught:
                header.parse(text + "\n")
            self.assertIn(message, str(caught.exception))
            self.assertRegex(str(caught.exception), r"^line \d+: ")


class EmitterTest(unittest.TestCase):
    def setUp(self):
        self.interface = header.parse(PLAIN)

    def assert_holds(self, text, *parts):
        for part in parts:
            self.assertIn(part, text)

    def test_python(self):
        text = python_raw.emit(self.interface)
        self.assert_holds(
            text, "PLP_KIND_C = 6\n", '("x", c_double * 3), ("kind", c_int)', '("name", c_char * 16)',
            '("points", c_void_p)', '("in", c_void_p)', "plp_heard = CFUNCTYPE(None, c_int, c_char_p, c_void_p)",
            '_function("plp_thing_create", _result, POINTER(plp_line), POINTER(_handle))',
            '_function("plp_listen", None, plp_heard, POINTER(c_double), c_size_t)', '_function("plp_name", c_char_p)')
        compile(text, "_raw.py", "exec")
        self.assertLessEqual(max(map(len, text.splitlines())), 120)

    def test_csharp(self):
        self.assert_holds(
            csharp_raw.emit(self.interface), "public const int PLP_ERROR_BAD_FORMAT = -6;", "public fixed double x[3];",
            "public fixed byte name[16];", "public plp_point* points;", "public IntPtr @in;",
            "public delegate void plp_heard(int kind, byte* text, void* user);",
            "public static extern int plp_thing_create(plp_line* line, IntPtr* thing);",
            "public static extern void plp_listen(IntPtr heard, double* numbers, UIntPtr count);",
            "public static extern byte* plp_name();")

    def test_csharp_refuses_what_it_has_no_form_for(self):
        for text in ("typedef struct plp_a { double x; } plp_a; typedef struct plp_b { plp_a all[2]; } plp_b;",
                     "enum { PLP_LARGE = 1 << 31 };"):
            with self.subTest(text), self.assertRaises(csharp_raw.Unsupported):
                csharp_raw.emit(header.parse(text + "\n"))

    def test_exceptions(self):
        self.assert_holds(
            csharp_errors.emit(self.interface), "PLP_ERROR_BAD_FORMAT: not a &lt; b &amp; never.",
            "class PalpateBadFormatException : PalpateException",
            "case Raw.PLP_ERROR_BAD_FORMAT: return new PalpateBadFormatException(message);")

    def test_each_version_has_its_symbols(self):
        self.assertEqual(version_script.emit(self.interface), (
            "PALPATE_0.1 {\n  global:\n    plp_name;\n    plp_thing_create;\n  local:\n    *;\n};\n\n"
            "PALPATE_0.2 {\n  global:\n    plp_listen;\n} PALPATE_0.1;\n"))

    def test_layout(self):
        self.assert_holds(
            layout_program.emit(self.interface),
            'printf("offset plp_line points %lld\\n"', "offsetof(plp_line, points)",
            "plp_result (*f)(const plp_line*, plp_thing*) = plp_thing_create;")


class CheckTest(unittest.TestCase):
    def test_a_change_of_the_header_or_of_a_file_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for path in (generate.HEADER, *generate.OUTPUTS):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(PROJECT / path, root / path)
            self.assertEqual(self.run_generate(root, "--check"), 0)
            for path in (generate.HEADER, *generate.OUTPUTS):
                kept = (root / path).read_text()
                (root / path).write_text(kept.replace("PLP_LOG_DEBUG = 3", "PLP_LOG_DEBUG = 4")
                                         .replace("plp_version;", "").replace("BadFormat", "Bad"))
                self.assertEqual(self.run_generate(root, "--check"), 1, path)
                (root / path).write_text(kept)
            (root / generate.HEADER).write_text((PROJECT / generate.HEADER).read_text().replace("= 3", "= 4"))
            self.assertEqual(self.run_generate(root), 0)
            self.assertEqual(self.run_generate(root, "--check"), 0)
            self.assertIn("PLP_LOG_DEBUG = 4", (root / "bindings/python/src/palpate/_raw.py").read_text())

    @staticmethod
    def run_generate(root, *options):
        command = [sys.executable, "-B", GEN / "generate.py", "--root", root, *options]
        return subprocess.run(command, capture_output=True).returncode


if __name__ == "__main__":
    unittest.main()
