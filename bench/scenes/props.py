"""Builds what several furnished scenes hold: walls, windows, glasses, books, leaves, lights."""

import math

import vectors as v3
from solids import (Solid, bevelled_box, box, extrude, joined, lathe, loft, rounded_outline, sheet,
                    smooth_line, tube, vessel)


def wall_with_hole(width, height, hole, depth):
    """A wall in the plane z = 0, facing +z, with a rectangular hole (x0, y0, x1, y1) and its reveal.

    The reveal goes back to z = -depth. The lower left corner of the wall is at the origin.
    """
    xs, ys = (0.0, hole[0], hole[2], width), (0.0, hole[1], hole[3], height)
    points = [(x, y, 0.0) for y in ys for x in xs]
    faces = [(4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4)
             for j in range(3) for i in range(3) if (i, j) != (1, 1)]
    points += [(points[k][0], points[k][1], -depth) for k in (5, 6, 10, 9)]
    rim = (5, 6, 10, 9)
    for k in range(4):
        m = (k + 1) % 4
        faces.append((rim[k], rim[m], 16 + m, 16 + k))
    return Solid(points, faces)


def window(width, height, bars=2, depth=0.05, bar=0.05):
    """Frame and panes of a window about the origin, facing z: (frame, glass); panes are 6 mm thick."""
    frame, glass = [], []
    uprights = [-width / 2 + bar / 2, width / 2 - bar / 2]
    uprights[1:1] = [-width / 2 + width * k / bars for k in range(1, bars)]
    for x in uprights:
        frame.append(bevelled_box(bar, height, depth, 0.006, 2).moved(x, -height / 2))
    for a, b in zip(uprights, uprights[1:]):
        wide = b - a - bar
        for y in (-height / 2 + 0.002, height / 2 - bar - 0.002):
            frame.append(box(wide - 0.002, bar, depth - 0.014, ("left", "right"))
                         .moved((a + b) / 2, y))
        glass.append(box(wide + 0.016, height - 2 * bar + 0.012, 0.006)
                     .moved((a + b) / 2, -height / 2 + bar - 0.006))
    return joined(frame), joined(glass)


def drinking_glass(height, bowl, wall, segments, steps):
    """A tumbler: a closed vessel of glass, and the same profile to fill."""
    outside = [(0, 0), (bowl * 0.75, 0), (bowl * 0.8, 0.004)] + smooth_line(
        [(bowl * 0.82, 0.01), (bowl * 0.92, height * 0.5), (bowl, height - 0.001)], steps)
    inside = [(0, 0.012), (bowl * 0.7, 0.013), (bowl * 0.8 - wall, 0.018)] + smooth_line(
        [(bowl * 0.83 - wall, 0.025), (bowl * 0.92 - wall, height * 0.5),
         (bowl - wall, height)], steps)
    return vessel(outside, inside, segments), inside


def wine_glass(height, bowl, wall, segments, steps):
    """A stemmed glass: a closed vessel of glass, and its inner profile."""
    stem = height * 0.42
    top = [(0.008, stem), (bowl * 0.7, stem + 0.018), (bowl, stem + (height - stem) * 0.45),
           (bowl * 0.72, height)]
    outside = [(0, 0), (bowl * 0.85, 0), (bowl * 0.86, 0.002)] + smooth_line(
        [(bowl * 0.8, 0.004), (0.006, 0.012), (0.004, stem * 0.5), (0.005, stem - 0.01)] + top, steps)
    inside = [(0, stem + 0.006)] + smooth_line(
        [(0.006, stem + 0.0065), (bowl * 0.7 - wall, stem + 0.02 + wall),
         (bowl - wall, stem + (height - stem) * 0.45), (bowl * 0.72 - wall, height + 0.0005)], steps)
    return vessel(outside, inside, segments), inside


def carafe(height, belly, wall, segments, steps):
    """A bulbous carafe with a neck: a closed vessel of glass, and its inner profile."""
    def side(grow, low):
        return smooth_line([(belly * 0.7 + grow, low), (belly + grow, height * 0.25),
                            (belly * 0.75 + grow, height * 0.5), (belly * 0.3 + grow, height * 0.72),
                            (belly * 0.32 + grow, height * 0.88), (belly * 0.5 + grow, height)], steps)
    inside = [(0, 0.008)] + side(-wall, 0.008)
    inside[-1] = (inside[-1][0], height + 0.001)
    return vessel([(0, 0)] + side(0, 0.0), inside, segments), inside


