"""check_links.py ROOT: every link in a page of the project leads somewhere, and every folder of the engine has its line
in engine/README.md."""

import re
import sys
from pathlib import Path

LINK = re.compile(r"\[[^\]]*\]\(([^)#:\s]*)(?:#([\w-]+))?\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
LISTED = re.compile(r"^\| `(\w+)` \|", re.MULTILINE)


def anchors(page):
    """The places of a page that a link may name, as forges make them of headings."""
    kept = (re.sub(r"[^\w\- ]", "", heading.lower()) for heading in HEADING.findall(page.read_text()))
    return {heading.replace(" ", "-") for heading in kept}


def dead_links(root, page):
    for target, anchor in LINK.findall(page.read_text()):
        to = page.parent / target if target else page
        if not to.exists():
            yield f"{page.relative_to(root)} links to {target}, which is not there"
        elif anchor and to.suffix == ".md" and anchor not in anchors(to):
            yield f"{page.relative_to(root)} links to #{anchor} of {to.name}, which has no such heading"


def unlisted_folders(root):
    folders = {entry.name for entry in (root / "engine").iterdir() if entry.is_dir()}
    listed = set(LISTED.findall((root / "engine" / "README.md").read_text()))
    return [f"engine/README.md and engine/ differ: {name}" for name in sorted(folders ^ listed)]


def pages(root):
    """All but those that builds leave."""
    for page in sorted(root.rglob("*.md")):
        if "build" not in page.relative_to(root).parts:
            yield page


def main(root):
    found = [sentence for page in pages(root) for sentence in dead_links(root, page)] + unlisted_folders(root)
    return "\n".join(found) or 0


sys.exit(main(Path(sys.argv[1]).resolve()))
