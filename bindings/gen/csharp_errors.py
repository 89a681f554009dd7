"""One C# exception for each error code."""

PREFIX = "PLP_ERROR_"
HEAD = """// SPDX-License-Identifier: MIT
// Made from palpate.h by bindings/gen/generate.py; do not edit.
namespace Palpate
{
"""


def _codes(interface):
    return [value for value in interface.constants() if value.name.startswith(PREFIX)]


def _class_name(code):
    words = code.name.removeprefix(PREFIX).split("_")
    return f"Palpate{''.join(word.capitalize() for word in words)}Exception"


def _escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def _exception(code):
    name = _class_name(code)
    summary = f"{code.name}: {_escaped(code.doc.rstrip('.'))}" if code.doc else code.name
    return (f"    /// <summary>{summary}.</summary>\n"
            f"    public sealed class {name} : PalpateException\n    {{\n"
            f"        internal {name}(string message) : base(Raw.{code.name}, message)\n"
            "        {\n        }\n    }\n")


def _factory(codes):
    indent = " " * 16
    cases = "".join(f"{indent}case Raw.{code.name}: return new {_class_name(code)}(message);\n" for code in codes)
    return ("    internal static class ExceptionOfCode\n    {\n"
            "        internal static PalpateException Make(int code, string message)\n        {\n"
            f"            switch (code)\n            {{\n{cases}"
            "                default: return new PalpateException(code, message);\n            }\n        }\n    }\n")


def emit(interface):
    codes = _codes(interface)
    return HEAD + "\n".join([*map(_exception, codes), _factory(codes)]) + "}\n"
