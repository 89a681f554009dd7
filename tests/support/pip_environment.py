"""Environments of Python with packages from PyPI, which are kept from one run of a test to the next."""

import sys

from commands import Failed, run


class Unavailable(Exception):
    """The packages cannot be had: its text says which and why."""


def pip_environment(folder, packages, venv_options=(), pip_options=()):
    """The path of its Python."""
    python, made = folder / "bin" / "python", folder / "made"
    if made.exists() and made.read_text() == "\n".join(packages):
        return python
    try:
        run(sys.executable, "-m", "venv", "--clear", *venv_options, folder)
        run(folder / "bin" / "pip", "install", "--quiet", "--retries", "1", "--timeout", "20", *pip_options, *packages)
    except Failed as error:
        raise Unavailable(f"{' and '.join(packages)} cannot be had ({str(error).splitlines()[-1]})") from None
    made.write_text("\n".join(packages))
    return python