def filling(inside, level, reach, segments):
    """The liquid in a vessel up to a level: a closed solid that reaches into the wall."""
    profile = [(0.0, inside[0][1] - reach)]
    for (r0, y0), (r1, y1) in zip(inside, inside[1:]):
        if y1 >= level:
            share = (level - y0) / (y1 - y0)
            profile.append((r0 + share * (r1 - r0) + reach, level))
            break
        profile.append((r1 + reach, y1 - (reach if y1 - inside[0][1] < 0.002 else 0)))
    return lathe(profile + [(0.0, level)], segments)


def book(thick, high, deep, steps):
    """A book that stands on y = 0 with its spine towards +z: (cover, pages)."""
    board, half = 0.003, thick / 2
    spine = [(half * math.cos(a), deep / 2 + 0.25 * half * math.sin(a))
             for a in (math.pi * k / steps for k in range(steps + 1))]
    outline = ([(half, -deep / 2)] + spine + [(-half, -deep / 2)] +
               [(-half + board, -deep / 2), (-half + board, deep / 2 - 0.002),
                (half - board, deep / 2 - 0.002), (half - board, -deep / 2)])
    cover = extrude(outline, high).mapped(lambda p: (p[0], p[2], p[1])).flipped()
    pages = box(thick - 2 * board - 0.001, high - 0.01, deep - 0.012, ("front",))
    return cover, pages.moved(0, 0.005, -0.001)


def frame(width, height, bar, depth):
    """A picture frame facing +z, its back at z = 0, centred: a moulding with mitred corners."""
    section = [(0, 0), (0, depth * 0.6), (bar * 0.25, depth), (bar * 0.6, depth * 0.75),
               (bar * 0.75, depth * 0.75), (bar, depth * 0.4), (bar, 0)]
    rings = []
    for inward, z in section:
        x, y = width / 2 - inward, height / 2 - inward
        rings.append([(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)])
    return loft(rings, caps=False)


def leaf(length, width, droop, steps):
    """An open leaf from the origin along +z, folded along its midrib; it hangs by `droop` metres."""
    def place(u, v):
        side = 2 * u - 1
        wide = width / 2 * math.sin(math.pi * min(1, 0.03 + 0.97 * v)) ** 0.8 + 0.0005
        return (wide * side, 0.35 * wide * abs(side) - droop * v * v, length * v)
    solid = sheet(4, steps, place)
    solid.uvs = [tuple((i / 4, j / steps) for i, j in ((c, r), (c + 1, r), (c + 1, r + 1), (c, r + 1)))
                 for r in range(steps) for c in range(4)]
    return solid.flipped()


def plank(x, z, chamfer, thick=0.0):
    """A board seen from above, centred at y = 0: the top, its chamfers and, if thick, its sides."""
    def ring(grow, y):
        return [(-x / 2 + grow, y, z / 2 - grow), (x / 2 - grow, y, z / 2 - grow),
                (x / 2 - grow, y, -z / 2 + grow), (-x / 2 + grow, y, -z / 2 + grow)]
    rings = [ring(0, -chamfer), ring(chamfer, 0)]
    if thick:
        rings.insert(0, ring(0, -thick))
    solid = loft(rings)
    del solid.faces[-2], solid.uvs[-2]  # the hidden side
    return solid


