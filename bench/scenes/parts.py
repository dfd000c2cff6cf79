"""Builds machine parts and hand tools: gears, nuts, bolts, springs, wrenches, a vise, a lathe's parts."""

import math

from solids import (bevelled_box, box, disc_outline, extrude, extrude_ring, joined, lathe, loft, merged,
                    rounded_outline, sheet, smooth_line, tube)


def ring(radius, count, y, z=None):
    """A circle of points: about the Y axis at height y, or about the Z axis if z is given."""
    if z is None:
        return [(radius * math.cos(a), y, -radius * math.sin(a))
                for a in (2 * math.pi * k / count for k in range(count))]
    return [(radius * math.cos(a), y + radius * math.sin(a), z)
            for a in (2 * math.pi * k / count for k in range(count))]


def gear(teeth, module, thick, bore):
    """A spur gear about the Z axis from z = 0, with a hub; every tooth has four faces."""
    outline, count = [], 4 * teeth
    root, tip = module * (teeth / 2 - 1.25), module * (teeth / 2 + 1)
    for k in range(teeth):
        for share, radius in ((-0.27, root), (-0.12, tip), (0.12, tip), (0.27, root)):
            a = 2 * math.pi * (k + share) / teeth
            outline.append((radius * math.cos(a), radius * math.sin(a)))
    shift = -0.27 * 2 * math.pi / teeth
    rim = disc_outline(root * 0.82, count, shift)
    inner = disc_outline(bore, count, shift)
    hub = disc_outline(bore * 1.7, count, shift)
    web = thick * 0.3
    lines = ((inner, -0.2 * thick), (hub, -0.2 * thick), (hub, web), (rim, web), (rim, 0), (outline, 0),
             (outline, thick), (rim, thick), (rim, thick - web), (hub, thick - web),
             (hub, 1.2 * thick), (inner, 1.2 * thick))
    return loft([[(x, y, z) for x, y in line] for line, z in lines], wrap=True)


def hexagon(across, per_side):
    """A hexagon by the distance of its sides, with points along each side."""
    corners = disc_outline(across / math.sqrt(3), 6)
    return [(a[0] + (b[0] - a[0]) * i / per_side, a[1] + (b[1] - a[1]) * i / per_side)
            for a, b in zip(corners, corners[1:] + corners[:1]) for i in range(per_side)]


def nut(size, per_side):
    """A hexagonal nut about the Y axis on y = 0: across the flats `size`, with a countersunk hole."""
    outer, count = hexagon(size, per_side), 6 * per_side
    high = 0.5 * size
    lines = ((disc_outline(size * 0.3, count), size * 0.05), (disc_outline(size * 0.35, count), 0),
             (disc_outline(size * 0.47, count), 0), (outer, size * 0.05), (outer, high - size * 0.05),
             (disc_outline(size * 0.47, count), high), (disc_outline(size * 0.35, count), high),
             (disc_outline(size * 0.3, count), high - size * 0.05))
    return loft([[(x, y, -z) for x, z in line] for line, y in lines], wrap=True)


def washer(radius, hole, thick, count):
    return extrude_ring(disc_outline(radius, count), disc_outline(hole, count), thick).turned("x", -90)


def thread(radius, pitch, turns, segments, depth=0.3):
    """A helical V-thread about the Y axis from y = 0 upwards, open at its ends."""
    low, columns = radius - depth * pitch * 2, turns * segments

    def place(u, v):
        step = round(u * columns)
        a = 2 * math.pi * (step % segments) / segments
        r = radius if 0.25 < v < 0.75 else low
        return (r * math.cos(a), pitch * (step / segments + v), -r * math.sin(a))
    return merged(sheet(columns, 2, place), 1e-8)


