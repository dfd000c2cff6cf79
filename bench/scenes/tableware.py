"""Builds pots, crockery, jars, cutlery and fruit."""

import math

from solids import (ball, extrude, joined, lathe, loft, rounded_outline, sheet, smooth_line,
                    tube)


def pot(radius, height, wall, segments, handles=2):
    """A metal pot with bow handles: a thick closed shell with a rolled rim."""
    outside = [(0, 0), (radius * 0.9, 0)] + smooth_line(
        [(radius * 0.93, 0.002), (radius, 0.015), (radius, height - 0.004)], 5)
    rim = [(radius + 0.003, height - 0.001), (radius + 0.002, height + 0.001), (radius - wall, height)]
    inside = smooth_line([(radius - wall, height - 0.002), (radius - wall, 0.017),
                          (radius * 0.9 - wall, 0.005)], 5) + [(0, 0.005)]
    parts = [lathe(outside + rim + inside, segments)]
    for k in range(handles):
        path = smooth_line([(radius * 0.99, height * 0.75, -0.03), (radius + 0.03, height * 0.78, -0.028),
                            (radius + 0.042, height * 0.79, 0), (radius + 0.03, height * 0.78, 0.028),
                            (radius * 0.99, height * 0.75, 0.03)], 6)
        parts.append(tube(path, 0.005, 14, caps=False).turned("y", 180 * k))
    return joined(parts)


def lid(radius, segments):
    """A domed lid with a turned knob; its rim lies on y = 0."""
    dome = [(radius - 0.002, 0.0), (radius, 0.001), (radius, 0.004)] + smooth_line(
        [(radius * 0.97, 0.008), (radius * 0.5, 0.024), (0.02, 0.028)], 6)
    grip = smooth_line([(0.008, 0.03), (0.007, 0.042), (0.02, 0.05), (0.016, 0.058), (0.001, 0.06)], 5)
    return lathe(dome + grip + [(0, 0.06)], segments)


def pan(radius, height, segments):
    """A frying pan and its handle along +x: (pan, handle)."""
    shell = lathe([(0, 0), (radius * 0.8, 0)] + smooth_line(
        [(radius * 0.82, 0.002), (radius * 0.95, height * 0.6), (radius, height)], 5) +
        [(radius - 0.003, height + 0.001)] + smooth_line(
            [(radius - 0.005, height - 0.001), (radius * 0.93 - 0.003, height * 0.6),
             (radius * 0.79, 0.005)], 5) + [(0, 0.004)], segments)
    path = smooth_line([(radius * 0.96, height * 0.7, 0), (radius + 0.06, height + 0.012, 0),
                        (radius + 0.2, height + 0.024, 0)], 8)
    count = len(path)
    radii = [0.006 + 0.005 * math.sin(math.pi * 0.75 * k / (count - 1)) for k in range(count)]
    return shell, tube(path, radii, 16)


def plate(radius, segments):
    """A plate with a raised rim: a closed turned shape."""
    return lathe([(0, 0.001), (radius * 0.55, 0.001), (radius * 0.56, 0)] + smooth_line(
        [(radius * 0.6, 0.001), (radius * 0.75, 0.009), (radius, 0.017)], 6) +
        [(radius + 0.0005, 0.019)] + smooth_line(
            [(radius - 0.001, 0.02), (radius * 0.73, 0.0125), (radius * 0.58, 0.005)], 6) +
        [(0, 0.0045)], segments)


def cup(radius, height, segments, handle=True):
    """A cup with a handle along +x."""
    shell = lathe([(0, 0), (radius * 0.6, 0)] + smooth_line(
        [(radius * 0.62, 0.002), (radius * 0.92, height * 0.4), (radius, height)], 6) +
        [(radius - 0.0015, height + 0.001)] + smooth_line(
            [(radius - 0.003, height - 0.001), (radius * 0.92 - 0.003, height * 0.4),
             (radius * 0.55, 0.005)], 6) + [(0, 0.0045)], segments)
    if not handle:
        return shell
    path = smooth_line([(radius * 0.97, height * 0.85, 0), (radius + 0.02, height * 0.85, 0),
                        (radius + 0.024, height * 0.5, 0), (radius * 0.93, height * 0.3, 0)], 6)
    return joined([shell, tube(path, 0.004, 14, caps=False)])


