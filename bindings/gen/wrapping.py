"""Lines that are no longer than the project has them."""

WIDTH = 120


def wrapped(opening, parts, closing):
    """On as few lines as fit, aligned behind what opens."""
    if not parts:
        return opening + closing
    lines, line = [], opening
    for index, part in enumerate(parts):
        piece = part + ("," if index + 1 < len(parts) else closing)
        space = "" if line == opening or not line.strip() else " "
        if len(line + space + piece) > WIDTH:
            lines.append(line)
            line, space = " " * len(opening), ""
        line += space + piece
    return "\n".join([*lines, line])
