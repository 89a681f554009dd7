"""check_comments.py HEADER: fails for each function whose comment does not say all that a caller has to know."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings" / "gen"))

import function_comments  # noqa: E402
import header  # noqa: E402

sys.exit("\n".join(function_comments.lacks(header.parse(Path(sys.argv[1]).read_text()))) or 0)
