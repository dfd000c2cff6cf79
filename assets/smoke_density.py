"""The density of the smoke of effects.py: a plume with eddies, as a Mitsuba 0.6 .vol grid.

By sums, products and square roots alone, so that every machine writes the same bytes."""

import functools
import math
import struct

NODES = (22, 34, 22)


@functools.cache
def hashed(x, y, z):
    """0 to 1, by three integers."""
    mixed = (x * 73856093 ^ y * 19349663 ^ z * 83492791) & 0xFFFFFFFF
    for _ in range(2):
        mixed = ((mixed ^ (mixed >> 15)) * 0x2C1B3C6D) & 0xFFFFFFFF
    return (mixed ^ (mixed >> 16)) / 0xFFFFFFFF


@functools.cache  # the bends of a height are those of all its nodes
def noise(x, y, z):
    """Between the numbers of the corners of a cell, without a kink at its sides."""
    cell = [math.floor(v) for v in (x, y, z)]
    share = [v - c for v, c in zip((x, y, z), cell)]
    share = [s * s * (3 - 2 * s) for s in share]
    total = 0
    for corner in range(8):
        step = [corner >> i & 1 for i in range(3)]
        weight = 1
        for s, up in zip(share, step):
            weight *= s if up else 1 - s
        total += weight * hashed(*(c + up for c, up in zip(cell, step)))
    return total


def density(x, y, z):
    """x, z: -1 to 1.  y: 0 to 1."""
    eddies = sum(noise(3 * f * x + 9, 5 * f * y, 3 * f * z + 5) / f for f in (1, 2, 4)) / 1.75
    x += 0.9 * y * (noise(1, 4 * y, 1) - 0.5)
    z += 0.9 * y * (noise(7, 4 * y, 3) - 0.5)
    wide = 0.25 + 0.5 * y
    inside = 1 - math.sqrt(x * x + z * z) / wide + 1.1 * (eddies - 0.5)
    fades = min(1, 8 * (1 - y)) * min(1, 12 * y)
    return max(0, min(1, 2.5 * inside)) * fades * (0.25 + 1.5 * eddies * eddies) / wide / 2


def write(path):
    nx, ny, nz = NODES
    values = [density(2 * x / (nx - 1) - 1, y / (ny - 1), 2 * z / (nz - 1) - 1)
              for z in range(nz) for y in range(ny) for x in range(nx)]
    header = b"VOL\x03" + struct.pack("<5i6f", 1, nx, ny, nz, 1, -1, 0, -1, 1, 1, 1)
    with open(path, "wb") as file:
        file.write(header + struct.pack(f"<{len(values)}f", *values))
