"""Builds a still life of glass, water, metal and fruit, by Python alone.

    python3 assets/carafe.py OUT.glb

A small bright light behind a carafe, a bowl of water and a cut tumbler throws their caustics on the
table; a warm one stands in a lamp of amber glass.  Metres; glTF's axes (y up, z to the camera).
"""

import math
import sys

import carafe_shapes as shapes
import textures
import vectors as v3
from room_writer import Room
from solids import bevelled_box, joined, lathe, rectangle, smooth_line

GAP = 2e-5  # between the table and what stands on it: faces must not coincide


def add_materials(room):
    """All materials by name."""
    oak = room.image(textures.wood((0.58, 0.49, 0.39), (0.71, 0.62, 0.5), 5, 11), 3)
    plaster = room.image(textures.speckle((0.55, 0.62, 0.66), 0.05, 3, 48), 2.5)
    slice_of_lemon = room.image(shapes.slice_texture(), 1 / 0.066)
    return {
        "table": room.matte("Limed oak", (0.95, 0.93, 0.9), texture=oak),
        "wall": room.matte("Plaster", (0.75, 0.8, 0.85), plaster),
        "glass": room.glass("Glass", 1.5, priority=2, absorb=((0.75, 0.93, 0.88), 0.03)),
        "crystal": room.glass("Crystal", 1.56, priority=2),
        "water": room.glass("Water", 1.333, priority=1, absorb=((0.72, 0.93, 0.95), 0.12)),
        "cider": room.glass("Cider", 1.34, priority=1, absorb=((0.95, 0.55, 0.08), 0.03)),
        "amber": room.glass("Amber glass", 1.5, priority=2, absorb=((0.95, 0.36, 0.05), 0.006)),
        "green": room.glass("Green glass", 1.5, priority=2, absorb=((0.12, 0.55, 0.25), 0.006)),
        "blue": room.glass("Blue glass", 1.5, priority=2, absorb=((0.08, 0.2, 0.75), 0.006)),
        "brass": room.metal("Brass", (0.91, 0.70, 0.34), 0.06),
        "lemon": room.paint("Lemon", (0.9, 0.56, 0.03), 0.4),
        "flesh": room.paint("Flesh", (1, 1, 1), 0.3, texture=slice_of_lemon),
        "ceramic": room.matte("Ceramic", (0.09, 0.06, 0.05)),
        "stem": room.matte("Stem", (0.2, 0.16, 0.08)),
        "leaf": room.paper("Leaf", (0.13, 0.22, 0.08), 0.3, (0.3, 0.42, 0.08)),
        "window": room.emitter("Window", (0.72, 0.86, 1.0), 11),
    }


def add_room(room, m):
    """A table whose grain runs along x, and a wall."""
    room.add("Table", m["table"], bevelled_box(1.3, 0.03, 2.2, 0.006, 4), at=(0, -0.03, -0.15),
             turn=90)
    room.add("Wall", m["wall"], rectangle((-1.3, -0.5, -0.85), (2.6, 0, 0), (0, 1.7, 0)))


def add_vessels(room, m):
    """A carafe and a bowl of water, and a cut tumbler of cider."""
    glass, inside = shapes.carafe()
    room.place("Carafe", room.mesh_of("Carafe", [
        (m["glass"], glass), (m["water"], shapes.filling(inside, 0.118))], 40),
        at=(-0.17, GAP, -0.03))
    glass, inside = shapes.bowl()
    room.place("Bowl", room.mesh_of("Bowl", [
        (m["glass"], glass), (m["water"], shapes.filling(inside, 0.05, surface=shapes.ripples(0.0005)))],
        40), at=(0.195, GAP, 0.06))
    glass, inside = shapes.cut_tumbler()
    room.place("Tumbler", room.mesh_of("Tumbler", [
        (m["crystal"], glass), (m["cider"], shapes.filling(inside, 0.058))], 9),
        at=(0.03, GAP, 0.02))


def add_lamp(room, m, at):
    """A small warm light on a dark foot in a globe of amber glass."""
    side = smooth_line([(0.022, 0.0), (0.048, 0.018), (0.057, 0.05), (0.046, 0.082), (0.028, 0.1)], 4)
    inner = shapes.offset(side, -0.003)
    lip = [(0.0275, 0.1013), (0.0263, 0.1016)]
    rim = lathe(side + lip + inner[::-1] + [side[0]], 64)
    room.add("Lamp glass", m["amber"], rim, at=(at[0], at[1] + 0.022, at[2]))
    foot = lathe([(0, 0), (0.036, 0.0)] + smooth_line(
        [(0.037, 0.002), (0.03, 0.008), (0.013, 0.013), (0.018, 0.0195), (0.0235, 0.021)], 4) +
        [(0.0235, 0.0225), (0.012, 0.0227), (0.009, 0.043), (0, 0.043)], 64)
    room.add("Lamp foot", m["ceramic"], foot, at=at)
    room.point("Lamp", (at[0], at[1] + 0.062, at[2]), 3, (1, 0.62, 0.28), 0.008)


