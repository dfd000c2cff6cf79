"""Draws textures as PNG files: wood, cloth, stone, paintings, brushed metal, normal maps."""

import math
import random
import struct
import zlib

from vectors import layers, noise

SIZE = 256


def png(pixel, size=SIZE):
    """A square RGB image of pixel(x, y), from 0 to 1 in sRGB, from the top left."""
    rows = bytearray()
    for y in range(size):
        rows.append(0)
        for x in range(size):
            for value in pixel(x, y):
                rows.append(max(0, min(255, round(255 * value))))

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def mix(a, b, t):
    t = max(0.0, min(1.0, t))
    return tuple(p + t * (q - p) for p, q in zip(a, b))


def wood(dark, light, seed=0, rings=9):
    """Grain that runs along v."""
    def pixel(x, y):
        u, v = x / SIZE, y / SIZE
        bend = noise(4 * u, 2 * v, seed, 2)
        line = 0.5 + 0.5 * math.sin(2 * math.pi * (rings * u + 0.6 * bend))
        fine = noise(64 * u, 4 * v, seed + 7, 4)
        return mix(dark, light, 0.25 + 0.5 * line + 0.25 * fine)
    return png(pixel)


def weave(a, b, threads=32):
    """Cloth of two colours of thread."""
    def pixel(x, y):
        u, v = x * threads / SIZE, y * threads / SIZE
        over = (math.floor(u) + math.floor(v)) % 2
        round_u, round_v = math.sin(math.pi * (u % 1)), math.sin(math.pi * (v % 1))
        shade = 0.65 + 0.35 * (round_u if over else round_v)
        return tuple(shade * c for c in (a if over else b))
    return png(pixel)


def stone(base, vein, seed=0, scale=4):
    """Marble: veins where noise crosses zero."""
    def pixel(x, y):
        u, v = scale * x / SIZE, scale * y / SIZE
        n = layers(u, v, seed, 4, scale)
        cloud = layers(u, v, seed + 20, 2, scale)
        return mix(mix(base, vein, 0.25 + cloud), vein, 1 - 9 * abs(n))
    return png(pixel)


def speckle(base, spread, seed=0, cells=64):
    """Grains of one colour in many shades: plaster, concrete, terrazzo."""
    def pixel(x, y):
        n = noise(cells * x / SIZE, cells * y / SIZE, seed, cells)
        m = noise(8 * x / SIZE, 8 * y / SIZE, seed + 5, 8)
        return tuple(c + spread * (0.6 * n + 0.4 * m) for c in base)
    return png(pixel)


def stripes(colors, seed=0, count=24):
    """Bands of random colours and widths along v, as on a rug."""
    draw = random.Random(seed)
    edges = sorted(draw.random() for _ in range(count))
    picks = [draw.choice(colors) for _ in range(count + 1)]

    def pixel(x, y):
        v = 2 * min(y, SIZE - 1 - y) / SIZE
        band = sum(edge < v for edge in edges)
        knot = 0.85 + 0.15 * math.sin(x * math.pi / 4) * math.sin(y * math.pi / 4)
        zigzag = (x // 8 + y // 8) % 2 == 0 and band % 3 == 0
        return tuple(knot * (0.75 if zigzag else 1) * c for c in picks[band])
    return png(pixel)


def painting(seed):
    """An abstract painting: discs over a graded ground."""
    draw = random.Random(seed)
    ground = [[draw.uniform(0.1, 0.85) for _ in range(3)] for _ in range(2)]
    discs = [(draw.random(), draw.random(), draw.uniform(0.05, 0.28),
              [draw.uniform(0.05, 0.9) for _ in range(3)]) for _ in range(9)]

    def pixel(x, y):
        u, v = x / SIZE, y / SIZE
        color = mix(ground[0], ground[1], v + 0.2 * noise(6 * u, 6 * v, seed))
        for cx, cy, radius, own in discs:
            if math.hypot(u - cx, v - cy) < radius * (1 + 0.1 * noise(9 * u, 9 * v, seed + 3)):
                color = mix(color, own, 0.8)
        return color
    return png(pixel)


def landscape(seed):
    """Hills below a sunset, for a screen or a postcard."""
    def pixel(x, y):
        u, v = x / SIZE, y / SIZE
        color = mix((0.15, 0.3, 0.65), (1.0, 0.65, 0.35), 1.6 * v)
        for k in range(4):
            ridge = 0.45 + 0.13 * k + 0.12 * layers(3 * u + 5 * k, 0.5, seed + k)
            if v > ridge:
                color = mix((0.35, 0.3, 0.45), (0.03, 0.12, 0.06), k / 3)
        return color
    return png(pixel)


def veins(dark, light):
    """A leaf: a midrib along v and side veins."""
    def pixel(x, y):
        u, v = abs(x / SIZE - 0.5), y / SIZE
        rib = u < 0.02 or abs((12 * (v - u)) % 1 - 0.5) < 0.06
        return light if rib else mix(dark, light, 0.25 + 0.25 * noise(16 * u, 16 * v))
    return png(pixel)


def brushed(low, high, seed=0):
    """A metallic-roughness texture: roughness in green, brushed along u; metallic in blue."""
    def pixel(x, y):
        n = 0.5 + 0.5 * noise(4 * x / SIZE, 96 * y / SIZE, seed, 4)
        return 0, low + (high - low) * n, 1
    return png(pixel)


def bumps(height, strength=1.0):
    """A normal map of height(u, v), which must repeat after 1."""
    step = 1 / SIZE

    def pixel(x, y):
        u, v = (x + 0.5) / SIZE, (y + 0.5) / SIZE
        dx = strength * (height(u + step, v) - height(u - step, v)) / (2 * step)
        dy = strength * (height(u, v - step) - height(u, v + step)) / (2 * step)
        length = math.sqrt(dx * dx + dy * dy + 1)
        return 0.5 - dx / length / 2, 0.5 - dy / length / 2, 0.5 + 0.5 / length
    return png(pixel)


def grain_bumps(cells=24, strength=0.01, seed=0):
    """A normal map of grain as on leather or hammered metal."""
    return bumps(lambda u, v: noise(cells * u, cells * v, seed, cells), strength)
