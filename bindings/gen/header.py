"""palpate.h as an Interface. A declaration that is not in the header's own plain style is an error."""

import re

from interface import Alias, Callback, Constant, Enum, Field, Function, Handle, Interface, Struct, Type
from lexer import MACRO, HeaderError, comment_text, tokens

NUMBERS = ("char", "int", "int32_t", "int64_t", "uint8_t", "uint16_t", "uint32_t", "uint64_t", "size_t", "float",
           "double")
SINCE = re.compile(r"@since (\d+\.\d+)\b")


class Parser:
    def __init__(self, text):
        self.interface = Interface()
        self.declared = {"void", *NUMBERS}
        self.values = {}
        self.section = 0
        self.stream = tokens(text)
        self.token = None
        self._advance()

    def parse(self):
        while self.token.kind != "end":
            self._declaration()
        return self.interface

    # ---- tokens

    def _advance(self):
        """To the next token that is no comment; `comment` and `members` are the comments before it."""
        self.comment, self.members = None, []
        for token in self.stream:
            if token.kind == "section":
                self.section += 1
            elif token.kind == "comment":
                self.comment = token
            elif token.kind == "member":
                self.members.append(comment_text(token))
            else:
                self.token = token
                return

    def _fail(self, expected):
        raise HeaderError(f"line {self.token.line}: {self.token.text!r} where {expected} was expected")

    def _accept(self, text):
        if self.token.text != text:
            return False
        self._advance()
        return True

    def _expect(self, *texts):
        for text in texts:
            if not self._accept(text):
                self._fail(repr(text))

    def _take(self, kind, expected):
        if self.token.kind != kind:
            self._fail(expected)
        text = self.token.text
        self._advance()
        return text

    def _new_name(self):
        name = self._take("name", "a name")
        if name in self.declared:
            raise HeaderError(f"line {self.token.line}: {name} is declared twice")
        if not name.startswith("plp_"):
            raise HeaderError(f"line {self.token.line}: {name} does not begin with plp_")
        return name

    # ---- declarations

    def _declaration(self):
        if self.token.kind == "macro":
            name, value = MACRO.match(self.token.text).groups()
            self.interface.macros.append(self._constant(name, int(value), ""))
            self._advance()
        elif self._accept("enum"):
            self.interface.enums.append(Enum(None, self._enumerators()))
            self._expect(";")
        elif self._accept("typedef"):
            self._typedef()
        elif self.token.text == "PLP_API":
            self._function()
        else:
            self._fail("a declaration")

    def _typedef(self):
        if self._accept("enum"):
            name = self._new_name()
            self.interface.enums.append(Enum(name, self._enumerators()))
            self._expect(name, ";")
        elif self._accept("struct"):
            name = self._struct()
        elif self._accept("void"):
            self._expect("(", "*")
            name = self._new_name()
            self._expect(")")
            self.interface.callbacks.append(Callback(name, Type("void"), self._parameters()))
            self._expect(";")
        else:
            base = self._take("name", "a type")
            if base not in NUMBERS:
                raise HeaderError(f"line {self.token.line}: {base} is no type of a number")
            name = self._new_name()
            self.interface.aliases.append(Alias(name, Type(base)))
            self._expect(";")
        self.declared.add(name)

    def _struct(self):
        """A struct with its fields, or the handle that points to one that is nowhere defined."""
        tag = self._new_name()
        if self._accept("*"):
            name = self._new_name()
            if tag != f"{name}_t":
                raise HeaderError(f"line {self.token.line}: {name} is a handle to {tag}")
            self.interface.handles.append(Handle(name))
        else:
            name = tag
            self.interface.structs.append(Struct(name, self._fields()))
            self._expect(name)
        self._expect(";")
        return name

    def _fields(self):
        found = []
        self._expect("{")
        while not self._accept("}"):
            found.append(self._field())
            self._expect(";")
        if not found:
            self._fail("a field")
        return tuple(found)

    def _field(self):
        kind = self._type()
        name = self._take("name", "a name")
        count = None
        if self._accept("["):
            count = self._expression()
            self._expect("]")
        if kind == Type("void") or kind.base in self.interface.names("callbacks"):
            raise HeaderError(f"line {self.token.line}: {name} is a field of type {kind}")
        return Field(name, kind, count)

    def _type(self):
        const = self._accept("const")
        base = self._take("name", "a type")
        if base not in self.declared:
            raise HeaderError(f"line {self.token.line}: unknown type {base}")
        pointers = 0
        while self._accept("*"):
            pointers += 1
        return Type(base, pointers, const)

    def _parameters(self):
        self._expect("(")
        if self._accept("void"):
            if self._accept(")"):
                return ()
            self._expect("*")
            found = [Field(self._take("name", "a name"), Type("void", 1))]
        else:
            found = [self._parameter()]
        while not self._accept(")"):
            self._expect(",")
            found.append(self._parameter())
        return tuple(found)

    def _parameter(self):
        kind = self._type()
        return Field(self._take("name", "a parameter's name"), kind)

    def _function(self):
        documentation = comment_text(self.comment) if self.comment else ""
        section = self.section
        self._expect("PLP_API")
        result = self._type()
        name = self._new_name()
        since = SINCE.search(documentation)
        if not since:
            raise HeaderError(f"line {self.token.line}: the comment before {name} does not say @since")
        self.interface.functions.append(
            Function(name, result, self._parameters(), since.group(1), section, documentation))
        self.declared.add(name)
        self._expect(";")

    # ---- constants

    def _constant(self, name, value, doc):
        if name in self.values:
            raise HeaderError(f"line {self.token.line}: {name} is declared twice")
        self.values[name] = value
        return Constant(name, value, doc)

    def _enumerators(self):
        self._expect("{")
        found, following = [], 0
        while not self._accept("}"):
            name = self._take("name", "a constant")
            if not name.startswith("PLP_"):
                raise HeaderError(f"line {self.token.line}: {name} does not begin with PLP_")
            value = self._expression() if self._accept("=") else following
            docs = list(self.members)
            if self._accept(","):
                docs += self.members
            elif self.token.text != "}":
                self._fail("',' or '}'")
            found.append(self._constant(name, value, " ".join(docs)))
            following = value + 1
        if not found:
            self._fail("a constant")
        return tuple(found)

    def _expression(self):
        """Numbers, earlier constants, a sign, << and |."""
        value = self._shift()
        while self._accept("|"):
            value |= self._shift()
        return value

    def _shift(self):
        value = self._operand()
        return value << self._operand() if self._accept("<<") else value

    def _operand(self):
        if self._accept("-"):
            return -self._operand()
        if self.token.kind == "name":
            if self.token.text not in self.values:
                self._fail("a constant")
            return self.values[self._take("name", "a constant")]
        return int(self._take("number", "a number"), 0)


def parse(text):
    return Parser(text).parse()
