"""Builds what a museum hall is made of: fluted columns, coffers, a stone inlay, showcases, benches."""

import math

import vectors as v3
from solids import (Solid, bevelled_box, inset, joined, lathe, level, loft, rounded_outline,
                    smooth_line, tube)


def fluted_shaft(radius, low, high, flutes, arc_steps, rows):
    """The shaft of a column with sharp arrises between its flutes; it narrows upwards."""
    rings = []
    for row in range(rows + 1):
        t = row / rows
        r = radius * (1 - 0.17 * t * t)
        ring = []
        for k in range(flutes * arc_steps):
            flute, step = divmod(k, arc_steps)
            a = 2 * math.pi * (flute + step / arc_steps) / flutes
            depth = math.sin(math.pi * step / arc_steps) ** 0.75 * 0.55 * math.pi * r / flutes
            ring.append(((r - depth) * math.cos(a), low + (high - low) * t, -(r - depth) * math.sin(a)))
        rings.append(ring)
    return loft(rings, caps=False)


def column(radius, high, flutes, arc_steps, rows, segments):
    """A column on a square plinth: (fluted shaft, base and capital)."""
    shaft = fluted_shaft(radius, 0.38, high - 0.42, flutes, arc_steps, rows)
    def torus(r, y, thick):
        return [(r + thick * math.sin(a), y - thick * math.cos(a))
                for a in (math.pi * k / 8 for k in range(9))]
    base = lathe([(radius * 1.3, 0.1505)] + torus(radius * 1.3, 0.2, 0.045) +
                 smooth_line([(radius * 1.22, 0.25), (radius * 1.12, 0.275), (radius * 1.2, 0.3)], 5) +
                 torus(radius * 1.15, 0.33, 0.028) + [(radius * 1.04, 0.36), (radius * 1.0, 0.4)], segments)
    neck = radius * 0.83
    capital = lathe([(neck * 0.94, high - 0.44), (neck * 1.06, high - 0.43), (neck * 1.06, high - 0.4),
                     (neck * 1.02, high - 0.39)] + smooth_line(
        [(neck * 1.03, high - 0.34), (neck * 1.2, high - 0.25), (neck * 1.45, high - 0.17),
         (neck * 1.5, high - 0.13), (neck * 1.4, high - 0.1205)], 5), segments)
    plinth = bevelled_box(radius * 2.9, 0.15, radius * 2.9, 0.006, 1)
    abacus = bevelled_box(radius * 2.7, 0.118, radius * 2.7, 0.006, 1).moved(0, high - 0.12, 0)
    return shaft, joined([base, capital, plinth, abacus])


def square(size, y, x=0.0, z=0.0):
    """Four corners about (x, z), counter-clockwise from above."""
    h = size / 2
    return [(x - h, y, z + h), (x + h, y, z + h), (x + h, y, z - h), (x - h, y, z - h)]


def coffer(size, x, z, y, depth, steps=3, is_open=False):
    """A square of ceiling with a stepped recess, seen from below; `is_open` leaves out its end."""
    inside = size * 0.8
    rings = [square(size, y, x, z), square(inside, y, x, z)]
    for k in range(steps):
        up = y + depth * (k + 1) / steps
        rings.append(square(inside, up, x, z))
        if k < steps - 1 and not is_open:
            inside -= size * 0.1
            rings.append(square(inside, up, x, z))
    solid = loft(rings).flipped()
    keep = slice(None, -2) if is_open else slice(None)
    solid.faces, solid.uvs = solid.faces[keep], solid.uvs[keep]
    if not is_open:
        del solid.faces[-2], solid.uvs[-2]
    return solid


def rosette(radius, petals, per_petal, rows):
    """A flower in relief that hangs down from y = 0, open above."""
    rings = []
    for row in range(rows):
        t = 1 - row / rows
        rings.append([(r * math.cos(a), -0.25 * radius * math.sin(2.6 * t) - 0.02 * radius,
                       r * math.sin(a)) for r, a in (
            (radius * t * (0.72 + 0.28 * abs(math.sin(petals * math.pi * k / (petals * per_petal)))),
             2 * math.pi * k / (petals * per_petal)) for k in range(petals * per_petal))])
    rings.append([(0.0, -0.1 * radius, 0.0)])
    return loft(rings, caps=False)


def _flat(outline, y=0.0):
    """A polygon that faces up, shrunk by half of a joint of 1 mm; outline is (x, -z)."""
    points = [(x, y, -z) for x, z in inset(outline, 0.0005)]
    return Solid(points, [tuple(range(len(points)))])


def _polar(r, a):
    return r * math.cos(a), r * math.sin(a)


