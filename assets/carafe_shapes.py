"""Builds the objects of carafe.py: vessels and what fills them, cut glass, fruit, a twig."""

import math
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, "..", "bench", "scenes"))

# pylint: disable=wrong-import-position
from solids import Solid, lathe, loft, sheet, smooth_line, tube, vessel
import textures
from vectors import layers, noise

SEGMENTS = 80


def offset(profile, distance):
    """A profile (radius, y) moved along its normals, to the right of the way it runs."""
    moved = []
    for k, (r, y) in enumerate(profile):
        (r0, y0), (r1, y1) = profile[max(k - 1, 0)], profile[min(k + 1, len(profile) - 1)]
        length = math.hypot(r1 - r0, y1 - y0)
        moved.append((0.0 if r == 0 else r + distance * (y1 - y0) / length,
                      y - distance * (r1 - r0) / length))
    return moved


def below(profile, level):
    """The part of a profile under a height, with a last point at that height."""
    kept = []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        kept.append((r0, y0))
        if y1 >= level:
            share = (level - y0) / (y1 - y0)
            return kept + [(r0 + share * (r1 - r0), level)]
    raise ValueError("the level is above the rim")


def filling(inside, level, reach=0.0008, surface=None):
    """The liquid in a vessel, which reaches into its wall; `surface(x, z)` raises its top."""
    side = below(offset(inside, reach), level)
    edge = side[-1][0]
    rings = 34 if surface else 6
    top = [(edge * (1 - k / rings), level) for k in range(1, rings + 1)]
    top[-1] = (0.0, level)
    solid = lathe(side + top, SEGMENTS)
    if not surface:
        return solid
    first = 1 + SEGMENTS * (len(side) - 1)  # the bottom is one point

    def raised(p):
        fade = 1 - (math.hypot(p[0], p[2]) / edge) ** 8
        return p[0], p[1] + fade * surface(p[0], p[2]), p[2]

    return Solid(solid.points[:first] + [raised(p) for p in solid.points[first:]], solid.faces)


def carafe(height=0.265, belly=0.068, wall=0.0028):
    """A carafe with a flared lip: its glass, and the profile of its inside."""
    corners = [(0.72, 0.004), (0.93, 0.025), (1.0, 0.062), (0.9, 0.104), (0.6, 0.142), (0.34, 0.172),
               (0.29, 0.203), (0.34, 0.235), (0.54, height)]
    side = smooth_line([(belly * r, y) for r, y in corners], 4)
    foot = [(0, 0.0015), (belly * 0.5, 0.001), (belly * 0.62, 0.0)] + smooth_line(
        [(belly * 0.66, 0.0006), (belly * 0.69, 0.002), side[0]], 3)
    outside = foot[:-1] + side
    lip = [(side[-1][0] - 0.0004, height + 0.0011), (side[-1][0] - 0.0014, height + 0.0015),
           (side[-1][0] - 0.0024, height + 0.001)]
    inner = offset(side, -wall)
    floor = smooth_line([(0, 0.0085), (belly * 0.4, 0.0087), (belly * 0.62, 0.0102),
                         (inner[3][0] - 0.0015, 0.0145), inner[5]], 4)
    inside = floor[:-1] + inner[5:]
    return vessel(outside + lip, inside, SEGMENTS), inside


def bowl(radius=0.082, height=0.062, wall=0.0032):
    """A round glass bowl: its glass, and the profile of its inside."""
    side = smooth_line([(radius * 0.46, 0.003), (radius * 0.76, 0.014), (radius * 0.95, 0.034),
                        (radius, height)], 6)
    foot = [(0, 0.002), (radius * 0.3, 0.0016), (radius * 0.38, 0.0), (radius * 0.43, 0.0008)]
    lip = [(radius - 0.0005, height + 0.0013), (radius - 0.0016, height + 0.0017),
           (radius - 0.0027, height + 0.0012)]
    inner = offset(side, -wall)
    floor = smooth_line([(0, 0.0075), (radius * 0.22, 0.0076), inner[2]], 4)
    inside = floor[:-1] + inner[2:]
    return vessel(foot + side + lip, inside, SEGMENTS), inside


