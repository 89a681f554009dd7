"""The raw layer of the Python package: ctypes declarations."""

import itertools
import re

from wrapping import WIDTH, wrapped

NUMBERS = {"char": "c_char", "int": "c_int", "int32_t": "c_int32", "int64_t": "c_int64", "uint8_t": "c_uint8",
           "uint16_t": "c_uint16", "uint32_t": "c_uint32", "uint64_t": "c_uint64", "size_t": "c_size_t",
           "float": "c_float", "double": "c_double"}
HEAD = '''"""palpate.h as it is: its constants, structs and functions under their own names. Nothing is checked here.

Made from the header by bindings/gen/generate.py; do not edit."""
'''
FUNCTION = '''
def _function(name: str, result: Any, *arguments: Any) -> Callable[..., Any]:
    try:
        function = getattr(_library, name)
    except AttributeError:
        raise ImportError(f"{_library._name} is of another version than this package: it has no {name}") from None
    function.restype = result
    function.argtypes = arguments
    return function  # type: ignore[no-any-return]
'''


class Names:
    """ctypes' names of C types."""

    def __init__(self, interface):
        self.handles = interface.names("handles")
        self.aliases = {alias.name: alias for alias in interface.aliases}
        self.enums = interface.names("enums")

    def value(self, name):
        if name in self.handles:
            return "_handle"
        if name in self.aliases:
            return name.replace("plp_", "_")
        if name in self.enums:
            return "c_int"
        return NUMBERS.get(name, name)

    def parameter(self, kind):
        if kind.base == "char" and kind.pointers == 1:
            return "c_char_p"
        if kind.base == "void":
            return self._void(kind.pointers)
        return self._pointer(self.value(kind.base), kind.pointers)

    def field(self, field):
        """A pointer in a struct is an address: whose memory it is ctypes cannot know. A handle is of its size."""
        kind = "c_void_p" if field.type.pointers or field.type.base in self.handles else self._number(field.type.base)
        return f"{kind} * {field.count}" if field.count is not None else kind

    def _number(self, name):
        """Structs stand before the aliases, which need no name there."""
        return NUMBERS[self.aliases[name].type.base] if name in self.aliases else self.value(name)

    def _void(self, pointers):
        return self._pointer("c_void_p", pointers - 1) if pointers else "None"

    @staticmethod
    def _pointer(name, pointers):
        return "POINTER(" * pointers + name + ")" * pointers


def _constants(interface):
    groups = [interface.macros, *(enum.values for enum in interface.enums)]
    return "\n\n".join("\n".join(f"{value.name} = {value.value}" for value in group) for group in groups if group)


def _callback(callback, names):
    parts = [names.parameter(kind) for kind in (callback.result, *(part.type for part in callback.parameters))]
    return wrapped(f"{callback.name} = CFUNCTYPE(", parts, ")")


def _struct(struct, names):
    fields = [f'("{field.name}", {names.field(field)})' for field in struct.fields]
    line = f"    _fields_ = [{', '.join(fields)}]"
    if len(line) > WIDTH:
        line = "    _fields_ = [\n" + "".join(f"        {field},\n" for field in fields) + "    ]"
    return f"\n\nclass {struct.name}(Structure):\n{line}\n"


def _function(function, names):
    kinds = (function.result, *(parameter.type for parameter in function.parameters))
    return wrapped(f"{function.name} = _function(", [f'"{function.name}"', *map(names.parameter, kinds)], ")")


def _functions(interface, names):
    sections = itertools.groupby(interface.functions, key=lambda function: function.section)
    return "\n\n".join("\n".join(_function(function, names) for function in group) for _, group in sections)


def _used(code):
    """The names of ctypes in the code, capitals first, numbers by their value."""
    def key(name):
        return [(part.isdigit(), int(part) if part.isdigit() else part) for part in re.split(r"(\d+)", name) if part]

    return sorted(set(re.findall(r"\b(?:CFUNCTYPE|POINTER|Structure|c_\w+)\b", code)), key=key)


def emit(interface):
    names = Names(interface)
    code = "\n".join(_callback(callback, names) for callback in interface.callbacks) + "\n"
    code += "".join(_struct(struct, names) for struct in interface.structs)
    code += "\n\n# A handle is an opaque value of a pointer's size; ctypes gives a null one back as None.\n"
    code += "_handle = c_void_p\n"
    code += "".join(f"{names.value(alias.name)} = {NUMBERS[alias.type.base]}\n" for alias in interface.aliases)
    code += f"_library = load()\n\n{FUNCTION}\n\n{_functions(interface, names)}\n"
    imports = wrapped("from ctypes import (", _used(code), ")")
    return (f"{HEAD}\nfrom collections.abc import Callable\n{imports}\nfrom typing import Any\n\n"
            f"from ._library import load\n\n{_constants(interface)}\n\n{code}")
