"""The golden vectors of space_vectors.json in lines, for languages that have no reader of JSON at hand: a word and its
numbers or, for `name`, its text. A name begins a space."""

import json
from pathlib import Path

VECTORS = Path(__file__).with_name("space_vectors.json")


def numbers(value):
    return [number for part in value for number in numbers(part)] if isinstance(value, list) else [value]


def vector_lines():
    vectors = json.loads(VECTORS.read_text())
    lines = []
    for told in vectors["spaces"]:
        lines += [f"name {told.pop('name')}", f"stiffness {vectors['stiffness']}"]
        for part in ("body", "tool"):
            told |= {f"{part}.{name}": value for name, value in told.pop(part).items()}
        lines += [" ".join([word, *map(repr, numbers(value))]) for word, value in told.items()]
    return "\n".join(lines) + "\n"
