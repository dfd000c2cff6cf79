"""Reads pictures with nothing but the standard library."""

import struct
import zlib


class Picture:
    """rows: from the top; a pixel is a tuple of three numbers."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def pixels(self):
        return [pixel for row in self.rows for pixel in row]

    def mean(self, x0=0, y0=0, x1=None, y1=None):
        """Mean of each channel over columns x0 to x1 and rows y0 to y1, the ends left out."""
        chosen = [pixel for row in self.rows[y0:y1] for pixel in row[x0:x1]]
        return tuple(sum(channel) / len(chosen) for channel in zip(*chosen))


def group(numbers, width):
    """Flat numbers as rows of pixels."""
    pixels = list(zip(numbers[0::3], numbers[1::3], numbers[2::3]))
    return [pixels[i:i + width] for i in range(0, len(pixels), width)]


def read_pfm(path):
    with open(path, "rb") as file:
        assert file.readline() == b"PF\n", f"{path}: not a colour PFM"
        width, height = map(int, file.readline().split())
        assert float(file.readline()) < 0, f"{path}: not little endian"
        data = file.read()
    numbers = struct.unpack(f"<{3 * width * height}f", data)
    return Picture(width, height, group(numbers, width)[::-1])


def png_chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    at = 8
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + length]
        crc, = struct.unpack_from(">I", data, at + 8 + length)
        assert crc == zlib.crc32(kind + body), f"PNG chunk {kind} is damaged"
        yield kind, body
        at += 12 + length


def paeth(left, up, corner):
    guess = left + up - corner
    return min((abs(guess - left), 0, left), (abs(guess - up), 1, up),
               (abs(guess - corner), 2, corner))[2]


def undo_filter(kind, line, above):
    """One line of a PNG of three bytes a pixel."""
    out = bytearray(line)
    for i, byte in enumerate(line):
        left = out[i - 3] if i >= 3 else 0
        corner = above[i - 3] if i >= 3 else 0
        up = above[i]
        added = (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]
        out[i] = (byte + added) & 255
    return out


def read_png(path):
    """An 8-bit RGB picture without interlace."""
    with open(path, "rb") as file:
        chunks = list(png_chunks(file.read()))
    width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", chunks[0][1])
    assert (depth, colour, interlace) == (8, 2, 0), f"{path}: not plain 8-bit RGB"
    raw = zlib.decompress(b"".join(body for kind, body in chunks if kind == b"IDAT"))
    stride = 3 * width
    above, rows = bytearray(stride), []
    for y in range(height):
        start = y * (stride + 1)
        above = undo_filter(raw[start], raw[start + 1:start + 1 + stride], above)
        rows += group(above, width)
    return Picture(width, height, rows)