def ripples(height):
    """Waves of two drops and a breath of wind, in metres."""
    def surface(x, z):
        total = 0.0
        for cx, cz, length, strength in ((-0.022, 0.013, 0.0165, 1.0), (0.035, -0.024, 0.0135, 0.55)):
            r = math.hypot(x - cx, z - cz)
            total += strength * math.cos(2 * math.pi * r / length) * math.exp(-r / 0.045)
        return height * (total + 0.5 * noise(60 * x, 60 * z, 3))
    return surface


def _facet_grid(columns, rows, fine, place):
    """Rings of points on a pattern of diamonds with raised middles.

    place(column, row, raised) is a corner of the pattern. Each cell of it is two triangles; it is
    divided into fine x fine cells, so that every ring has as many points as a smooth wall.
    """
    rings = []
    for j in range(rows * fine + 1):
        row, b = min(divmod(j, fine), (rows - 1, fine))  # the last ring ends the last row
        ring = []
        for i in range(columns * fine):
            column, a = divmod(i, fine)
            ring.append(_on_facets(column, row, a / fine, b / fine, columns, place))
        rings.append(ring)
    return rings


def _on_facets(column, row, a, b, columns, place):
    """The point at (a, b) of a cell, on the triangle that holds it."""
    def corner(i, j):
        return place((column + i) % columns, row + j, (column + i + row + j) % 2 == 0)

    if (column + row) % 2 == 0:  # split from its lower right to its upper left corner
        far, s, t = ((0, 0), 1 - a, 1 - b) if a + b <= 1 else ((1, 1), a, b)
        ends = ((1, 0), (0, 1)) if far == (0, 0) else ((0, 1), (1, 0))
        weights = (s + t - 1, 1 - s, 1 - t)
    else:
        far, s, t = ((1, 0), a, 1 - b) if a >= b else ((0, 1), 1 - a, b)
        ends = ((0, 0), (1, 1)) if far == (1, 0) else ((1, 1), (0, 0))
        weights = (s + t - 1, 1 - s, 1 - t)
    points = [corner(*far), corner(*ends[0]), corner(*ends[1])]
    return tuple(sum(w * p[k] for w, p in zip(weights, points)) for k in range(3))


def cut_tumbler(radius=0.041, height=0.094, rows=6, columns=24, fine=2):
    """A heavy tumbler cut with diamonds: its glass, and the profile of its inside."""
    low, high = 0.009, height * 0.66

    def place(column, row, raised):
        y = low + (high - low) * row / rows
        r = radius * (0.9 + 0.1 * y / height) + (0.0 if raised else -0.0032)
        turn = 2 * math.pi * column / columns
        return r * math.cos(turn), y, -r * math.sin(turn)

    def ring(r, y):
        count = columns * fine
        return [(r * math.cos(2 * math.pi * k / count), y, -r * math.sin(2 * math.pi * k / count))
                for k in range(count)]

    inside = [(0, 0.0175), (radius * 0.4, 0.0176)] + smooth_line(
        [(radius * 0.62, 0.0182), (radius * 0.74, 0.021), (radius * 0.8, 0.028),
         (radius * 0.845, high), (radius * 0.94, height)], 6)
    rings = [[(0, 0.0008, 0)], ring(radius * 0.7, 0.0006), ring(radius * 0.76, 0),
             ring(radius * 0.8, 0.0005)]
    rings += _facet_grid(columns, rows, fine, place)
    rings += [ring(r, y) for r, y in smooth_line(
        [(radius * 0.962, high + 0.003), (radius * 0.985, height * 0.85), (radius, height),
         (radius * 0.985, height + 0.0012), (radius * 0.96, height + 0.0013)], 3)]
    rings += [ring(r, y) for r, y in reversed(inside[1:])] + [[(0, inside[0][1], 0)]]
    return split_quads(loft(rings, caps=False), columns, fine, 4, rows), inside


