"""Reads the float channels of an .exr file that hipmap wrote, with nothing but the standard library."""

import struct
import zlib

ZIP_COMPRESSION, LINES_OF_A_BLOCK = 3, 16
FLOAT = 2


def _text(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def _header(data, at):
    """The attributes of a header as bytes by name, and where it ends."""
    attributes = {}
    while data[at] != 0:
        name, at = _text(data, at)
        _, at = _text(data, at)
        size, = struct.unpack_from("<i", data, at)
        attributes[name] = data[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def _channel_names(listed):
    at, names = 0, []
    while listed[at] != 0:
        name, at = _text(listed, at)
        kind, = struct.unpack_from("<i", listed, at)
        assert kind == FLOAT, f"channel {name} is not of floats"
        names.append(name)
        at += 16
    return names


def _unpacked(block, size):
    """Undoes zip, the differences between bytes, and the sorting into even and odd ones."""
    if len(block) == size:
        return block
    raw = bytearray(zlib.decompress(block))
    for i in range(1, size):
        raw[i] = (raw[i - 1] + raw[i] - 128) & 255
    half = (size + 1) // 2
    out = bytearray(size)
    out[0::2], out[1::2] = raw[:half], raw[half:]
    return out


class ExrFile:
    """width, height; attributes: bytes by name; channels: floats by name, rows from the top."""

    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        assert data[:4] == b"\x76\x2f\x31\x01", f"{path}: not an EXR"
        self.attributes, at = _header(data, 8)
        assert self.attributes["compression"][0] == ZIP_COMPRESSION, path
        left, top, right, bottom = struct.unpack("<4i", self.attributes["dataWindow"])
        self.width, self.height = right - left + 1, bottom - top + 1
        names = _channel_names(self.attributes["channels"])
        self.channels = {name: [] for name in names}
        for y in range(0, self.height, LINES_OF_A_BLOCK):
            place, = struct.unpack_from("<Q", data, at + 8 * (y // LINES_OF_A_BLOCK))
            self._read_block(data, place, min(LINES_OF_A_BLOCK, self.height - y))

    def _read_block(self, data, place, lines):
        _, packed = struct.unpack_from("<ii", data, place)
        size = 4 * self.width * lines * len(self.channels)
        values = _unpacked(data[place + 8:place + 8 + packed], size)
        for i in range(lines * len(self.channels)):
            name = list(self.channels)[i % len(self.channels)]
            self.channels[name] += struct.unpack_from(f"<{self.width}f", values, 4 * self.width * i)
