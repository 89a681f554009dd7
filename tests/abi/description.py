"""What programs that were built with palpate.h depend on: a line for each fact.

    soname libpalpate.so.0
    constant PLP_OK 0
    enum plp_type 4                                    its size
    struct plp_pose 56 fixed                           its size, and whether it may grow
    struct plp_model_options 40 grows from 32          the size that the first version had
    struct plp_lmd 144 grows by stride                 it is only met in arrays that say how far elements are apart
    field plp_pose position 0 24 double[3]             its offset, size and type
    function plp_version PALPATE_0.1 uint32_t()        the version of its symbol, and its type
"""

import re
import subprocess

FIRST_SIZE = re.compile(r"kFirstSize<(plp_\w+)> = (\d+);")
# They change with every release, and nothing depends on them.
VERSIONS = ("PLP_VERSION_MAJOR", "PLP_VERSION_MINOR", "PLP_VERSION_PATCH")


def _words(line):
    """How many words of a line name the fact; the rest is what it says."""
    return {"soname": 1, "field": 3}.get(line.split(" ", 1)[0], 2)


def parse(text):
    """The facts of a description, in its order: what each is about, and what it says."""
    facts = {}
    for line in text.splitlines():
        words = line.split(" ", _words(line))
        facts[tuple(words[:-1])] = words[-1]
    return facts


def render(facts):
    return "".join(" ".join((*about, says)) + "\n" for about, says in facts.items())


def _run(*command):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


def measured(program):
    """What test_abi_layout prints, by all words but the number at the end."""
    return {tuple(words[:-1]): words[-1] for words in map(str.split, _run(program).splitlines())}


def symbol_versions(library):
    lines = _run("nm", "--dynamic", "--defined-only", "--format=posix", library).splitlines()
    return dict(line.split()[0].split("@@") for line in lines if "@@" in line)


def soname(library):
    return re.search(r"\(SONAME\).*\[(.*)\]", _run("readelf", "--dynamic", "--wide", library)).group(1)


def _signature(function):
    return f"{function.result}({', '.join(str(parameter.type) for parameter in function.parameters)})"


def _growth(struct, interface, first_sizes):
    if struct.name in first_sizes:
        return f"grows from {first_sizes[struct.name]}"
    fields = [field for other in interface.structs for field in other.fields if field.type.base == struct.name]
    return "grows by stride" if fields and all(field.type.pointers for field in fields) else "fixed"


def _struct_facts(struct, interface, sizes, first_sizes):
    yield ("struct", struct.name), f"{sizes['struct', struct.name]} {_growth(struct, interface, first_sizes)}"
    for field in struct.fields:
        place = struct.name, field.name
        kind = f"{field.type}[{field.count}]" if field.count else str(field.type)
        yield ("field", *place), f"{sizes['offset', *place]} {sizes['size', *place]} {kind}"


def describe(interface, layout_program, library, structs_header):
    """The facts of a build; `interface` is what its header declares."""
    sizes, versions = measured(layout_program), symbol_versions(library)
    first_sizes = dict(FIRST_SIZE.findall(structs_header))
    facts = {("soname",): soname(library)}
    for constant in interface.constants():
        if constant.name not in VERSIONS:
            facts["constant", constant.name] = sizes["value", constant.name]
    for kind, items in (("enum", interface.enums), ("handle", interface.handles), ("alias", interface.aliases)):
        facts |= {(kind, item.name): sizes[kind, item.name] for item in items if item.name}
    for struct in interface.structs:
        facts |= dict(_struct_facts(struct, interface, sizes, first_sizes))
    facts |= {("callback", callback.name): _signature(callback) for callback in interface.callbacks}
    for function in interface.functions:
        facts["function", function.name] = f"{versions.get(function.name, 'none')} {_signature(function)}"
    return facts
