"""What palpate.h declares."""

from dataclasses import dataclass, field


@dataclass(frozen=True)
class Type:
    """`base` is void, char, a number's type or a name that the header declares; `pointers` counts the stars."""

    base: str
    pointers: int = 0
    const: bool = False

    def __str__(self):
        return f"{'const ' if self.const else ''}{self.base}{'*' * self.pointers}"


@dataclass(frozen=True)
class Constant:
    name: str
    value: int
    doc: str = ""


@dataclass(frozen=True)
class Enum:
    """`name` is None for a group of constants without a type."""

    name: str | None
    values: tuple[Constant, ...]


@dataclass(frozen=True)
class Field:
    """`count` is the length of an array, None for a single value. Parameters are fields, too."""

    name: str
    type: Type
    count: int | None = None


@dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple[Field, ...]


@dataclass(frozen=True)
class Handle:
    """An opaque value of a pointer's size."""

    name: str


@dataclass(frozen=True)
class Alias:
    """Another name of a number's type."""

    name: str
    type: Type


@dataclass(frozen=True)
class Callback:
    name: str
    result: Type
    parameters: tuple[Field, ...]


@dataclass(frozen=True)
class Function:
    """`since` is the version that brought it; `section` counts the header's parts; `doc` is its comment."""

    name: str
    result: Type
    parameters: tuple[Field, ...]
    since: str
    section: int
    doc: str = field(default="", compare=False)


@dataclass
class Interface:
    """Each list in the header's order."""

    macros: list[Constant] = field(default_factory=list)
    enums: list[Enum] = field(default_factory=list)
    structs: list[Struct] = field(default_factory=list)
    handles: list[Handle] = field(default_factory=list)
    aliases: list[Alias] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    functions: list[Function] = field(default_factory=list)

    def constants(self):
        return [*self.macros, *(value for enum in self.enums for value in enum.values)]

    def names(self, kind):
        """The names of one of the lists, such as "handles"."""
        return {item.name for item in getattr(self, kind)}
