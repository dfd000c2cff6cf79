"""Builds what a museum shows: busts, figures, vases, coins, cut gems."""

import math

import vectors as v3
from solids import ball, joined, lathe, loft, merged, smooth_line, tube, Solid

# Features of a face: azimuth, elevation and their spreads in radians, height in head radii.
FEATURES = ((0.0, -0.08, 0.1, 0.2, 0.2), (0.0, -0.22, 0.14, 0.09, 0.07), (0.36, 0.1, 0.17, 0.11, -0.09),
            (-0.36, 0.1, 0.17, 0.11, -0.09), (0.34, 0.09, 0.09, 0.07, 0.06), (-0.34, 0.09, 0.09, 0.07, 0.06),
            (0.0, 0.26, 0.6, 0.1, 0.05), (0.0, -0.47, 0.2, 0.05, 0.06), (0.0, -0.6, 0.17, 0.05, 0.05),
            (0.0, -0.535, 0.25, 0.025, -0.03), (0.0, -0.86, 0.25, 0.14, 0.1), (0.62, -0.25, 0.3, 0.2, 0.04),
            (-0.62, -0.25, 0.3, 0.2, 0.04), (1.5, 0.0, 0.1, 0.2, 0.12), (-1.5, 0.0, 0.1, 0.2, 0.12))


def head(radius, segments, seed=0.0):
    """A head with a face towards +z and curled hair, about the origin."""
    def relief(p):
        d = v3.unit(p)
        azimuth, elevation = math.atan2(d[0], d[2]), math.asin(max(-1.0, min(1.0, d[1])))
        total = 0.0
        for a, e, sa, se, height in FEATURES:
            total += height * math.exp(-((azimuth - a) / sa) ** 2 - ((elevation - e) / se) ** 2)
        hair = max(0.0, min(1.0, 5 * (elevation - 0.55 + 0.62 * max(0.0, abs(azimuth) - 0.5))))
        if elevation < -0.6:
            hair = 0.0
        if hair > 0:
            total += hair * (0.08 + 0.12 * v3.layers(7 * d[0], 7 * d[1], 7 * d[2] + seed, 3))
        return radius * total
    return ball(radius, segments).displaced(relief).scaled(0.8, 1.05, 0.92)


def _ellipses(line, count, fold=None):
    """Rings from (radius x, radius z, y, shift x, shift z); fold(angle, y) scales the radius."""
    rings = []
    for rx, rz, y, dx, dz in line:
        ring = []
        for k in range(count):
            a = 2 * math.pi * k / count
            f = 1 + (fold(a, y) if fold else 0)
            ring.append((dx + f * rx * math.cos(a), y, dz - f * rz * math.sin(a)))
        rings.append(ring)
    return rings


def bust(segments, steps, seed=0.0):
    """A bust of 0.62 m on y = 0, draped, on a turned socle; it looks towards +z."""
    line = smooth_line([(0.06, 0.05, 0.1, 0, 0), (0.13, 0.085, 0.16, 0, 0), (0.175, 0.1, 0.25, 0, 0),
                        (0.17, 0.09, 0.315, 0, -0.01), (0.09, 0.07, 0.36, 0, -0.015),
                        (0.052, 0.056, 0.4, 0, -0.01), (0.05, 0.056, 0.47, 0, 0)], steps)

    def fold(a, y):
        low = max(0.0, min(1.0, (0.34 - y) * 12))
        return low * 0.06 * v3.noise(5 * math.cos(a) + 30 * y, 5 * math.sin(a) - 8 * y, seed)

    socle = lathe([(0, 0), (0.1, 0), (0.1, 0.02), (0.09, 0.026)] + smooth_line(
        [(0.08, 0.03), (0.05, 0.055), (0.055, 0.08)], 6) + [(0.065, 0.085), (0.065, 0.099), (0, 0.099)], segments)
    face = head(0.092, segments, seed).turned("y", 12).moved(0.0, 0.53, 0.012)
    return joined([socle, loft(_ellipses(line, segments, fold)), face])


