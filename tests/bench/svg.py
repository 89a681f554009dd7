"""Draws charts with logarithmic axes as SVG. Needs nothing but Python; the same data give the same bytes."""

import math
from html import escape

COLOURS = {"blue": "#2f6db5", "green": "#2d8a57", "orange": "#c9722b", "red": "#b8413d", "violet": "#7a57a8",
           "grey": "#7d8590"}
INK, FAINT = "#30363d", "#d0d7de"


class Axis:
    """Maps values from low to high to the pixels from start to end, logarithmically."""

    def __init__(self, low, high, start, end):
        self.low, self.high = math.log10(low), math.log10(high)
        self.start, self.end = start, end

    def __call__(self, value):
        share = (math.log10(value) - self.low) / (self.high - self.low)
        return self.start + min(1.0, max(0.0, share)) * (self.end - self.start)

    def decades(self):
        return [10.0 ** k for k in range(math.ceil(self.low - 1e-9), math.floor(self.high + 1e-9) + 1)]


def number(value):
    return f"{value:,.0f}" if value >= 1 else f"{value:g}"


class Drawing:
    def __init__(self, width, height, title):
        self.width, self.height = width, height
        self.parts = []
        self.text(width / 2, 24, title, anchor="middle", size=16, weight="bold")

    def line(self, points, colour, width=1.5, dash=""):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="{width}"{dashed}/>')

    def dot(self, x, y, colour, radius=4):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{colour}"/>')

    def box(self, x, y, width, height, colour):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" fill="{colour}"/>')

    def text(self, x, y, text, anchor="start", size=11, colour=INK, weight="normal", turn=0):
        if not text:
            return
        turned = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" fill="{colour}" '
                          f'font-weight="{weight}"{turned}>{escape(text)}</text>')

    def write(self, path):
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                f'font-family="sans-serif"><rect width="100%" height="100%" fill="white"/>')
        path.write_text("\n".join([head, *self.parts, "</svg>", ""]), encoding="utf-8")


class Chart:
    """A frame with logarithmic axes inside a drawing; without a range of y it has only that of x."""

    def __init__(self, drawing, place, x_range, y_range, title, x_label, y_label):
        left, top, width, height = place
        self.drawing = drawing
        self.x = Axis(*x_range, left, left + width)
        for value in self.x.decades():
            drawing.line([(self.x(value), top), (self.x(value), top + height)], FAINT, 1)
            drawing.text(self.x(value), top + height + 15, number(value), "middle")
        if y_range:
            self.y = Axis(*y_range, top + height, top)
            for value in self.y.decades():
                drawing.line([(left, self.y(value)), (left + width, self.y(value))], FAINT, 1)
                drawing.text(left - 6, self.y(value) + 4, number(value), "end")
            drawing.text(left - 46, top + height / 2, y_label, "middle", turn=-90)
        drawing.text(left + width / 2, top - 8, title, "middle", 13, weight="bold")
        drawing.text(left + width / 2, top + height + 32, x_label, "middle")

    def points(self, values):
        return [(self.x(x), self.y(y)) for x, y in values]

    def line(self, values, colour, dash=""):
        self.drawing.line(self.points(values), colour, dash=dash)

    def dots(self, values, colour):
        for x, y in self.points(values):
            self.drawing.dot(x, y, colour)

    def label(self, value, text, colour, right=True):
        (x, y), = self.points([value])
        self.drawing.text(x + (7 if right else -7), y - 5, text, "start" if right else "end", 10, colour)
