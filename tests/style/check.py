"""check.py RULE ROOT: prints the violations of one rule; exit 1 if there are any."""

import sys
from pathlib import Path

import rules


def main():
    rule, root = sys.argv[1:]
    violations = getattr(rules, rule)(Path(root))
    for violation in violations:
        print(violation)
    return 1 if violations else 0


if __name__ == "__main__":
    sys.exit(main())