def figure(high, segments, rows, seed=0.0):
    """A standing draped figure on y = 0, its weight on one leg, with a bent arm and a raised one."""
    line = smooth_line([(0.19, 0.16, 0.0, 0, 0), (0.17, 0.15, 0.1, 0.0, 0), (0.15, 0.13, 0.4, 0.01, 0),
                        (0.15, 0.12, 0.5, 0.03, 0), (0.115, 0.09, 0.62, 0.02, 0),
                        (0.145, 0.1, 0.74, 0.0, 0.01), (0.15, 0.085, 0.81, -0.01, 0),
                        (0.06, 0.055, 0.855, -0.01, 0), (0.042, 0.045, 0.885, -0.01, 0.005),
                        (0.04, 0.045, 0.92, -0.008, 0.012)], rows)

    def fold(a, y):
        deep = 0.1 * max(0.0, 0.62 - y) + 0.02 * max(0.0, min(1.0, (0.8 - y) * 8))
        sway = 1.2 * math.sin(4 * y + seed) + 0.8 * v3.noise(2 * math.cos(a), 3 * y, seed)
        return deep * math.sin(11 * a + 3 * sway) + 0.5 * deep * math.sin(17 * a - 5 * sway)

    body = loft(_ellipses(line, segments, fold))
    face = head(0.062, max(40, segments // 2), seed).turned("y", -20).moved(-0.005, 0.965, 0.018)
    arms = []
    for path in (((-0.14, 0.79, 0), (-0.2, 0.66, 0.02), (-0.14, 0.58, 0.12), (-0.03, 0.6, 0.15)),
                 ((0.13, 0.79, 0), (0.21, 0.74, 0.03), (0.26, 0.88, 0.06), (0.24, 1.03, 0.08))):
        bones = smooth_line(path, 12)
        radii = [0.036 - 0.018 * k / (len(bones) - 1) for k in range(len(bones))]
        radii[0], radii[-1] = 0.03, 0.008
        arms.append(tube(bones, radii, max(16, segments // 5)))
    return joined([body, face] + arms).scaled(high)


def knot(radius, thick, steps, sides):
    """A trefoil knot that stands upright on y = 0."""
    path = []
    for k in range(steps):
        t = 2 * math.pi * k / steps
        path.append((radius * (math.sin(t) + 2 * math.sin(2 * t)) / 3,
                     radius * (math.cos(t) - 2 * math.cos(2 * t)) / 3, radius * -math.sin(3 * t) / 2.2))
    solid = tube(path, thick, sides, closed=True)
    low = min(p[1] for p in solid.points)
    return solid.moved(0, -low, 0)


def vase(high, wall, segments, steps, shape):
    """A vase on y = 0: a closed thick shell; shape is a list of (radius, height) as shares of `high`."""
    outside = smooth_line([(r * high, y * high) for r, y in shape], steps)
    inside = smooth_line([(max(0.01, r * high - wall), max(wall, y * high)) for r, y in shape], steps)
    inside[-1] = (inside[-1][0], inside[-1][1] + 0.0005)
    foot = outside[0][0]
    return lathe([(0, 0), (foot * 0.98, 0)] + outside + inside[::-1] + [(0, inside[0][1])], segments)


def handles(high, reach, at, thick, sides, steps):
    """Two handles of an amphora between heights at (low, top) and radii at (low, top)."""
    (y0, r0), (y1, r1) = at
    path = smooth_line([(r0, y0, 0), (r0 + reach * 0.8, y0 + (y1 - y0) * 0.35, 0),
                        (r0 + reach, y0 + (y1 - y0) * 0.75, 0), (r1 + reach * 0.5, y1 + 0.02 * high, 0),
                        (r1, y1, 0)], steps)
    one = tube(path, thick, sides, caps=False)
    return joined([one, one.turned("y", 180)])


def coin(radius, segments, seed):
    """A coin on y = 0 with a raised rim and a struck relief on its top."""
    profile = [(0, 0), (radius * 0.97, 0), (radius, radius * 0.03), (radius, radius * 0.14),
               (radius * 0.97, radius * 0.17), (radius * 0.9, radius * 0.17), (radius * 0.87, radius * 0.13)]
    profile += [(radius * 0.87 * (1 - k / 9), radius * 0.13) for k in range(1, 9)] + [(0, radius * 0.13)]
    solid = lathe(profile, segments)

    def strike(p):
        x, y, z = p
        r = math.hypot(x, z) / radius
        if y < radius * 0.12 or r > 0.84:
            return p
        lift = 0.05 * (1 - r) * (1 + v3.noise(3 * x / radius, 3 * z / radius, seed))
        return (x, y + radius * lift, z)
    return solid.mapped(strike)


def gem(radius, sides):
    """A cut gem on y = 0 that stands on its culet; every facet is flat."""
    levels = ((0.0, 0.0, 0), (0.55, 0.38, 0.5), (1.0, 0.72, 0), (1.0, 0.78, 0), (0.82, 0.93, 0.5), (0.55, 1.05, 0))
    rings = []
    for r, y, phase in levels:
        rings.append([(0.0, y * radius, 0.0)] if r == 0 else [
            (r * radius * math.cos(a), y * radius, -r * radius * math.sin(a))
            for a in (2 * math.pi * (k + phase) / sides for k in range(sides))])
    solid = loft(rings[:2], caps=False)
    points, faces = list(solid.points), list(solid.faces)
    for k in range(1, len(levels) - 1):
        first, after = 1 + sides * (k - 1), 1 + sides * k
        points += rings[k + 1]
        lead = levels[k + 1][2] - levels[k][2]
        for i in range(sides):
            j = (i + 1) % sides
            if lead == 0:
                faces.append((first + i, first + j, after + j, after + i))
            elif lead > 0:
                faces += [(first + i, first + j, after + i), (first + j, after + j, after + i)]
            else:
                faces += [(first + i, after + j, after + i), (first + i, first + j, after + j)]
    faces.append(tuple(1 + sides * (len(levels) - 2) + i for i in range(sides)))
    return merged(Solid(points, faces))


def bird(high, segments, steps):
    """A slender polished form that rises from a thin waist, on y = 0."""
    return lathe([(0, 0), (0.05 * high, 0)] + smooth_line(
        [(0.052 * high, 0.003 * high), (0.016 * high, 0.12 * high), (0.04 * high, 0.35 * high),
         (0.066 * high, 0.6 * high), (0.05 * high, 0.85 * high), (0.004 * high, high)], steps) + [(0, high)],
        segments)


def necklace(radius, count, bead, segments):
    """Beads along an ellipse that lies on y = 0."""
    beads = []
    for k in range(count):
        a = 2 * math.pi * k / count
        r = bead * (1 + 0.5 * max(0.0, -math.cos(a)) ** 3)
        beads.append(ball(r, segments).moved(radius * math.sin(a), r, -radius * 1.2 * math.cos(a)))
    return joined(beads)