def split_quads(solid, columns, fine, first_ring, rows):
    """The quads of cut glass as triangles that follow its facets."""
    count = columns * fine
    start = 1 + (first_ring - 1) * count
    faces = []
    for face in solid.faces:
        j, i = divmod(face[0] - start, count)
        if len(face) != 4 or not 0 <= j < rows * fine:
            faces.append(face)
        elif (i // fine + j // fine) % 2 == 0:
            faces += [(face[0], face[1], face[3]), (face[1], face[2], face[3])]
        else:
            faces += [(face[0], face[1], face[2]), (face[0], face[2], face[3])]
    return Solid(solid.points, faces)


def lemon_profile(length=0.078):
    """The outline of a lemon along the Y axis."""
    profile = [(0, -0.5), (0.05, -0.495), (0.095, -0.47), (0.15, -0.425), (0.25, -0.33), (0.33, -0.19),
               (0.355, 0.0), (0.335, 0.18), (0.26, 0.32), (0.16, 0.415), (0.09, 0.455), (0.05, 0.475),
               (0, 0.478)]
    line = [(max(r, 0.0) * length, y * length) for r, y in smooth_line(profile, 4)]
    line[0], line[-1] = (0.0, line[0][1]), (0.0, line[-1][1])
    return line


def lemons(segments=44):
    """A lemon about the origin, and the lower half of one: its peel and its cut."""
    line = lemon_profile()
    middle = max(range(len(line)), key=lambda k: line[k][0])
    rim, y = line[middle]

    def dimpled(profile):
        return lathe(profile, segments).displaced(
            lambda p: 0.0008 * layers(230 * p[0], 230 * p[1], 230 * p[2], 1) +
            0.0018 * noise(30 * p[0], 30 * p[1], 30 * p[2]))

    peel = dimpled(line[:middle + 1])
    edge = peel.points[-segments:]
    face = [[(s * px, y + 0.0004 * (1 - s), s * pz) for px, _, pz in edge] for s in (0.99, 0.5)]
    cut = loft([edge] + face + [[(0, y + 0.0002, 0)]], caps=False)
    return dimpled(line), peel, Solid(cut.points, cut.faces)


def tipped(tip, turn):
    """The quaternion that tips the Y axis towards +z, then turns it about the old one, in degrees."""
    c, s = math.cos(math.radians(tip) / 2), math.sin(math.radians(tip) / 2)
    d, t = math.cos(math.radians(turn) / 2), math.sin(math.radians(turn) / 2)
    return s * d, c * t, -s * t, c * d


def slice_texture(segments=9):
    """A cut lemon about the texture's corner, which repeats: pith, rind and segments of flesh."""
    def pixel(x, y):
        u, v = ((x + 128) % 256 - 128) / 128, ((y + 128) % 256 - 128) / 128
        r, turn = math.hypot(u, v), math.atan2(v, u) * segments / (2 * math.pi)
        membrane = abs(turn - round(turn)) * 2 * math.pi / segments * r
        pulp = 0.5 + 0.5 * noise(40 * turn / segments + 9, 5 * r, 3)
        inside = min(1, max(0, (membrane - 0.015) / 0.02)) if 0.1 < r < 0.7 else 0.0
        flesh = textures.mix((0.88, 0.68, 0.16), (0.97, 0.82, 0.36), pulp)
        outer = textures.mix((0.94, 0.84, 0.55), (0.93, 0.74, 0.12), (r - 0.77) / 0.03)
        return textures.mix(outer, flesh, inside)
    return textures.png(pixel)


def leaf(length, wide, bend):
    """A pointed leaf along +x in the plane y = 0, bent down."""
    def place(u, v):
        half = wide * max(0.02, math.sin(math.pi * u)) ** 0.8 * (1 - 0.35 * u)
        side = 2 * v - 1
        return (length * u, -bend * length * u * u + 0.25 * half * abs(side), -half * side)
    return sheet(10, 2, place)


def twig(path, leaves, length, wide):
    """A twig along a path with leaves in pairs: (stem, leaves)."""
    line = smooth_line(path, 6)
    last = len(line) - 1
    stem = tube(line, [0.0016 - 0.001 * k / last for k in range(last + 1)], 8)
    result = []
    for k in range(leaves):
        at = line[round(last * (0.3 + 0.7 * k / (leaves - 1)))]
        size = length * (0.75 + 0.25 * math.sin(2.4 * k)) * (1 - 0.35 * k / leaves)
        blade = leaf(size, wide * size, 0.25).turned("z", 28 + 20 * math.sin(1.7 * k))
        blade = blade.turned("y", 137.5 * k)
        result.append(blade.moved(*at))
    return stem, result
