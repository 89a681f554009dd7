"""Reads the pixels of a PNG file. Needs nothing but Python."""

import colorsys
import struct
import zlib
from pathlib import Path


def _unfiltered(kind, row, above, step):
    """One row, in place: kinds of filter as PNG numbers them."""
    if kind == 2:
        return bytearray((x + up) & 255 for x, up in zip(row, above))
    for i, x in enumerate(row):
        left = row[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        if kind == 1:
            row[i] = (x + left) & 255
        elif kind == 3:
            row[i] = (x + (left + above[i]) // 2) & 255
        elif kind == 4:
            guess = left + above[i] - corner
            distances = abs(guess - left), abs(guess - above[i]), abs(guess - corner)
            row[i] = (x + (left, above[i], corner)[distances.index(min(distances))]) & 255
    return row


class Picture:
    """8-bit RGB without interlacing."""

    def __init__(self, path):
        data = Path(path).read_bytes()
        assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG file"
        packed, place = b"", 8
        while place < len(data):
            size, kind = struct.unpack(">I4s", data[place:place + 8])
            content = data[place + 8:place + 8 + size]
            if kind == b"IHDR":
                self.width, self.height, depth, colour = struct.unpack(">IIBB", content[:10])
                assert (depth, colour) == (8, 2), "not 8-bit RGB"
            packed += content if kind == b"IDAT" else b""
            place += 12 + size
        self.rows, flat, size = [], zlib.decompress(packed), 3 * self.width
        above = bytearray(size)
        for y in range(self.height):
            begin = y * (size + 1)
            above = _unfiltered(flat[begin], bytearray(flat[begin + 1:begin + 1 + size]), above, 3)
            self.rows.append(above)

    def pixels(self, left, top, right, bottom, step=1):
        """x, y and the colour of each pixel within, or of those `step` apart."""
        for y in range(top, bottom, step):
            row = self.rows[y]
            for x in range(left, right, step):
                yield x, y, tuple(row[3 * x:3 * x + 3])


def is_hue(colour, low, high, saturation):
    """Whether a colour's hue is within so many degrees, it is at least so saturated, and not dark."""
    hue, saturated, value = colorsys.rgb_to_hsv(*(channel / 255 for channel in colour))
    return low <= 360 * hue <= high and saturated >= saturation and value >= 0.3