def bolt(size, length, turns, segments):
    """A bolt about the Y axis: its hexagonal head stands on y = 0, its thread goes upwards."""
    radius, high, per_side = size * 0.3, size * 0.4, 4
    head = loft([[(x, y, -z) for x, z in line] for line, y in (
        (hexagon(size, per_side), 0), (hexagon(size, per_side), high - size * 0.06),
        (disc_outline(size * 0.47, 6 * per_side), high))])
    pitch = (length * 0.6) / turns
    shank = lathe([(radius, high - 0.0005), (radius, high + length * 0.38),
                   (radius * 0.8, high + length * 0.41)], segments)
    core = lathe([(radius * 0.7, high + length * 0.99), (radius * 0.6, high + length * 1.02),
                  (0, high + length * 1.02)], segments)
    return joined([head, shank, core,
                   thread(radius, pitch, turns, segments).moved(0, high + length * 0.4 - pitch, 0)])


def spring(radius, wire, length, turns, per_turn, sides):
    """A compression spring about the Y axis from y = 0."""
    count = turns * per_turn
    return tube([(radius * math.cos(2 * math.pi * k / per_turn), wire + length * k / count,
                  radius * math.sin(2 * math.pi * k / per_turn)) for k in range(count + 1)], wire, sides)


def wrench(length, jaw, steps):
    """A combination wrench along y, lying on z = 0: ring below, shaft, jaw above."""
    ring_end = extrude_ring(disc_outline(jaw * 0.95, 12 * steps), disc_outline(jaw * 0.55, 12 * steps),
                            jaw * 0.6)
    shaft = extrude(rounded_outline(jaw * 0.7, length - 1.7 * jaw, 0.002, 4), jaw * 0.3, 0.0008)
    half, radius = jaw * 0.5, jaw * 1.15
    start = math.asin(half / radius)
    arc = [start + (2 * math.pi - 2 * start) * k / (10 * steps) for k in range(10 * steps + 1)]
    outline = [(radius * math.cos(a), radius * math.sin(a)) for a in arc]
    outline += [(-jaw * 0.3, -half), (-jaw * 0.3, half)]
    open_end = extrude(outline, jaw * 0.5).turned("z", 75)
    return joined([ring_end.moved(0, -length / 2 + jaw * 0.9, 0), shaft.moved(0, 0, jaw * 0.13),
                   open_end.moved(0, length / 2 - jaw * 0.5, jaw * 0.05)])


def screwdriver(length, radius, steps):
    """A screwdriver along y, its tip at y = 0: (steel, fluted handle)."""
    blade = loft([[(sx * w, y, sz * d) for sx, sz in ((-1, 1), (1, 1), (1, -1), (-1, -1))]
                  for w, d, y in ((radius * 0.35, 0.0006, 0), (radius * 0.35, 0.0009, 0.01),
                                  (radius * 0.24, radius * 0.24, 0.022))])
    shaft = lathe([(radius * 0.3, 0.02), (radius * 0.3, length * 0.6)], 8 * steps)
    rings = []
    for r, y in smooth_line([(radius * 0.5, 0.58), (radius * 0.7, 0.6), (radius * 1.0, 0.68),
                             (radius * 0.8, 0.75), (radius * 1.1, 0.88), (radius * 0.7, 1.0)], 4):
        rings.append([(f * r * math.cos(a), y * length, -f * r * math.sin(a)) for f, a in (
            (0.82 if k % 4 == 3 else 1, 2 * math.pi * k / 32) for k in range(32))])
    return joined([blade, shaft]), loft(rings)


def hammer(length, steps):
    """A hammer along y: (head, handle)."""
    high = length * 0.96
    head = [bevelled_box(0.028, 0.028, 0.05, 0.004, 1).moved(0, high - 0.014, 0),
            lathe([(0, 0.024), (0.011, 0.024), (0.011, 0.034), (0.016, 0.04), (0.016, 0.052),
                   (0.014, 0.055), (0, 0.055)], 8 * steps).turned("x", 90).moved(0, high, 0)]
    claw = loft([[(sx * w, high + y + sy * h, z) for sx, sy in ((-1, -1), (-1, 1), (1, 1), (1, -1))]
                 for w, h, y, z in ((0.011, 0.011, 0, -0.0245), (0.008, 0.008, 0.002, -0.045),
                                    (0.013, 0.002, -0.01, -0.085))])
    path = smooth_line([(0, 0, 0), (0, length * 0.3, 0), (0, length * 0.6, 0), (0, high + 0.018, 0)], 6)
    radii = [0.015 - 0.005 * math.sin(math.pi * k / (len(path) - 1)) for k in range(len(path))]
    return joined(head + [claw]), tube(path, radii, 16).scaled(0.75, 1, 1)


