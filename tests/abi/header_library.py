"""header_library.py FILE: writes a C library that has every function of palpate.h and does nothing.

With debug information it tells abidiff all types of the interface in a second; of the library itself abidiff would have
to read those of the whole engine first, which takes minutes. That both have the same functions is another test."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "gen"))

import header  # noqa: E402


def _definition(function):
    parameters = ", ".join(f"{parameter.type} {parameter.name}" for parameter in function.parameters) or "void"
    unused = "".join(f"  (void){parameter.name};\n" for parameter in function.parameters)
    result = "" if str(function.result) == "void" else f"  return ({function.result})0;\n"
    return f"{function.result} {function.name}({parameters}) {{\n{unused}{result}}}\n"


def emit(interface):
    return "#include <palpate/palpate.h>\n" + "".join(map(_definition, interface.functions))


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(emit(header.parse((ROOT / "capi/include/palpate/palpate.h").read_text())))
