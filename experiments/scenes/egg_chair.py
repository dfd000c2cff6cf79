"""Builds scene 3, egg_chair.glb: 2,916 triangles; a curved egg chair in a room.

    blender -b --factory-startup --python experiments/scenes/egg_chair.py -- OUT.glb

A globe lamp and a panel under the ceiling, a tall mirror on the wall, a glass ball on a small
table.  Metres; Blender's axes (z up).
"""

import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../assets"))
import mathutils
import modelling as m

LEFT, RIGHT, NEAR, FAR, CEILING = -2.1, 2.1, -2.6, 2.1, 2.6
CHAIR = (-0.2, 0.1)  # x, y
EGG_MIDDLE = 0.8  # height
EGG = (0.44, 0.42, 0.53)  # half axes: across, front to back, upright
THICKNESS = 0.05
SEGMENTS, RINGS, RIM_STEPS = 28, 8, 9  # round the opening; from the back to it; over its rim


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


def shell_line(phi):
    """From the back along the outside, over the rim and back along the inside, without its ends."""
    thetas = [opening(phi) * (i + 1) / RINGS for i in range(RINGS)]
    outside = [egg_point(theta, phi) for theta in thetas]
    normals = [outward(theta, phi) for theta in thetas]
    inside = [p - THICKNESS * n for p, n in zip(outside, normals)]
    along_rim = difference(lambda p: egg_point(opening(p), p), phi).normalized()
    beyond = normals[-1].cross(along_rim)
    middle, rim = (outside[-1] + inside[-1]) / 2, []
    for i in range(1, RIM_STEPS):
        turn = math.pi * i / RIM_STEPS
        direction = math.cos(turn) * normals[-1] + math.sin(turn) * beyond
        rim.append(middle + THICKNESS / 2 * direction)
    return outside + rim + inside[::-1]


def add_shell(material):
    """Closed and smooth: no edge has 30 degrees, not even at the rim."""
    lines = [shell_line(2 * math.pi * i / SEGMENTS) for i in range(SEGMENTS)]
    rings = [[tuple(line[i]) for line in lines] for i in range(len(lines[0]))]
    back = egg_point(0, 0)
    front_of_back = back - mathutils.Vector((0, THICKNESS, 0))
    shell = m.add_rings("Shell", rings, material, tuple(back), tuple(front_of_back))
    shell.location = (*CHAIR, EGG_MIDDLE)
    shell.rotation_euler = (0, 0, math.radians(24))


def add_cushion(material, radius=0.3, height=0.09):
    """A flat ellipsoid; its normals are spread evenly over its rings."""
    profile = []
    for i in range(8):
        slope = math.pi * (i / 7 - 0.5)
        at = math.atan2(height * math.sin(slope), radius * math.cos(slope))
        profile.append((0 if i in (0, 7) else radius * math.cos(at), height * math.sin(at)))
    m.add_turned("Cushion", (*CHAIR, EGG_MIDDLE - 0.38), profile, 20, material)


def add_foot(material):
    """A trumpet that ends within the thickness of the shell."""
    profile = [(0.3 - 0.26 * math.sin(t), 0.22 * (1 - math.cos(t)))
               for t in (math.radians(90 * i / 7) for i in range(8))]
    profile.append((profile[-1][0], EGG_MIDDLE - EGG[2] + THICKNESS / 2))
    m.add_turned("Foot", (*CHAIR, 0), profile, 14, material)


def ball(radius, segments, rings):
    """Profile of a sphere that stands on its centre."""
    angles = [math.pi * i / (rings + 1) for i in range(rings + 2)]
    profile = [(radius * math.sin(a), radius * (1 - math.cos(a))) for a in angles]
    return [(0, profile[0][1]), *profile[1:-1], (0, profile[-1][1])], segments


def add_lamps(white):
    daylight = m.glowing("Daylight", (1, 0.96, 0.9), 12)
    warm = m.glowing("Warm", (1, 0.82, 0.6), 14)
    m.add_box("Panel", (0.2, -1.0, CEILING - 0.06), (1.4, -0.4, CEILING), white, ["top"],
              {"bottom": daylight})
    x, y, low = -1.2, 1.2, 1.62
    m.add_turned("Globe", (x, y, low), *ball(0.15, 12, 4), warm)
    cord = m.matte("Cord", (0.1, 0.1, 0.1))
    m.add_box("Cord", (x - 0.006, y - 0.006, low + 0.299), (x + 0.006, y + 0.006, CEILING), cord,
              ["bottom", "top"])


def add_side_table(white):
    m.add_box("Side table", (0.8, 0.35, 0), (1.3, 0.85, 0.46), white, ["bottom"])
    m.add_box("Book", (1.03, 0.4, 0.46), (1.2, 0.62, 0.49), m.matte("Red", (0.5, 0.07, 0.06)),
              ["bottom"])
    m.add_turned("Glass ball", (0.96, 0.68, 0.46 + m.GLASS_GAP), *ball(0.12, 20, 11), m.glass())


def add_scene():
    white = m.matte("White", (0.76, 0.75, 0.72))
    floor = m.matte("Floor", (0.52, 0.38, 0.25))
    petrol = m.matte("Petrol", (0.1, 0.27, 0.33))
    m.add_room((LEFT, NEAR, 0), (RIGHT, FAR, CEILING), white,
               {"bottom": floor, "left": petrol, "front": m.matte("Sand", (0.6, 0.5, 0.36))},
               cell=0.57)
    add_lamps(white)
    add_shell(m.matte("Shell", (0.78, 0.3, 0.06)))
    add_cushion(m.matte("Cushion", (0.7, 0.66, 0.58)))
    add_foot(m.mirror("Steel", (0.8, 0.8, 0.82)))
    add_side_table(white)
    frame = m.matte("Frame", (0.3, 0.2, 0.12))
    m.add_box("Mirror", (0.35, FAR - 0.03, 0.3), (1.35, FAR, 2.1), frame, ["back"],
              {"front": m.mirror()})
    m.add_camera((0.75, -2.35, 1.35), (0.0, 0.8, 0.88), 27)


m.build(add_scene)
