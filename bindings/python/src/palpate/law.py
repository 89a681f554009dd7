"""What pushes of what is found."""

from typing import Literal

from . import _raw
from ._errors import InvalidArgument

Law = Literal["springs", "smooth"]
_LAWS = {"springs": _raw.PLP_LAW_SPRINGS, "smooth": _raw.PLP_LAW_SMOOTH}


def law_number(law: str) -> int:
    if law not in _LAWS:
        raise InvalidArgument(f"law is {law!r}, which is none of {', '.join(_LAWS)}")
    return _LAWS[law]
