"""Finds and opens the native library."""

import ctypes
import os
from collections.abc import Iterator
from pathlib import Path

ENVIRONMENT = "PALPATE_LIBRARY"
SONAME = "libpalpate.so.0"


def _candidates() -> Iterator[str]:
    """What the environment names and nothing else, or the wheel's own copy before what the loader finds."""
    named = os.environ.get(ENVIRONMENT)
    if named:
        yield named
        return
    yield from map(str, sorted(Path(__file__).parent.glob("libpalpate.so*")))
    yield SONAME


def load() -> ctypes.CDLL:
    failures = []
    for candidate in _candidates():
        try:
            return ctypes.CDLL(candidate)
        except OSError as error:
            failures.append(str(error))
    raise ImportError(f"the native library of palpate is not there ({'; '.join(failures)}); "
                      f"install it, or name its file in the environment variable {ENVIRONMENT}")
