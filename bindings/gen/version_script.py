"""The linker's version script: what leaves the library, under the version that brought it."""


def _order(version):
    return [int(part) for part in version.split(".")]


def emit(interface):
    versions = sorted({function.since for function in interface.functions}, key=_order)
    blocks, before = [], ""
    for version in versions:
        names = sorted(function.name for function in interface.functions if function.since == version)
        symbols = "".join(f"    {name};\n" for name in names)
        hidden = "" if before else "  local:\n    *;\n"
        blocks.append(f"PALPATE_{version} {{\n  global:\n{symbols}{hidden}}}{before};\n")
        before = f" PALPATE_{version}"
    return "\n".join(blocks)