def floor_of_planks(room, name, materials, area, size, draw):
    """Boards of random wood with gaps of 1 mm over area (x0, z0, x1, z1); rows run along x."""
    lists = {material: [] for material in materials}
    x0, z0, x1, z1 = area
    rows = round((z1 - z0) / size[1])
    deep = (z1 - z0) / rows
    for row in range(rows):
        x = x0 - draw.random() * size[0]
        while x < x1:
            left, right = max(x, x0), min(x + size[0], x1)
            x += size[0]
            if right - left < 0.02:
                continue
            board = plank(right - left - 0.001, deep - 0.001, 0.0015).moved(
                (left + right) / 2, 0, z0 + (row + 0.5) * deep)
            shift = draw.random() * 3
            board.uvs = [tuple((board.points[i][2] * 2 + shift, board.points[i][0] + shift)
                               for i in face) for face in board.faces]
            lists[draw.choice(materials)].append(board)
    for number, (material, boards) in enumerate(lists.items()):
        if boards:
            room.add(f"{name} {number}", material, joined(boards))


def curtain(width, height, folds, depth, columns, rows, seed=0.0):
    """A hanging open sheet in folds, facing +z; its top left corner is at the origin."""
    def place(u, v):
        down = 1 - v
        wave = math.sin(2 * math.pi * (folds * u + 0.25 * math.sin(5 * u + seed)))
        spread = 0.75 + 0.35 * down
        x = width * (u + 0.01 * down * math.sin(11 * u + seed))
        return (x, -height * down + 0.004 * math.sin(40 * u), depth * spread * wave +
                0.012 * down * math.sin(9 * u + 3 * down + seed))
    return sheet(columns, rows, place)


def lampshade(bottom, top, height, segments):
    """An open cone without caps."""
    rows = 4
    return lathe([(bottom + (top - bottom) * k / rows, height * k / rows) for k in range(rows + 1)],
                 segments)


def bulb(radius, segments):
    """A pear shape with its socket at the bottom, at y = 0."""
    return lathe([(0, 0)] + smooth_line(
        [(radius * 0.4, 0.0), (radius * 0.45, radius * 0.6), (radius, radius * 2),
         (radius * 0.6, radius * 2.8), (radius * 0.05, radius * 3)], 4) + [(0, radius * 3)], segments)


def knob(radius, segments):
    """A turned knob along +z from z = 0."""
    profile = smooth_line([(radius * 0.5, 0), (radius * 0.4, radius * 0.6), (radius, radius * 1.1),
                           (radius * 0.8, radius * 1.6), (radius * 0.1, radius * 1.8)], 4)
    return lathe(profile + [(0, radius * 1.8)], segments).turned("x", 90)


def handle(length, radius, reach, sides, steps):
    """A bow handle along x on the plane z = 0."""
    half = length / 2
    path = smooth_line([(-half, 0, 0), (-half, 0, reach * 0.7), (-half * 0.7, 0, reach),
                        (0, 0, reach), (half * 0.7, 0, reach), (half, 0, reach * 0.7),
                        (half, 0, 0)], steps)
    return tube(path, radius, sides, caps=False)


def skirting(points, section):
    """A moulding along a closed path of (x, z), counter-clockwise from above, inside a room.

    section is (distance from the wall, y), from the lowest to the highest point.
    """
    rings = []
    for inward, y in section:
        ring = []
        for i, (x, z) in enumerate(points):
            px, pz = points[i - 1]
            nx, nz = points[(i + 1) % len(points)]
            a, b = v3.unit((x - px, 0, z - pz)), v3.unit((nx - x, 0, nz - z))
            ring.append((x + inward * (b[0] - a[0]), y, z + inward * (b[2] - a[2])))
        rings.append(ring)
    return loft(rings, caps=False).flipped()


def crumple(strength, scale, seed=0):
    """A displacement for displaced(): folds of cloth."""
    def distance(p):
        n = v3.layers(p[0] * scale, p[1] * scale, p[2] * scale + seed, 3)
        return strength * (1 - 2.5 * abs(n))
    return distance


def tile(wide, high, thick, steps):
    """A tile facing +z, open at the back: its rim is rounded, its lower left corner at the origin."""
    rings = [(0.0, 0.0)] + [(thick * (1 - math.cos(a)), thick * math.sin(a))
                            for a in (math.pi / 2 * (k + 0.5) / steps for k in range(steps))]
    solid = loft([[(x + wide / 2, y + high / 2, z) for x, y in
                   rounded_outline(wide - 2 * g, high - 2 * g, 0.0015, 2)] for g, z in rings])
    del solid.faces[-2], solid.uvs[-2]
    return solid