def add_things(room, m):
    """Lemons, a brass ring, two bottles with twigs."""
    whole, half, flesh = shapes.lemons()
    mesh = room.mesh_of("Lemon", [(m["lemon"], whole)], 60)
    room.place("Lemon", mesh, at=(0.118, 0.0272, -0.17), rotation=shapes.tipped(86, 70))
    mesh = room.mesh_of("Half lemon", [(m["lemon"], half), (m["flesh"], flesh)], 60)
    room.place("Half lemon", mesh, at=(0.335, 0.0325, -0.06), rotation=shapes.tipped(52, -42))
    ring = lathe([(0.0265, 0.0005), (0.0275, 0), (0.0285, 0.0005), (0.0289, 0.002), (0.0289, 0.017),
                  (0.0285, 0.0185), (0.0275, 0.019), (0.0265, 0.0185), (0.0261, 0.017),
                  (0.0261, 0.002)], shapes.SEGMENTS, wrap=True)
    room.add("Ring", m["brass"], ring, at=(-0.135, GAP, 0.2))
    add_bottle(room, m, "Green bottle", "green", (-0.33, GAP, -0.08), 0.155,
               [(0.02, 0.2, 0), (0.06, 0.26, 0.01), (0.13, 0.3, 0)], (17, 0.07, 0.15))
    add_bottle(room, m, "Blue bottle", "blue", (0.43, GAP, -0.52), 0.165,
               [(-0.01, 0.2, 0), (-0.08, 0.24, 0), (-0.19, 0.25, 0.02), (-0.3, 0.228, 0)],
               (25, 0.085, 0.2))


def add_bottle(room, m, name, glass, at, high, path, leaves):
    """A bottle of a height with a twig in it."""
    side = [(r, y * high) for r, y in smooth_line(
        [(0.033, 0.02), (0.041, 0.19), (0.036, 0.48), (0.016, 0.69), (0.013, 0.9), (0.017, 1.0)], 4)]
    inner = shapes.offset(side, -0.003)
    profile = [(0, 0.001), (0.03, 0)] + side + [(0.0155, high + 0.001)] + inner[:0:-1]
    room.add(name, m[glass], lathe(profile + [(0.025, 0.007), (0, 0.006)], 52), at=at)
    stem, blades = shapes.twig([(0, 0.012, 0), (0.006, 0.8 * high, 0.004)] + path, *leaves)
    room.place(f"Twig in {name}", room.mesh_of("Twig", [
        (m["stem"], stem), (m["leaf"], joined(blades))], 60), at=at)


def add_lights(room, m):
    """The small bright light behind the glass, and a dim window beside the camera."""
    room.spot_at("Key", (-0.68, 0.60, -0.74), (0.03, 0.0, 0.05), 150, math.radians(22),
                 (1, 0.93, 0.82), 0.008)
    panes = [rectangle((0, y, z), (0, 0, -0.06), (0, 0.2, 0))
             for y in (0, 0.215) for z in (0, -0.075)]
    window = joined(panes).turned("y", -45).moved(-0.62, 0.16, 0.66)
    room.add("Window", m["window"], window)


def add_camera(room):
    place, target = (0.03, 0.25, 1.05), (0.0, 0.103, 0.0)
    room.root["cameras"] = [{"type": "perspective", "name": "Camera", "perspective": {
        "yfov": math.radians(19.3), "aspectRatio": 2, "znear": 0.01, "zfar": 100}}]
    lens = {"aperture_radius": 0.003, "focus_distance": 1.03}
    room.node("Camera", camera=0, extras={"hipmap": lens}, translation=list(place),
              rotation=list(v3.turn_onto(v3.sub(target, place))))


def build(room):
    room.root["asset"]["generator"] = "hipmap assets/carafe.py"
    m = add_materials(room)
    add_room(room, m)
    add_vessels(room, m)
    add_lamp(room, m, (0.29, GAP, -0.5))
    add_things(room, m)
    add_lights(room, m)
    add_camera(room)


def main():
    room = Room()
    build(room)
    room.write(sys.argv[1])


if __name__ == "__main__":
    main()
