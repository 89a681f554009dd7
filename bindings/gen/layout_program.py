"""A C program that prints what the compiler makes of the header: a line for each size, offset and value.

It compiles only if every function has the type that the generator read."""

HEAD = """/* Made from palpate.h by bindings/gen/generate.py. */
#include <palpate/palpate.h>
#include <stdio.h>

int main(void) {
"""


def _print(*words, value):
    return f'  printf("{" ".join(words)} %lld\\n", (long long)({value}));\n'


def _struct(struct):
    text = _print("struct", struct.name, value=f"sizeof({struct.name})")
    for field in struct.fields:
        place = f"{struct.name} {field.name}"
        text += _print("offset", place, value=f"offsetof({struct.name}, {field.name})")
        text += _print("size", place, value=f"sizeof((({struct.name}*)0)->{field.name})")
    return text


def _parameters(parameters):
    return ", ".join(str(parameter.type) for parameter in parameters) or "void"


def _function(function):
    kind = f"{function.result} (*f)({_parameters(function.parameters)})"
    return f"  {{ {kind} = {function.name}; (void)f; }}\n"


def _callback(callback):
    kind = f"{callback.result} (*f)({_parameters(callback.parameters)})"
    return f"  {{ {kind} = (({callback.name})0); (void)f; }}\n"


def emit(interface):
    lines = [_print("value", constant.name, value=constant.name) for constant in interface.constants()]
    kinds = {"handle": interface.handles, "alias": interface.aliases,
             "enum": [enum for enum in interface.enums if enum.name]}
    lines += [_print(kind, item.name, value=f"sizeof({item.name})") for kind, items in kinds.items() for item in items]
    lines += map(_struct, interface.structs)
    lines += map(_callback, interface.callbacks)
    lines += map(_function, interface.functions)
    return HEAD + "".join(lines) + "  return 0;\n}\n"