def jar(radius, height, segments):
    """A jar of glass with a lid: (glass, lid, what fills it)."""
    neck = radius * 0.85
    wall = 0.0025
    outside = [(0, 0), (radius * 0.93, 0)] + smooth_line(
        [(radius * 0.96, 0.001), (radius, 0.008), (radius, height * 0.8), (neck, height * 0.9),
         (neck, height)], 4)
    inside = [(0, 0.005), (radius * 0.9, 0.005)] + smooth_line(
        [(radius - wall * 1.5, 0.007), (radius - wall, 0.012), (radius - wall, height * 0.8),
         (neck - wall, height * 0.9), (neck - wall, height + 0.0005)], 4)
    glass = lathe(outside + inside[::-1], segments)
    top = lathe([(neck + 0.001, height * 0.93), (neck + 0.003, height * 0.93),
                 (neck + 0.003, height + 0.006), (neck + 0.001, height + 0.009), (0, height + 0.009)],
                segments)
    full = lathe([(0, 0.006), (radius * 0.88, 0.006), (radius - wall - 0.001, 0.013),
                  (radius - wall - 0.001, height * 0.6), (radius * 0.5, height * 0.64),
                  (0, height * 0.66)], segments)
    return glass, top, full


def bottle(radius, height, segments):
    """A bottle with a long neck: a closed vessel of glass, and its inner profile."""
    def side(grow, low):
        r = radius + grow
        return smooth_line([(r * 0.96, low), (r, low + 0.008), (r, height * 0.55),
                            (0.016 + grow, height * 0.75), (0.014 + grow, height)], 6)
    inside = [(0, 0.008)] + side(-0.0022, 0.009)
    inside[-1] = (inside[-1][0], height + 0.0005)
    return lathe([(0, 0), (radius * 0.9, 0)] + side(0, 0.001) + inside[::-1], segments), inside


def spoon(length, bowl, depth, sides):
    """A ladle or spoon that hangs from y = 0 downwards: a wire handle and an open bowl."""
    path = smooth_line([(0, 0, 0.006), (0, -0.01, 0), (0, -length * 0.5, 0), (0, -length, 0)], 8)
    cup_part = sheet(16, 6, lambda u, v: (
        (0.0008 + bowl * math.sin(v * math.pi / 2)) * math.cos(2 * math.pi * u),
        -length - bowl * 0.95 + 1.2 * (bowl * math.sin(v * math.pi / 2)) * math.sin(2 * math.pi * u),
        0.004 - depth * math.cos(v * math.pi / 2)), wrap=True)
    return joined([tube(path, 0.003, sides), cup_part])


def whisk(length, radius, wires):
    """A whisk that hangs from y = 0: a thick handle and loops of wire."""
    handle = tube(smooth_line([(0, 0, 0), (0, -length * 0.2, 0), (0, -length * 0.45, 0)], 6),
                  [0.004 + 0.005 * math.sin(math.pi * k / 12) for k in range(13)], 16)
    loops = []
    for k in range(wires):
        a = math.pi * k / wires
        path = [(0.004 * math.cos(a), -length * 0.45, 0.004 * math.sin(a))]
        for i in range(1, 24):
            t = 2 * math.pi * i / 24
            out, down = radius * math.sin(t) + 0.004 * math.cos(t / 2), (1 - math.cos(t)) / 2
            path.append((out * math.cos(a), -length * (0.45 + 0.55 * down), out * math.sin(a)))
        path.append((-0.004 * math.cos(a), -length * 0.45, -0.004 * math.sin(a)))
        loops.append(tube(path, 0.0009, 8))
    return joined([handle] + loops)


def knife(length):
    """A kitchen knife along +x on y = 0: (blade, grip)."""
    edge = [(0, 0), (length * 0.55, 0.0), (length * 0.62, 0.012), (length * 0.5, 0.03), (0, 0.034)]
    blade = extrude(edge, 0.0018).turned("x", -90)
    grip = extrude(rounded_outline(length * 0.38, 0.026, 0.008, 4), 0.016, 0.002).turned("x", -90)
    return blade.moved(0, 0.008, 0), grip.moved(-length * 0.19 + 0.004, 0.001, -0.018)


