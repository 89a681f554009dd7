"""What the comment of each function in palpate.h must say: one sentence for each that it does not."""

import re

BRIEF = re.compile(r"^@brief \S")
THREADS = re.compile(r"@threadsafety (any|object|servo)\b")
CODES = re.compile(r"\bPLP_OK\b|\bPLP_ERROR_\w+|\bas plp_\w+")
UNIT = re.compile(r"\b(metres|seconds|radians)\b|\bN(·s)?/m\b|\bcoefficient\b|\bunits of\b|\bframe\b")
PARAMETER = re.compile(r"@param (\w+)")


def returned(doc):
    """What the comment says behind @return, up to the next command."""
    found = re.search(r"@return\b(.*?)(?=@\w|$)", doc, re.DOTALL)
    return found.group(1) if found else ""


def _basics(function):
    if not BRIEF.search(function.doc):
        yield "has no @brief"
    if not THREADS.search(function.doc):
        yield "does not say @threadsafety any, object or servo"


def _errors(function):
    if str(function.result) == "plp_result" and not CODES.search(returned(function.doc)):
        yield "does not say in @return which errors there are"


def _lifetimes(function, interface):
    """A pointer that is given is valid for a stated time; a handle that is given is released by the caller."""
    doc = function.doc.lower()
    if function.result.pointers and not re.search(r"\bvalid\b|static storage", doc):
        yield "does not say how long the pointer is valid"
    holding = {struct.name for struct in interface.structs if any(field.type.pointers for field in struct.fields)}
    for parameter in function.parameters:
        given = parameter.type.pointers == 1 and not parameter.type.const
        if given and parameter.type.base in interface.names("handles") and "release" not in doc:
            yield f"does not say who releases {parameter.name}"
        arrays = given and parameter.type.base in holding and not function.name.endswith("_init")
        if arrays and not re.search(r"\bvalid\b", doc):
            yield f"does not say how long the arrays of {parameter.name} are valid"


def _units(function):
    numbers = [parameter for parameter in function.parameters if parameter.type.base == "double"]
    if numbers and not UNIT.search(function.doc):
        yield f"does not say the unit of {numbers[0].name}"


def _parameters(function):
    names = {parameter.name for parameter in function.parameters}
    for name in PARAMETER.findall(function.doc):
        if name not in names:
            yield f"describes {name}, which is none of its parameters"


def lacks(interface):
    """One sentence for each thing that a function's comment lacks."""
    checks = (_basics, _errors, lambda function: _lifetimes(function, interface), _units, _parameters)
    return [f"{function.name} {sentence}" for function in interface.functions for check in checks
            for sentence in check(function)]
