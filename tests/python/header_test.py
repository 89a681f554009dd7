"""The raw layer against palpate.h itself."""

import ctypes
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from palpate import _raw

INCLUDE = Path(__file__).resolve().parents[2] / "capi" / "include"
HEADER = (INCLUDE / "palpate" / "palpate.h").read_text()
CODE = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.DOTALL)
FUNCTION = re.compile(r"^PLP_API ([\w ]+?\*?) ?\b(plp_\w+)\((.*?)\);", re.MULTILINE | re.DOTALL)
STRUCT = re.compile(r"typedef struct (plp_\w+) \{(.*?)\}", re.DOTALL)
ENUM = re.compile(r"enum(?: plp_\w+)? \{(.*?)\}", re.DOTALL)
PLAIN_TYPES = {
    "void": None, "int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32, "size_t": ctypes.c_size_t,
    "double": ctypes.c_double,
    "char*": ctypes.c_char_p, "void*": ctypes.c_void_p, "plp_result": ctypes.c_int32, "plp_body": ctypes.c_uint64,
    "plp_model": ctypes.c_void_p, "plp_scene": ctypes.c_void_p, "plp_query_result": ctypes.c_void_p,
    "plp_log_callback": _raw.plp_log_callback,
}


def ctype(text):
    """The ctypes type of a C type."""
    name = text.replace("const ", "").replace(" ", "")
    if name in PLAIN_TYPES:
        return PLAIN_TYPES[name]
    pointed = name.removesuffix("*")
    return ctypes.POINTER(PLAIN_TYPES[pointed] if pointed in PLAIN_TYPES else getattr(_raw, pointed))


def parameters(text):
    return [] if text.strip() == "void" else [ctype(re.sub(r"\w+$", "", part.strip())) for part in text.split(",")]


def compiled_values(expressions):
    """What the C compiler makes of integer expressions."""
    prints = "\n".join(f'printf("%lld\\n", (long long)({expression}));' for expression in expressions)
    source = f"#include <palpate/palpate.h>\n#include <stdio.h>\nint main(void) {{ {prints} return 0; }}\n"
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "values")
        subprocess.run([os.environ.get("CC", "cc"), f"-I{INCLUDE}", "-x", "c", "-", "-o", program], input=source,
                       text=True, check=True)
        return [int(line) for line in subprocess.run([program], capture_output=True, check=True).stdout.split()]


class HeaderTest(unittest.TestCase):
    def test_every_function_is_declared_as_in_the_header(self):
        functions = FUNCTION.findall(CODE)
        self.assertEqual(len(functions), HEADER.count("PLP_API ") - HEADER.count("#define PLP_API "))
        for result, name, arguments in functions:
            function = getattr(_raw, name)
            self.assertEqual(function.restype, ctype(result), name)
            self.assertEqual(list(function.argtypes), parameters(arguments), name)

    def test_every_struct_has_the_compilers_layout(self):
        expressions, declared = [], []
        structs = STRUCT.findall(CODE)
        self.assertGreater(len(structs), 10)
        for name, members in structs:
            struct = getattr(_raw, name)
            fields = re.findall(r"(\w+)(?:\[\d+\])?;", members)
            self.assertEqual([field[0] for field in struct._fields_], fields, name)
            expressions.append(f"sizeof({name})")
            declared.append(ctypes.sizeof(struct))
            for field in fields:
                expressions += [f"offsetof({name}, {field})", f"sizeof((({name}*)0)->{field})"]
                declared += [getattr(struct, field).offset, getattr(struct, field).size]
        for expression, raw, compiled in zip(expressions, declared, compiled_values(expressions), strict=True):
            self.assertEqual(raw, compiled, expression)

    def test_every_constant_has_the_compilers_value(self):
        names = [name for body in ENUM.findall(CODE) for name in re.findall(r"\b(PLP_\w+)", body)]
        self.assertGreater(len(names), 30)
        for name, value in zip(names, compiled_values(names), strict=True):
            self.assertEqual(getattr(_raw, name), value, name)