def pliers(length, steps):
    """Pliers along y: (steel, rubber)."""
    steel, rubber = [lathe([(0, 0), (0.008, 0), (0.008, 0.011), (0, 0.011)], 8 * steps)
                     .turned("x", 90).moved(0, 0, -0.0055)], []
    for side in (-1, 1):
        steel.append(loft([[(side * x + sx * w, y + 0.0005 * side, sz * (d + 0.0005 * side)) for sx, sz in
                            ((-1, 1), (1, 1), (1, -1), (-1, -1))]
                           for x, w, d, y in ((0.004, 0.007, 0.004, -0.012), (0.0075, 0.0065, 0.0045, 0.012),
                                              (0.0025, 0.0021, 0.002, length * 0.35))]))
        path = smooth_line([(side * -0.004, -0.008, 0), (side * 0.02, -length * 0.15, 0),
                            (side * 0.026, -length * 0.4, 0), (side * 0.018, -length * 0.6, 0)], 6)
        rubber.append(tube(path, [0.005 + 0.0025 * math.sin(3 * k / len(path)) for k in range(len(path))],
                           16))
    return joined(steel), joined(rubber)


def saw(length, teeth):
    """A hand saw along x, its blade from the origin: (blade, handle)."""
    edge = [(length * k / teeth / 2, -0.004 * (k % 2)) for k in range(2 * teeth + 1)]
    outline = edge + [(length, 0.04), (0, 0.11)]
    blade = extrude(outline, 0.0012)
    grip = rounded_outline(0.11, 0.13, 0.025, 6)
    hole = rounded_outline(0.05, 0.08, 0.022, 6)
    lines = [[(x - 0.04, y + 0.055, z) for x, y in line] for line, z in (
        (hole, -0.011), ([(x * 0.96, y * 0.96) for x, y in grip], -0.011), (grip, -0.008), (grip, 0.009),
        ([(x * 0.96, y * 0.96) for x, y in grip], 0.012), (hole, 0.012))]
    return blade, loft(lines, wrap=True)


def pegboard(columns, rows, pitch, hole, per_side):
    """A board with a grid of round holes in the plane z = 0, facing +z: an open sheet.

    Its lower left corner is the origin; the edge of each hole is a loop of border edges.
    """
    count = 4 * per_side
    square = [(i / per_side - 0.5, -0.5) for i in range(per_side)]
    square += [(0.5, i / per_side - 0.5) for i in range(per_side)]
    square += [(0.5 - i / per_side, 0.5) for i in range(per_side)]
    square += [(-0.5, 0.5 - i / per_side) for i in range(per_side)]
    round_hole = disc_outline(hole, count, -0.75 * math.pi)
    cells = []
    for j in range(rows):
        for i in range(columns):
            x, y = pitch * (i + 0.5), pitch * (j + 0.5)
            cells.append(loft([[(x + pitch * a, y + pitch * b, 0.0) for a, b in square],
                               [(x + a, y + b, 0.0) for a, b in round_hole]], caps=False))
    board = merged(joined(cells), 1e-6)
    board.uvs = [tuple(board.points[i][:2] for i in face) for face in board.faces]
    return board


def hook(reach, wire, sides):
    """A hook of wire that sticks in a hole at the origin and points to +z."""
    return tube(smooth_line([(0, 0, -0.012), (0, 0, 0.0), (0, 0, reach * 0.6), (0, 0.003, reach * 0.9),
                             (0, 0.018, reach)], 5), wire, sides)


def bin_of(wide, high, deep, wall):
    """A bin with thick walls, open above; its front is half as high."""
    def at(grow, y, cut):
        x, z = wide / 2 - grow, deep / 2 - grow
        return [(-x, y * cut, z), (x, y * cut, z), (x, y, -z), (-x, y, -z)]
    return loft([at(0.004, 0, 1), at(0.002, 0.002, 1), at(0, high, 0.5), at(wall, high, 0.5),
                 at(wall + 0.002, wall, 1)])