def inlay(size):
    """A square panel of polygons of stone at y = 0: lists of solids for four kinds of stone."""
    kinds, eighth = ([], [], [], []), math.pi / 4
    r = [size * f for f in (0.1, 0.2, 0.3, 0.34, 0.4)]
    kinds[0].append(_flat([_polar(r[0], eighth * k) for k in range(8)]))
    for k in range(8):
        a = eighth * k
        kinds[1 + k % 2].append(_flat([_polar(r[0], a), _polar(r[1] * 0.95, a - eighth / 2), _polar(r[2], a),
                                       _polar(r[1] * 0.95, a + eighth / 2)]))
        b = a + eighth / 2
        kinds[0].append(_flat([_polar(r[0], a), _polar(r[1] * 0.95, b), _polar(r[0], a + eighth)]))
        arc = [_polar(r[2], b + eighth * (0.5 - i / 4)) for i in range(5)]
        kinds[3].append(_flat([_polar(r[1] * 0.95, b)] + arc[::-1]))
    for k in range(16):  # all arcs have corners every 11.25 degrees, so that they do not overlap
        a, step = 2 * math.pi * k / 16, 2 * math.pi / 16
        for inner, outer, kind in ((r[2], r[3], k % 2), (r[3], r[4], 2 + k % 2)):
            kinds[kind].append(_flat([_polar(inner, a), _polar(outer, a), _polar(outer, a + step / 2),
                                      _polar(outer, a + step), _polar(inner, a + step),
                                      _polar(inner, a + step / 2)]))
    half, edge = size * 0.43, size / 2
    for k in range(4):
        turn = math.pi / 2 * k
        arc = [_polar(r[4], turn + math.pi / 16 * i) for i in range(8, -1, -1)]
        rule = [(half, 0.0), (half, half), (0.0, half)]
        c, s = math.cos(turn), math.sin(turn)
        kinds[1].append(_flat([(c * x - s * y, s * x + c * y) for x, y in rule] + arc))
        for kind, line in ((3, [(half, -half), (edge, -half), (edge, half), (half, half)]),
                           (0, [(half, half), (edge, half), (edge, edge), (half, edge)])):
            kinds[kind].append(_flat([(c * x - s * y, s * x + c * y) for x, y in line]))
    return kinds


def glass_cover(wide, high, deep, wall):
    """A closed shell of glass on y = 0: five plates of one thickness, open below."""
    def ring(grow, y):
        return level(rounded_outline(wide - 2 * grow, deep - 2 * grow, 0.002 if grow == 0 else 0.001, 2), y)
    return loft([ring(wall, high - wall), ring(wall, 0), ring(0, 0), ring(0, high - 0.001),
                 ring(0.001, high)])


def plinth(wide, high, deep, steps):
    """A plinth with a foot and a head moulding, on y = 0."""
    def ring(grow, y):
        return level(rounded_outline(wide + 2 * grow, deep + 2 * grow, 0.006, steps), y)
    return loft([ring(0.04, 0), ring(0.04, 0.09), ring(0.035, 0.1), ring(0.02, 0.105), ring(0.008, 0.12),
                 ring(0, 0.13), ring(0, high - 0.09), ring(0.008, high - 0.08), ring(0.015, high - 0.06),
                 ring(0.03, high - 0.045), ring(0.03, high - 0.005), ring(0.025, high)])


def bench(wide, slats, steps):
    """A museum bench: (wooden slats, metal frames)."""
    wood = [bevelled_box(wide, 0.035, 0.05, 0.005, 4).moved(0, 0.42, 0.06 * (k - (slats - 1) / 2))
            for k in range(slats)]
    frames = []
    deep = 0.06 * slats / 2
    for x in (-wide / 2 + 0.2, wide / 2 - 0.2):
        path = smooth_line([(x, 0.41, -deep + 0.02), (x, 0.25, -deep), (x, 0.1, -deep - 0.02),
                            (x, 0.04, -deep + 0.02), (x, 0.02, -deep + 0.09), (x, 0.02, 0), (x, 0.02, deep - 0.09),
                            (x, 0.04, deep - 0.02), (x, 0.1, deep + 0.02), (x, 0.25, deep),
                            (x, 0.41, deep - 0.02)], steps)
        frames += [tube(path, 0.018, 16), bevelled_box(0.05, 0.012, 2 * deep, 0.002, 1).moved(x, 0.4075, 0)]
    return joined(wood), joined(frames)


def barrier_post(segments):
    """A brass post with a ball on top."""
    return lathe([(0, 0), (0.15, 0), (0.15, 0.01)] + smooth_line(
        [(0.14, 0.02), (0.05, 0.035), (0.022, 0.06), (0.02, 0.12)], 4) +
        [(0.02, 0.85), (0.03, 0.86), (0.03, 0.89), (0.02, 0.9)] + smooth_line(
            [(0.022, 0.905), (0.035, 0.93), (0.022, 0.958), (0.002, 0.965)], 5) + [(0, 0.965)], segments)


def rope(a, b, sag, radius, steps, sides):
    """A rope that hangs between two points."""
    path = [v3.along(v3.along(a, v3.sub(b, a), k / steps), (0, -1, 0), 4 * sag * (k / steps) * (1 - k / steps))
            for k in range(steps + 1)]
    return tube(path, radius, sides)


def track_light(segments):
    """A spot light's housing about the Y axis, open below at y = 0."""
    return lathe([(0.048, 0.01), (0.05, 0), (0.052, 0), (0.052, 0.13), (0.045, 0.15), (0.0, 0.155)],
                 segments)
