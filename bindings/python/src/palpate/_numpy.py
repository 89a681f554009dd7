"""numpy, or None where it is not installed."""

import importlib
from typing import Any

numpy: Any
try:
    numpy = importlib.import_module("numpy")
except ImportError:
    numpy = None