def apple(radius, segments, rows):
    """An apple with a hollow at its stem: (apple, stem)."""
    profile = []
    for k in range(rows + 1):
        a = math.pi * k / rows
        r = radius * (1 + 0.12 * math.cos(a) ** 2 - 0.35 * max(0, -math.cos(a)) ** 9 -
                      0.2 * max(0, math.cos(a)) ** 9)
        profile.append((r * math.sin(a) if 0 < k < rows else 0.0, -r * 0.95 * math.cos(a)))
    top = profile[-1][1]
    stem = tube([(0, top - 0.002, 0), (0.002, top + 0.01, 0), (0.007, top + 0.018, 0.002)], 0.0014, 8)
    return lathe(profile, segments), stem


def banana(length, radius, steps, turn):
    """A bent tapered fruit that lies on the plane y = 0."""
    path, radii = [], []
    for k in range(steps + 1):
        t = k / steps
        a = (t - 0.5) * 1.7
        path.append((length * 0.6 * math.sin(a), radius + 0.002, length * 0.6 * (1 - math.cos(a))))
        radii.append(radius * max(0.22, math.sin(math.pi * min(1, max(0, 0.06 + 0.88 * t))) ** 0.5))
    return tube(path, radii, 14).turned("y", turn)


def grapes(count, radius, segments, draw):
    """A bunch: many separate balls and a stem, on the plane y = 0."""
    places, shape = [], ball(radius, segments, 1.1)
    while len(places) < count:
        a, rise = draw.uniform(0, 2 * math.pi), draw.random() ** 1.4
        spread = 0.055 * (1 - rise) * math.sqrt(draw.random())
        place = (1.4 * spread * math.cos(a), radius * 1.15 + 0.06 * rise, spread * math.sin(a))
        if all(math.dist(place, other) > 1.6 * radius for other in places):
            places.append(place)
    return joined([shape.turned("z", 360 * draw.random()).turned("y", 360 * draw.random()).moved(*place)
                   for place in places])


def basin(width, deep, high, radius, steps, wall=0.003):
    """A sink: a thick rounded basin below y = 0 with a rim."""
    def ring(grow, y, r=None):
        return [(a, y, -b) for a, b in rounded_outline(width + 2 * grow, deep + 2 * grow,
                                                       r or radius + grow, steps)]
    inside = [ring(0, 0.0), ring(-0.004, -0.004), ring(-0.006, -high * 0.8), ring(-0.012, -high * 0.92),
              ring(-0.03, -high * 0.985), ring(-0.05, -high)]
    outside = [ring(-0.05, -high - wall), ring(-0.03 + wall, -high * 0.985 - wall),
               ring(-0.012 + wall, -high * 0.92 - wall), ring(-0.006 + wall, -high * 0.8),
               ring(-0.004 + wall, -0.009), ring(0.02, -0.002), ring(0.02, 0.002), ring(0.003, 0.0025)]
    return loft(outside + inside)


def pool(width, deep, low, high, radius, steps, grow):
    """Water in a basin from height low to high (both below 0); it reaches `grow` into the wall."""
    def ring(g, y):
        return [(a, y, -b) for a, b in rounded_outline(width + 2 * g, deep + 2 * g, radius + g, steps)]
    return loft([ring(-0.05, low - grow), ring(-0.03 + grow, low + 0.002), ring(-0.012 + grow, low + 0.014),
                 ring(-0.0075 + grow, low + 0.03), ring(-0.0065 + grow, high)])


def stream(top, bottom, radius, segments, rows):
    """Falling water along the Y axis: a closed tube that narrows and ripples."""
    profile = [(0, bottom)]
    for k in range(rows + 1):
        t = 1 - k / rows
        r = radius * (1 - 0.35 * t ** 0.5 + 0.05 * math.sin(28 * t) * t)
        profile.append((r, bottom + (top - bottom) * k / rows))
    return lathe(profile + [(0, top)], segments)
