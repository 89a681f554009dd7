"""The raw layer of the C# binding: P/Invoke declarations that need no marshalling."""

from wrapping import wrapped

NUMBERS = {"char": "byte", "int": "int", "int32_t": "int", "int64_t": "long", "uint8_t": "byte", "uint16_t": "ushort",
           "uint32_t": "uint", "uint64_t": "ulong", "size_t": "UIntPtr", "float": "float", "double": "double"}
# What `fixed` may be an array of.
FIXED = {"byte", "ushort", "int", "uint", "long", "ulong", "float", "double"}
KEYWORDS = {"abstract", "base", "bool", "break", "case", "checked", "class", "const", "continue", "decimal", "default",
            "delegate", "do", "else", "event", "explicit", "extern", "finally", "fixed", "for", "foreach", "goto", "if",
            "implicit", "in", "interface", "internal", "is", "lock", "namespace", "new", "null", "object", "operator",
            "out", "override", "params", "private", "protected", "public", "readonly", "ref", "return", "sealed",
            "short", "sizeof", "stackalloc", "static", "string", "switch", "this", "throw", "try", "typeof", "unsafe",
            "using", "virtual", "volatile", "while"}
HEAD = """// SPDX-License-Identifier: MIT
// Made from palpate.h by bindings/gen/generate.py; do not edit.
using System;
using System.Runtime.InteropServices;
using System.Security;

namespace Palpate
{
    /// <summary>palpate.h as it is: its constants, structs and functions under their own names, handles as IntPtr.
    /// Nothing is checked here.</summary>
    [SuppressUnmanagedCodeSecurity]
    public static unsafe class Raw
    {
        /// <summary>Found by the loader as libpalpate.so.</summary>
        public const string Library = "palpate";
"""


class Unsupported(Exception):
    """A declaration that has no form in C# 7.2."""


class Names:
    """C#'s names of C types."""

    def __init__(self, interface):
        self.handles = interface.names("handles") | interface.names("callbacks")
        self.aliases = {alias.name: alias.type.base for alias in interface.aliases}
        self.enums = interface.names("enums")

    def of(self, kind):
        """An enum is passed as its number: a caller may meet values that its version does not know."""
        if kind.base in self.handles:
            name = "IntPtr"
        elif kind.base in self.enums:
            name = "int"
        else:
            base = self.aliases.get(kind.base, kind.base)
            name = NUMBERS.get(base, base)
        return name + "*" * kind.pointers


def identifier(name):
    return f"@{name}" if name in KEYWORDS else name


def _constant(constant):
    if not -2**31 <= constant.value < 2**31:
        raise Unsupported(f"{constant.name} is larger than an int")
    return f"        public const int {constant.name} = {constant.value};\n"


def _constants(interface):
    groups = [interface.macros, *(enum.values for enum in interface.enums)]
    return "\n".join("".join(map(_constant, group)) for group in groups if group)


def _field(field, names):
    kind = names.of(field.type)
    if field.count is None:
        return f"            public {kind} {identifier(field.name)};\n"
    if kind not in FIXED:
        raise Unsupported(f"{field.name} is an array of {kind}")
    return f"            public fixed {kind} {identifier(field.name)}[{field.count}];\n"


def _struct(struct, names):
    fields = "".join(_field(field, names) for field in struct.fields)
    return (f"        [StructLayout(LayoutKind.Sequential)]\n        public struct {struct.name}\n        {{\n{fields}"
            "        }\n")


def _parameters(parameters, names):
    return [f"{names.of(parameter.type)} {identifier(parameter.name)}" for parameter in parameters]


def _callback(callback, names):
    opening = f"        public delegate {names.of(callback.result)} {callback.name}("
    return ("        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]\n"
            f"{wrapped(opening, _parameters(callback.parameters, names), ');')}\n")


def _function(function, names):
    opening = f"        public static extern {names.of(function.result)} {function.name}("
    return ("        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]\n"
            f"{wrapped(opening, _parameters(function.parameters, names), ');')}\n")


def emit(interface):
    names = Names(interface)
    parts = [_constants(interface)]
    parts += [_callback(callback, names) for callback in interface.callbacks]
    parts += [_struct(struct, names) for struct in interface.structs]
    parts += [_function(function, names) for function in interface.functions]
    return HEAD + "\n" + "\n".join(parts) + "    }\n}\n"
