"""palpate.h as tokens. Whatever is not understood is an error and never skipped."""

import re
from dataclasses import dataclass

# A condition that is not here is an error.
CONDITIONS = {
    "ifndef PALPATE_PALPATE_H": True,
    "ifdef __cplusplus": False,
    "if defined(PLP_STATIC)": False,
    "elif defined(_WIN32)": False,
    "if defined(PLP_BUILD)": False,
}
IGNORED_DIRECTIVES = {
    "define PALPATE_PALPATE_H",
    "define PLP_API",
    "define PLP_API __declspec(dllexport)",
    "define PLP_API __declspec(dllimport)",
    'define PLP_API __attribute__((visibility("default")))',
    "include <stddef.h>",
    "include <stdint.h>",
}
TOKEN = re.compile(r"""
    (?P<section>/\*\ -{10}.*?\*/)
  | (?P<member>/\*\*<.*?\*/)
  | (?P<comment>/\*.*?\*/)
  | (?P<directive>^[ ]*\#[^\n]*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<number>0[xX][0-9A-Fa-f]+|[1-9][0-9]*|0)(?![\w.])
  | (?P<mark><<|[{}()\[\];,*=|-])
  | (?P<space>\s+)
""", re.VERBOSE | re.DOTALL | re.MULTILINE)
MACRO = re.compile(r"define (PLP_\w+) (0|[1-9]\d*)$")


class HeaderError(Exception):
    """Something in the header that this generator has no form for."""


@dataclass(frozen=True)
class Token:
    """`kind` is section, member, comment, macro, name, number, mark or end."""

    kind: str
    text: str
    line: int


def comment_text(token):
    """The words of a comment without its stars."""
    body = re.sub(r"^/\*+<?|\*+/$", "", token.text)
    return " ".join(re.sub(r"^\s*\*", "", line).strip() for line in body.splitlines()).strip()


class Conditions:
    """Which branches of nested #if are taken: by a C compiler that uses the shared library."""

    def __init__(self):
        self.stack = []

    def taken(self):
        return all(active for active, _ in self.stack)

    def meet(self, directive, line):
        """Whether the directive was one of a condition."""
        word = directive.split()[0]
        if word == "endif" or word == "else" or word == "elif":
            if not self.stack:
                raise HeaderError(f"line {line}: #{word} without #if")
            _, before = self.stack.pop()
            if word != "endif":
                chosen = not before and (word == "else" or self._value(directive, line))
                self.stack.append((chosen, before or chosen))
            return True
        if word in ("if", "ifdef", "ifndef"):
            value = self._value(directive, line)
            self.stack.append((value, value))
            return True
        return False

    @staticmethod
    def _value(directive, line):
        if directive not in CONDITIONS:
            raise HeaderError(f"line {line}: unknown condition #{directive}")
        return CONDITIONS[directive]


def _directive_tokens(text, line, conditions):
    directive = " ".join(text.strip().lstrip("#").split())
    if conditions.meet(directive, line) or not conditions.taken() or directive in IGNORED_DIRECTIVES:
        return
    if not MACRO.match(directive):
        raise HeaderError(f"line {line}: unknown directive #{directive}")
    yield Token("macro", directive, line)


def tokens(text):
    """The tokens that a C compiler sees, and comments, in order; the last is of kind end."""
    conditions = Conditions()
    position, line = 0, 1
    while position < len(text):
        match = TOKEN.match(text, position)
        if not match and conditions.taken():
            raise HeaderError(f"line {line}: unknown text {text[position:].splitlines()[0]!r}")
        # What a compiler does not see may be anything.
        kind, found = (match.lastgroup, match.group()) if match else ("space", text[position])
        if kind == "directive":
            yield from _directive_tokens(found, line, conditions)
        elif kind != "space" and conditions.taken():
            yield Token(kind, found, line)
        line += found.count("\n")
        position += len(found)
    if conditions.stack:
        raise HeaderError(f"line {line}: an #if without #endif")
    yield Token("end", "", line)
