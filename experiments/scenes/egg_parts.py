"""What the scenes with an egg chair are built of: its shell, cushion and foot, and a ball.

Metres; Blender's axes (z up).
"""

import dataclasses
import math

import mathutils
import modelling as m

EGG_MIDDLE = 0.8  # height
EGG = (0.44, 0.42, 0.53)  # half axes: across, front to back, upright
THICKNESS = 0.05


@dataclasses.dataclass(frozen=True)
class Fineness:
    """Of the shell.  segments: round the opening.  outside, inside: rings from the back to the opening.
    rim: steps over it."""

    segments: int
    outside: int
    inside: int
    rim: int


def egg_point(theta, phi):
    """theta: angle from the back (+y); phi: about that axis, 90 degrees is up."""
    across, upright = math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi)
    narrowing = 1 - 0.12 * upright
    return mathutils.Vector((EGG[0] * narrowing * across, EGG[1] * narrowing * math.cos(theta),
                             EGG[2] * upright))


def opening(phi):
    """theta at which the shell ends: wide at the sides, a lip below the knees, a hood above."""
    return math.radians(118 - 14 * math.cos(2 * phi) - 8 * math.sin(phi))


def difference(curve, at):
    return curve(at + 1e-4) - curve(at - 1e-4)


def outward(theta, phi):
    along = difference(lambda t: egg_point(t, phi), theta)
    around = difference(lambda p: egg_point(theta, p), phi)
    return around.cross(along).normalized()


def ring_thetas(phi, count):
    return [opening(phi) * (i + 1) / count for i in range(count)]


def shell_line(phi, fineness):
    """From the back along the outside, over the rim and back along the inside, without its ends."""
    outside = [egg_point(theta, phi) for theta in ring_thetas(phi, fineness.outside)]
    inside = [egg_point(theta, phi) - THICKNESS * outward(theta, phi)
              for theta in ring_thetas(phi, fineness.inside)]
    at_rim = outward(opening(phi), phi)
    along_rim = difference(lambda p: egg_point(opening(p), p), phi).normalized()
    beyond = at_rim.cross(along_rim)
    middle, rim = (outside[-1] + inside[-1]) / 2, []
    for i in range(1, fineness.rim):
        turn = math.pi * i / fineness.rim
        direction = math.cos(turn) * at_rim + math.sin(turn) * beyond
        rim.append(middle + THICKNESS / 2 * direction)
    return outside + rim + inside[::-1]


def add_shell(material, at, fineness):
    """Closed and smooth: no edge has 30 degrees, not even at the rim.  at: x, y."""
    lines = [shell_line(2 * math.pi * i / fineness.segments, fineness)
             for i in range(fineness.segments)]
    rings = [[tuple(line[i]) for line in lines] for i in range(len(lines[0]))]
    back = egg_point(0, 0)
    front_of_back = back - mathutils.Vector((0, THICKNESS, 0))
    shell = m.add_rings("Shell", rings, material, tuple(back), tuple(front_of_back))
    shell.location = (*at, EGG_MIDDLE)
    shell.rotation_euler = (0, 0, math.radians(24))


def add_cushion(material, place, radius=0.3, height=0.09):
    """A flat ellipsoid; its normals are spread evenly over its rings.  place: x, y."""
    profile = []
    for i in range(8):
        slope = math.pi * (i / 7 - 0.5)
        at = math.atan2(height * math.sin(slope), radius * math.cos(slope))
        profile.append((0 if i in (0, 7) else radius * math.cos(at), height * math.sin(at)))
    m.add_turned("Cushion", (*place, EGG_MIDDLE - 0.38), profile, 20, material)


def add_foot(material, at):
    """A trumpet that ends within the thickness of the shell.  at: x, y."""
    profile = [(0.3 - 0.26 * math.sin(t), 0.22 * (1 - math.cos(t)))
               for t in (math.radians(90 * i / 7) for i in range(8))]
    profile.append((profile[-1][0], EGG_MIDDLE - EGG[2] + THICKNESS / 2))
    m.add_turned("Foot", (*at, 0), profile, 14, material)


def ball(radius, segments, rings):
    """Profile of a sphere that stands on its centre."""
    angles = [math.pi * i / (rings + 1) for i in range(rings + 2)]
    profile = [(radius * math.sin(a), radius * (1 - math.cos(a))) for a in angles]
    return [(0, profile[0][1]), *profile[1:-1], (0, profile[-1][1])], segments