def can(radius, high, segments):
    """A paint can with a lid and a wire bow."""
    body = lathe([(0, 0.003), (radius - 0.004, 0.003), (radius - 0.004, 0), (radius, 0),
                  (radius, 0.004), (radius - 0.0015, 0.006), (radius - 0.0015, high - 0.006),
                  (radius, high - 0.004), (radius, high), (radius - 0.008, high),
                  (radius - 0.01, high - 0.005), (radius * 0.7, high - 0.005), (radius * 0.68, high - 0.003),
                  (0, high - 0.003)], segments)
    path = [((radius + 0.003) * math.cos(a), high * 0.8 - 0.5 * radius * math.sin(a) * 1.2,
             radius * 0.3 * math.sin(a)) for a in (math.pi * k / 20 for k in range(21))]
    return joined([body, tube(path, 0.0015, 14)])


def handwheel(radius, sides, per_turn):
    """A wheel with spokes and a crank grip about the Z axis."""
    rim = tube([(radius * math.cos(a), radius * math.sin(a), 0) for a in
                (2 * math.pi * k / per_turn for k in range(per_turn))], radius * 0.09, sides, closed=True)
    spokes = [tube([(0, 0, 0), (0.97 * radius * math.cos(a), 0.97 * radius * math.sin(a), 0)],
                   radius * 0.06, sides) for a in (0.4 + 2 * math.pi * k / 3 for k in range(3))]
    hub = extrude(disc_outline(radius * 0.22, 24), radius * 0.4, 0.002).moved(0, 0, -radius * 0.2)
    grip = lathe(smooth_line([(0.05 * radius, 0), (0.1 * radius, 0.2 * radius), (0.07 * radius, 0.4 * radius),
                              (0.11 * radius, 0.6 * radius), (0.01 * radius, 0.75 * radius)], 4) +
                 [(0, 0.75 * radius)], 20).turned("x", 90).moved(0.95 * radius, 0, 0.05 * radius)
    return joined([rim, hub, grip] + spokes)


def vise(steps):
    """A bench vise on y = 0 that opens along z: (painted body, steel)."""
    body = [bevelled_box(0.16, 0.02, 0.18, 0.004, 1), lathe(
        [(0.07, 0.0205), (0.06, 0.03), (0.045, 0.06), (0.05, 0.0695)], 8 * steps),
            bevelled_box(0.09, 0.05, 0.24, 0.01, 4).moved(0, 0.07, 0),
            bevelled_box(0.14, 0.09, 0.045, 0.01, 4).moved(0, 0.1, -0.05),
            bevelled_box(0.14, 0.09, 0.045, 0.01, 4).moved(0, 0.1, 0.065)]
    jaws = [bevelled_box(0.138, 0.03, 0.01, 0.0015, 1).moved(0, 0.155, z) for z in (-0.021, 0.036)]
    screw = thread(0.013, 0.006, 16, 8 * steps).turned("x", 90).moved(0, 0.095, 0.115)
    bar = tube([(-0.11, 0.095, 0.23), (0.11, 0.095, 0.23)], 0.006, 16)
    ends = [lathe([(0, -0.01), (0.008, -0.008), (0.01, 0), (0.008, 0.008), (0, 0.01)], 20)
            .turned("z", 90).moved(x, 0.095, 0.23) for x in (-0.11, 0.11)]
    block = extrude(disc_outline(0.02, 24), 0.04, 0.003).moved(0, 0.095, 0.21)
    return joined(body), joined(jaws + [screw, bar, block] + ends)


def crate(wide, high, deep):
    """A carton with closed flaps, a few millimetres apart."""
    flaps = [box(wide / 2 - 0.002, 0.003, deep - 0.004).moved(s * wide / 4, high + 0.001, 0)
             for s in (-1, 1)]
    return joined([box(wide, high, deep)] + flaps)
