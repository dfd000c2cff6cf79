"""Writes a furnished kitchen as a .glb: python3 bench/scenes/kitchen.py OUT.glb [--detail N]"""

import math
import random

import props
import tableware
import textures
import vectors as v3
from room_writer import run
from solids import (ball, bevelled_box, box, extrude, joined, lathe, level, loft, rectangle,
                    rounded_outline, smooth_line, tube)

X, Z0, Z1, HEIGHT = 2.2, -1.6, 3.0, 2.6  # the room: x from -X to X
WINDOW = (1.45, 1.12, 2.75, 2.2)  # hole in the back wall, from its lower left corner
TOP = 0.92  # height of the worktop
SINK = (-0.1, 0.62, 0.4, 0.19)  # its middle, width, depth and height
ISLAND = (0.35, 1.0, 1.5, 0.8)  # x, z, width, depth


def opaque_materials(room):
    """Materials that neither transmit nor emit, by name."""
    oak = room.image(textures.wood((0.5, 0.34, 0.2), (0.74, 0.56, 0.38), 2), 2)
    beech = room.image(textures.wood((0.68, 0.5, 0.33), (0.76, 0.59, 0.41), 6, 7), 1.5)
    rough = room.image(textures.brushed(0.15, 0.35, 3))
    granite = room.image(textures.speckle((0.3, 0.31, 0.33), 0.16, 8, 128), 2)
    peel = room.image(textures.grain_bumps(48, 0.004), 8)
    return {
        "wall": room.matte("Wall paint", (0.78, 0.74, 0.64)),
        "ceiling": room.matte("Ceiling", (0.8, 0.8, 0.78)),
        "grout": room.matte("Grout", (0.45, 0.44, 0.42)),
        "front": room.paint("Sage fronts", (0.32, 0.42, 0.36), 0.4),
        "white": room.paint("White paint", (0.76, 0.76, 0.74), 0.35),
        "granite": room.paint("Granite", (0.9, 0.9, 0.9), 0.15, texture=granite),
        "oak": room.paint("Oak", (0.95, 0.95, 0.95), 0.4, texture=oak),
        "beech": room.paint("Beech", (0.95, 0.95, 0.95), 0.5, texture=beech),
        "steel": room.metal("Brushed steel", (0.75, 0.75, 0.76), 1, rough_texture=rough),
        "chrome": room.metal("Chrome", (0.8, 0.8, 0.82), 0.05),
        "copper": room.metal("Copper", (0.8, 0.5, 0.36), 0.18),
        "brass": room.metal("Brass", (0.78, 0.6, 0.32), 0.25),
        "iron": room.metal("Cast iron", (0.12, 0.12, 0.12), 0.55, normalTexture=peel),
        "black": room.paint("Black enamel", (0.03, 0.03, 0.03), 0.12),
        "rubber": room.paint("Black grip", (0.05, 0.05, 0.05), 0.6),
        "china": room.paint("China", (0.8, 0.8, 0.78), 0.1),
        "blue china": room.paint("Blue china", (0.12, 0.25, 0.45), 0.12),
        "apple": room.paint("Apple", (0.55, 0.06, 0.04), 0.25),
        "green apple": room.paint("Green apple", (0.4, 0.55, 0.08), 0.25),
        "orange": room.paint("Orange", (0.8, 0.32, 0.03), 0.4, normalTexture=peel),
        "banana": room.paint("Banana", (0.8, 0.6, 0.08), 0.45),
        "grape": room.paint("Grape", (0.2, 0.05, 0.15), 0.2),
        "stem": room.matte("Stem", (0.2, 0.13, 0.06)),
        "pot": room.paint("Terracotta", (0.55, 0.25, 0.14), 0.7),
        "soil": room.matte("Soil", (0.08, 0.05, 0.03)),
        "pasta": room.matte("Pasta", (0.75, 0.58, 0.28)),
        "lentil": room.matte("Lentils", (0.6, 0.22, 0.08)),
        "pepper": room.matte("Pepper", (0.07, 0.06, 0.05)),
    }


def clear_and_emissive_materials(room):
    """Materials that transmit or emit, by name."""
    return {
        "glass": room.glass("Glass", 1.5, priority=2),
        "pane": room.glass("Window glass", 1.5),
        "green": room.glass("Green glass", 1.5, absorb=((0.5, 0.8, 0.5), 0.01), priority=2),
        "water": room.glass("Water", 1.333, priority=1),
        "oil": room.glass("Olive oil", 1.47, absorb=((0.75, 0.6, 0.08), 0.03), priority=1),
        "juice": room.glass("Apple juice", 1.34, absorb=((0.8, 0.45, 0.06), 0.03), priority=1),
        "leaf": room.paper("Basil", (0.1, 0.35, 0.06), 0.35, (0.3, 0.6, 0.08)),
        "bulb": room.emitter("Warm bulb", (1, 0.78, 0.52), 140),
        "strip": room.emitter("Cupboard strip", (1, 0.9, 0.75), 20),
        "flame": room.emitter("Gas flame", (0.2, 0.4, 1), 12),
    }


def add_materials(room):
    """All materials by name."""
    m = {**opaque_materials(room), **clear_and_emissive_materials(room)}
    for k, color in enumerate(((0.76, 0.76, 0.72), (0.72, 0.74, 0.72), (0.55, 0.66, 0.64))):
        m[f"tile {k}"] = room.paint(f"Wall tile {k}", color, 0.08)
    for k, color in enumerate(((0.72, 0.7, 0.66), (0.16, 0.17, 0.18))):
        m[f"floor {k}"] = room.paint(f"Floor tile {k}", color, 0.2, texture=room.image(
            textures.stone((0.95, 0.95, 0.95), (0.7, 0.68, 0.66), 9 + k), 1.3))
    return m


def tiled(room, m, name, area, is_free, draw):
    """Bevelled wall tiles over area (x0, y0, x1, y1) of a wall facing +z: one mesh of three materials."""
    x0, y0, x1, y1 = area
    columns, rows = round((x1 - x0) / 0.1), round((y1 - y0) / 0.1)
    wide, high = (x1 - x0) / columns, (y1 - y0) / rows
    shape = props.tile(wide - 0.0025, high - 0.0025, 0.005, room.steps(4, 4))
    lists = [[], [], []]
    for j in range(rows):
        for i in range(columns):
            x, y = x0 + i * wide, y0 + j * high
            if is_free(x, y, x + wide, y + high):
                tilt = shape.turned("y", draw.uniform(-0.3, 0.3)).turned("x", draw.uniform(-0.3, 0.3))
                lists[draw.choice((0, 0, 1, 1, 2))].append(tilt.moved(x + 0.00125, y + 0.00125, 0.0015))
    parts = [(m[f"tile {k}"], joined(tiles)) for k, tiles in enumerate(lists) if tiles]
    return room.mesh_of(name, parts)


def add_shell(room, m, draw):
    """Walls, ceiling, tiled floor and walls, and the window."""
    room.add("Grout of floor", m["grout"],
             rectangle((-X, -0.004, Z1), (2 * X, 0, 0), (0, 0, Z0 - Z1)))
    room.add("Ceiling", m["ceiling"], rectangle((-X, HEIGHT, Z0), (2 * X, 0, 0), (0, 0, Z1 - Z0)))
    low = -0.004
    back = props.wall_with_hole(2 * X, HEIGHT - low,
                                (WINDOW[0], WINDOW[1] - low, WINDOW[2], WINDOW[3] - low), 0.2)
    walls = [back.moved(-X, low, Z0),
             rectangle((-X, low, Z1), (0, 0, Z0 - Z1), (0, HEIGHT - low, 0)),
             rectangle((X, low, Z0), (0, 0, Z1 - Z0), (0, HEIGHT - low, 0)),
             rectangle((X, low, Z1), (-2 * X, 0, 0), (0, HEIGHT - low, 0))]
    room.add("Walls", m["wall"], joined(walls))
    tiles = ([], [])
    for j in range(15):
        for i in range(14):
            wide, deep = 2 * X / 14, (Z1 - Z0) / 15
            shape = props.tile(wide - 0.003, deep - 0.003, 0.003, room.steps(4, 4)).turned("x", -90)
            tiles[(i + j) % 2].append(shape.moved(-X + i * wide + 0.0015, -0.003,
                                                  Z0 + (j + 1) * deep - 0.0015))
    for k in (0, 1):
        room.add(f"Floor tiles {k}", m[f"floor {k}"], joined(tiles[k]))

    def free(x_low, _, x_high, y_high):
        behind = y_high > 1.5 and (x_high < 1.25 or x_low > 2.95)
        window = x_high > WINDOW[0] - 0.06 and x_low < WINDOW[2] + 0.06 and y_high > WINDOW[1] - 0.02
        return not behind and not window

    mesh = tiled(room, m, "Back tiles", (0.002, TOP + 0.002, 2 * X - 0.002, 2.32), free, draw)
    room.place("Back tiles", mesh, at=(-X, 0, Z0))
    mesh = tiled(room, m, "Left tiles", (0.6, TOP + 0.002, 3.0, 1.62), lambda *_: True, draw)
    room.place("Left tiles", mesh, at=(-X, 0, Z0 + 3.61), turn=90)
    add_window(room, m)


def add_window(room, m):
    """A window with thin panes (open meshes), a trim, a sill and pots of basil on it."""
    wide, high = WINDOW[2] - WINDOW[0] - 0.004, WINDOW[3] - WINDOW[1] - 0.004
    x, y = -X + (WINDOW[0] + WINDOW[2]) / 2, (WINDOW[1] + WINDOW[3]) / 2
    frame, _ = props.window(wide, high, 2)
    thin = rectangle((-wide / 2 + 0.02, -high / 2 + 0.02, 0), (wide - 0.04, 0, 0), (0, high - 0.04, 0))
    room.place("Window", room.mesh_of("Window", [(m["white"], frame), (m["pane"], thin)]),
               at=(x, y, Z0 - 0.12))
    room.add("Trim", m["white"], props.frame(wide + 0.11, high + 0.11, 0.05, 0.02),
             at=(x, y, Z0 + 0.001))
    room.add("Sill", m["oak"], bevelled_box(wide + 0.14, 0.025, 0.16, 0.006, 4),
             at=(x, WINDOW[1] - 0.03, Z0 + 0.084))
    for k, dx in enumerate((-0.5, 0.45)):
        basil(room, m, f"Basil {k}", (x + dx, WINDOW[1] - 0.004, Z0 + 0.09), k)


def basil(room, m, name, at, seed):
    """A small pot of basil with 60 open leaves."""
    draw = random.Random(seed)
    pot = lathe([(0, 0), (0.035, 0), (0.05, 0.075), (0.054, 0.076), (0.054, 0.09), (0.048, 0.09),
                 (0.046, 0.07)], room.steps(32, 16))
    soil = lathe([(0.0465, 0.078), (0.02, 0.08), (0, 0.0805)], 20)
    leaves, stems = [], []
    for k in range(60):
        turn, rise = 137.5 * k, draw.uniform(0.02, 0.14)
        a, out = math.radians(turn), draw.uniform(0.005, 0.05)
        blade = props.leaf(0.045, 0.028, 0.012, room.steps(6, 4)).turned("x", draw.uniform(-35, 20))
        leaves.append(blade.turned("y", turn).moved(out * math.sin(a), 0.09 + rise, out * math.cos(a)))
        if k % 4 == 0:
            stems.append(tube([(0.3 * out * math.sin(a), 0.078, 0.3 * out * math.cos(a)),
                               (out * math.sin(a), 0.09 + rise, out * math.cos(a))], 0.0015, 14,
                              caps=False))
    room.place(name, room.mesh_of(name, [(m["pot"], pot), (m["soil"], soil), (m["leaf"], joined(leaves)),
                                         (m["stem"], joined(stems))]), at=at)


def panel_door(wide, high):
    """A cupboard door facing +z with a sunk field, its back at z = 0, centred at the bottom."""
    steps = ((0, 0), (0, 0.017), (0.003, 0.02), (0.06, 0.02), (0.063, 0.012), (0.075, 0.012),
             (0.085, 0.016))
    return loft([[(sx * (wide / 2 - g), high / 2 + sy * (high / 2 - g), z)
                  for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))] for g, z in steps])


def drawer_front(wide, high):
    return bevelled_box(wide, high, 0.02, 0.004, 4).moved(0, 0, 0.01)


def base_units(room, m, name, widths, at, turn):
    """Lower cupboards side by side along x; every second one is a stack of drawers."""
    total, x = sum(widths), -sum(widths) / 2
    doors, knobs = [], []
    body = bevelled_box(total, TOP - 0.04 - 0.1 - 0.001, 0.56, 0.002, 1).moved(0, 0.1, 0)
    plinth = box(total - 0.002, 0.097, 0.5, ("top",)).moved(0, 0.002, -0.01)
    grip = props.knob(0.014, room.steps(24, 16))
    for k, wide in enumerate(widths):
        middle = x + wide / 2
        x += wide
        if k % 2:
            for y, high in ((0.105, 0.28), (0.39, 0.24), (0.635, 0.235)):
                doors.append(drawer_front(wide - 0.006, high).moved(middle, y, 0.2815))
                knobs.append(grip.moved(middle, y + high / 2, 0.3025))
        else:
            doors.append(panel_door(wide - 0.006, 0.765).moved(middle, 0.105, 0.2815))
            knobs.append(grip.moved(middle + wide / 2 - 0.035, 0.78, 0.302))
    room.place(name, room.mesh_of(name, [(m["white"], joined([body, plinth])),
                                         (m["front"], joined(doors)), (m["brass"], joined(knobs))]),
               at=at, turn=turn)


def wall_units(room, m, name, widths, at):
    """Upper cupboards along x with doors, knobs and an emissive strip below."""
    total, x, high = sum(widths), -sum(widths) / 2, 0.72
    doors, knobs = [], []
    grip = props.knob(0.012, room.steps(24, 16))
    for k, wide in enumerate(widths):
        doors.append(panel_door(wide - 0.006, high - 0.01).moved(x + wide / 2, 0.005, 0.1515))
        knobs.append(grip.moved(x + (wide - 0.04 if k % 2 == 0 else 0.04), 0.08, 0.172))
        x += wide
    parts = [(m["white"], bevelled_box(total, high, 0.3, 0.002, 1)), (m["front"], joined(doors)),
             (m["brass"], joined(knobs)), (m["strip"], box(total - 0.2, 0.008, 0.015)
                                           .moved(0, -0.0095, 0.1))]
    room.place(name, room.mesh_of(name, parts), at=at)


def slab_with_hole(size, hole, thick, steps):
    """A worktop of (width, depth) with a round-cornered hole (x, z, width, depth), top at y = 0."""
    wide, deep = size
    x, z, hole_wide, hole_deep = hole
    outer = rounded_outline(wide, deep, 0.006, steps)
    small = rounded_outline(wide - 0.006, deep - 0.006, 0.004, steps)
    inner = rounded_outline(hole_wide, hole_deep, 0.08, steps)
    edge = rounded_outline(hole_wide + 0.004, hole_deep + 0.004, 0.082, steps)
    return loft([level(inner, -thick, x, z), level(small, -thick), level(outer, -thick + 0.003),
                 level(outer, -0.003), level(small, 0), level(edge, 0, x, z),
                 level(inner, -0.002, x, z)], wrap=True)


def add_counters(room, m):
    """Worktops with lower cupboards along the back and the left wall; upper cupboards."""
    base_units(room, m, "Base units back", (0.62, 0.6, 0.8, 0.6, 0.45, 0.6),
               (0.36, 0.001, Z0 + 0.3), 0)
    x, wide, deep, _ = SINK
    top = slab_with_hole((3.72, 0.62), (x - 0.335, -0.005, wide + 0.02, deep + 0.02), 0.038,
                         room.steps(6, 4))
    room.add("Worktop back", m["granite"], top, at=(0.335, TOP, Z0 + 0.312))
    base_units(room, m, "Base units left", (0.6, 0.5, 0.6, 0.6), (-X + 0.3, 0.001, 0.21), 90)
    room.add("Worktop left", m["granite"], bevelled_box(0.62, 0.038, 2.72, 0.004, 4),
             at=(-X + 0.312, TOP - 0.038, 0.02))
    wall_units(room, m, "Wall units", (0.4, 0.36), (1.817, 1.52, Z0 + 0.153))
    add_sink(room, m)


def add_sink(room, m):
    """A steel sink with some water, a tap with a stream of water, and a lever."""
    x, wide, deep, high = SINK
    z, steps = Z0 + 0.307, room.steps(8, 6)
    room.add("Sink", m["steel"], tableware.basin(wide, deep, high, 0.07, steps),
             at=(x, TOP + 0.0025, z))
    path = smooth_line([(0, 0.003, 0), (0, 0.15, 0), (0, 0.28, 0.01), (0, 0.345, 0.08),
                        (0, 0.32, 0.155), (0, 0.26, 0.17)], 10)
    foot = lathe([(0, 0.001), (0.026, 0.001), (0.026, 0.008), (0.02, 0.012), (0.019, 0.05),
                  (0.0145, 0.056), (0, 0.056)], room.steps(32, 16))
    lever = tube(smooth_line([(0.015, 0.035, 0), (0.04, 0.045, 0), (0.09, 0.07, 0)], 6), 0.005, 14)
    place = (x, TOP + 0.001, z - deep / 2 - 0.04)
    room.add("Tap", m["chrome"], joined([tube(path, 0.0125, room.steps(24, 16), caps=False), foot,
                                         lever]), at=place)
    water = joined([tableware.stream(0.275, -high + 0.012, 0.006, room.steps(20, 16), room.steps(60))
                    .moved(0, 0, 0.17 - deep / 2 - 0.04),
                    tableware.pool(wide, deep, -high, -high + 0.055, 0.07, steps, 0.0015)
                    .moved(0, 0.0025, 0)])
    room.add("Running water", m["water"], water, at=(x, TOP, z))


def add_hob(room, m):
    """A gas hob with flames, three pots, a pan, a hood with two spot lights."""
    x, z = 1.25, Z0 + 0.31
    plate = bevelled_box(0.58, 0.01, 0.5, 0.004, 4)
    rings, grates, flames = [], [], []
    for dx in (-0.145, 0.145):
        for dz in (-0.12, 0.12):
            rings.append(lathe([(0.045, 0.0101), (0.045, 0.02), (0.03, 0.026), (0, 0.026)], 32)
                         .moved(dx, 0, dz))
            grates += [bevelled_box(0.2, 0.012, 0.008, 0.003, 4).turned("y", 45 + 90 * k)
                       .moved(dx, 0.033 + 0.0125 * k, dz) for k in range(2)]
            if dx * dz > 0:
                flames += [lathe([(0, 0), (0.003, 0.003), (0.0015, 0.01), (0, 0.014)], 8)
                           .moved(dx + 0.05 * math.cos(a), 0.018, dz + 0.05 * math.sin(a))
                           for a in (2 * math.pi * k / 18 for k in range(18))]
    dials = [props.knob(0.012, 24).turned("x", -90).moved(0.05 * k - 0.1, 0.0103, 0.222)
             for k in range(5)]
    room.place("Hob", room.mesh_of("Hob", [
        (m["black"], plate), (m["iron"], joined(rings + grates)), (m["flame"], joined(flames)),
        (m["steel"], joined(dials))]), at=(x, TOP + 0.001, z))
    segments, y = room.steps(48, 16), TOP + 0.0605
    room.place("Stock pot", room.mesh_of("Stock pot", [(m["steel"], joined(
        [tableware.pot(0.12, 0.17, 0.003, segments), tableware.lid(0.125, segments)
         .moved(0, 0.1715, 0)]))]), at=(x - 0.145, y, z - 0.12), turn=20)
    room.add("Copper pot", m["copper"], tableware.pot(0.09, 0.11, 0.003, segments),
             at=(x + 0.145, y, z - 0.12), turn=65)
    shell, grip = tableware.pan(0.13, 0.045, segments)
    room.place("Pan", room.mesh_of("Pan", [(m["iron"], shell), (m["rubber"], grip)]),
               at=(x + 0.14, y, z + 0.12), turn=-40)
    add_hood(room, m, x)


def add_hood(room, m, x):
    """A steel hood: an open pyramid under a duct."""
    rings = []
    for wide, deep, y in ((0.6, 0.44, 1.6), (0.6, 0.44, 1.66), (0.26, 0.24, 1.85), (0.26, 0.24, 2.598)):
        rings.append([(a, y, Z0 + 0.022 + deep / 2 - b)
                      for a, b in rounded_outline(wide, deep, 0.008, room.steps(4, 4))])
    room.add("Hood", m["steel"], loft(rings, caps=False), at=(x, 0, 0))
    for k, dx in enumerate((-0.15, 0.15)):
        room.spot_at(f"Hood spot {k}", (x + dx, 1.63, Z0 + 0.24), (x + dx, TOP, Z0 + 0.3), 12, 0.7,
                     (1, 0.9, 0.75), 0.015)


def open_shelves(room, m, draw):
    """Three boards with crockery, glasses and jars, left of the window."""
    x, wide = -1.55, 1.2
    boards = [bevelled_box(wide, 0.03, 0.24, 0.004, 4).moved(x, y, Z0 + 0.14)
              for y in (1.5, 1.85, 2.2)]
    brackets = [tube(smooth_line([(x + dx, y - 0.1, Z0 + 0.02), (x + dx, y - 0.02, Z0 + 0.03),
                                  (x + dx, y - 0.012, Z0 + 0.2)], 6), 0.006, 14)
                for y in (1.5, 1.85, 2.2) for dx in (-0.45, 0.45)]
    room.place("Shelves", room.mesh_of("Shelves", [(m["oak"], joined(boards)),
                                                   (m["black"], joined(brackets))]))
    segments = room.steps(36, 16)
    plates = joined([tableware.plate(0.11, segments).moved(0, 0.0235 * k, 0) for k in range(8)])
    small = joined([tableware.cup(0.065, 0.055, segments, False).moved(0, 0.022 * k, 0)
                    for k in range(5)])
    room.add("Plates", m["china"], plates, at=(x - 0.42, 1.531, Z0 + 0.14))
    room.add("Bowls", m["blue china"], small, at=(x - 0.2, 1.531, Z0 + 0.14))
    mesh = room.mesh_of("Cup", [(m["blue china"], tableware.cup(0.04, 0.085, segments))])
    for k in range(6):
        room.place(f"Cup {k}", mesh, turn=draw.uniform(-60, 60),
                   at=(x + 0.11 * (k % 5), 1.531 + 0.087 * (k // 5), Z0 + 0.11 + 0.03 * (k % 2)))
    for k in range(9):
        glass, top, full = tableware.jar(0.045, 0.15 - 0.02 * (k % 3), segments)
        room.place(f"Jar {k}", room.mesh_of(f"Jar {k}", [
            (m["glass"], glass), (m["steel"], top), (m[("pasta", "lentil", "pepper")[k % 3]], full)]),
            at=(x - 0.5 + 0.122 * k, 1.881, Z0 + 0.14))
    glass, _ = props.drinking_glass(0.13, 0.036, 0.002, segments, 5)
    mesh = room.mesh_of("Tumbler", [(m["glass"], glass)])
    for k in range(18):
        room.place(f"Tumbler {k}", mesh, at=(x - 0.5 + 0.125 * (k % 9), 2.231, Z0 + 0.09 + 0.1 * (k // 9)))


def add_left_counter(room, m):
    """On the left worktop: bottles, knife block, boards; on its tiles a rail with tools."""
    segments, z0, y = room.steps(36, 16), -0.9, TOP + 0.001
    for k, (radius, high, glass, liquid) in enumerate((
            (0.035, 0.28, "green", "oil"), (0.04, 0.31, "glass", "juice"), (0.032, 0.24, "green", None),
            (0.038, 0.3, "glass", "water"))):
        shape, inside = tableware.bottle(radius, high, segments)
        parts = [(m[glass], shape)]
        if liquid:
            parts.append((m[liquid], props.filling(inside, high * 0.5, 0.0008, segments)))
        room.place(f"Bottle {k}", room.mesh_of(f"Bottle {k}", parts),
                   at=(-X + 0.16 + 0.06 * (k % 2), y, z0 + 0.1 * k))
    block = bevelled_box(0.1, 0.22, 0.15, 0.008, 4)
    grips = [bevelled_box(0.018, 0.09, 0.024, 0.005, 4).moved(-0.03 + 0.03 * (k % 3), 0.221,
                                                             -0.035 + 0.05 * (k // 3)) for k in range(6)]
    room.place("Knife block", room.mesh_of("Knife block", [(m["beech"], block),
                                                           (m["rubber"], joined(grips))]),
               at=(-X + 0.2, y, -0.35), turn=75)
    for k, (wide, high) in enumerate(((0.42, 0.3), (0.32, 0.24))):
        board = extrude(rounded_outline(high, wide, 0.03, room.steps(6, 4)), 0.018, 0.003)
        room.add(f"Board {k}", m["beech"], board.moved(0, wide / 2, 0).turned("x", -8),
                 at=(-X + 0.07 + 0.03 * k, y, 0.1 + 0.1 * k), turn=90)
    rail = tube([(-X + 0.05, 1.45, -0.7), (-X + 0.05, 1.45, 0.9)], 0.006, 16)
    room.add("Rail", m["brass"], rail)
    tools = [tableware.spoon(0.2 + 0.02 * k, 0.03 + 0.005 * (k % 2), 0.02, 14) for k in range(4)]
    tools += [tableware.whisk(0.26, 0.03, room.steps(9, 6)), tableware.whisk(0.22, 0.024, 7)]
    for k, tool in enumerate(tools):
        room.add(f"Tool {k}", m["steel"], tool, at=(-X + 0.064, 1.442, -0.6 + 0.14 * k), turn=90)
    shell, grip = tableware.pan(0.1, 0.04, segments)
    for k in range(3):
        scale = 1 - 0.15 * k
        room.place(f"Hanging pan {k}", room.mesh_of("Hanging pan", [(m["copper"], shell),
                                                                    (m["iron"], grip)]),
                   at=(-X + 0.06, 1.16 + 0.05 * k, 0.35 + 0.22 * k), scale=scale,
                   rotation=v3.axis_turn(v3.unit((-1, 1, 1)), -120))


def add_island(room, m, draw):
    """An island with a wooden top; on it fruit, glasses, a carafe, a cutting board; two stools."""
    x, z, wide, deep = ISLAND
    room.add("Island top", m["beech"], bevelled_box(wide, 0.045, deep, 0.006, 4), at=(x, 0.876, z))
    base_units(room, m, "Island units", (0.45, 0.5, 0.45), (x, -0.005, z - 0.06), 180)
    y, segments, steps = 0.922, room.steps(40, 16), room.steps(7, 4)
    glass, inside = props.wine_glass(0.22, 0.04, 0.0016, segments, steps)
    mesh = room.mesh_of("Wine glass", [(m["glass"], glass)])
    for k, (dx, dz) in enumerate(((0.34, -0.2), (0.45, -0.12), (0.38, -0.05))):
        room.place(f"Wine glass {k}", mesh, at=(x + dx, y, z + dz))
    glass, inside = props.drinking_glass(0.12, 0.034, 0.002, segments, steps)
    for k, liquid in enumerate(("water", "juice", "water")):
        level_y = (0.085, 0.07, 0.05)[k]
        room.place(f"Glass of {liquid} {k}", room.mesh_of("Glass", [
            (m["glass"], glass), (m[liquid], props.filling(inside, level_y, 0.0008, segments))]),
            at=(x + 0.12 + 0.1 * k, y, z + 0.18 - 0.05 * (k % 2)))
    glass, inside = props.carafe(0.28, 0.07, 0.0025, segments, steps)
    room.place("Carafe", room.mesh_of("Carafe", [
        (m["glass"], glass), (m["water"], props.filling(inside, 0.15, 0.001, segments))]),
        at=(x + 0.2, y, z - 0.12))
    add_fruit(room, m, (x - 0.12, y, z - 0.05), draw)
    board = extrude(rounded_outline(0.4, 0.26, 0.03, room.steps(6, 4)), 0.02, 0.003).turned("x", -90)
    blade, grip = tableware.knife(0.3)
    room.place("Cutting board", room.mesh_of("Cutting board", [
        (m["oak"], board), (m["steel"], blade.moved(-0.02, 0.014, 0.06)),
        (m["rubber"], grip.moved(-0.02, 0.0205, 0.06))]), at=(x - 0.48, y, z + 0.15), turn=15)
    for k, dx in enumerate((-0.4, 0.4)):
        stool(room, m, f"Stool {k}", (x + dx, 0.001, z + 0.62))


def add_fruit(room, m, at, draw):
    """A glass bowl of apples, oranges, bananas and grapes."""
    segments = room.steps(40, 16)
    bowl = lathe([(0, 0), (0.06, 0), (0.062, 0.004)] + smooth_line(
        [(0.07, 0.008), (0.14, 0.05), (0.165, 0.1)], 7) + [(0.163, 0.102)] + smooth_line(
            [(0.161, 0.1), (0.136, 0.053), (0.06, 0.014), (0.001, 0.0125)], 7) + [(0, 0.0125)], segments)
    room.add("Fruit bowl", m["glass"], bowl, at=at)
    fruit, stem = tableware.apple(0.036, room.steps(28, 16), room.steps(18, 12))
    for k in range(7):
        a = 2 * math.pi * k / 6
        spot = (0.075 * math.cos(a), 0.068, 0.075 * math.sin(a)) if k < 6 else (0, 0.058, 0)
        parts = [(m[("apple", "green apple")[k % 2]], fruit), (m["stem"], stem)]
        if k % 3 == 2:
            parts = [(m["orange"], ball(0.037, room.steps(28, 16), 0.96))]
        room.place(f"Fruit {k}", room.mesh_of(f"Fruit {k}", parts), turn=40 * k,
                   at=(at[0] + spot[0], at[1] + spot[1], at[2] + spot[2]))
    room.add("Grapes", m["grape"], tableware.grapes(46, 0.0095, room.steps(18, 14), draw),
             at=(at[0] + 0.02, at[1] + 0.105, at[2] + 0.01))
    bunch = [tableware.banana(0.16, 0.016, room.steps(18, 12), 12 * k).moved(0.01 * k, 0.004 * k, 0.03 * k)
             for k in range(3)]
    room.add("Bananas", m["banana"], joined(bunch), at=(at[0] - 0.27, at[1], at[2] - 0.14), turn=-30)


def stool(room, m, name, at):
    """A stool: turned seat, four legs, a ring."""
    seat = lathe([(0, 0.62), (0.16, 0.62), (0.172, 0.628), (0.175, 0.64), (0.17, 0.65), (0.15, 0.654),
                  (0, 0.648)], room.steps(40, 16))
    legs = [tube([(0.19 * math.cos(a), 0.0, 0.19 * math.sin(a)), (0.1 * math.cos(a), 0.6195,
                                                                 0.1 * math.sin(a))], 0.011, 16)
            for a in (math.pi / 4 + math.pi / 2 * k for k in range(4))]
    ring = tube([(0.165 * math.cos(a), 0.2, 0.165 * math.sin(a)) for a in
                 (2 * math.pi * k / 48 for k in range(48))], 0.007, 14, closed=True)
    room.place(name, room.mesh_of(name, [(m["beech"], seat), (m["black"], joined(legs + [ring]))]), at=at)


def add_lights(room, m):
    """Three hanging lamps over the island, ceiling spots, the sun and the sky."""
    shade = lathe([(0.15, 0), (0.145, 0.03), (0.11, 0.09), (0.04, 0.14), (0.02, 0.16), (0.02, 0.2)],
                  room.steps(48, 16))
    inside = lathe([(0.018, 0.19), (0.018, 0.155), (0.038, 0.136), (0.108, 0.086), (0.143, 0.028),
                    (0.148, 0.0)], room.steps(48, 16))
    cord = tube([(0, 0.2, 0), (0, 0.748, 0)], 0.003, 14, caps=False)
    mesh = room.mesh_of("Hanging lamp", [
        (m["copper"], shade), (m["white"], inside), (m["rubber"], cord),
        (m["bulb"], props.bulb(0.026, 24).turned("x", 180).moved(0, 0.12, 0))])
    for k in range(3):
        room.place(f"Hanging lamp {k}", mesh, at=(ISLAND[0] - 0.5 + 0.5 * k, 1.849, ISLAND[1]))
    for k, (x, z) in enumerate(((-1.5, -0.6), (-1.5, 0.6), (0.0, -0.8), (1.5, 0.2))):
        room.spot_at(f"Ceiling spot {k}", (x, HEIGHT - 0.01, z), (x - 0.1, 0.9, z - 0.3), 30, 0.75,
                     (1, 0.92, 0.8), 0.03)
    room.point("Ceiling light", (0.9, 2.35, 2.3), 10, (1, 0.9, 0.78), 0.08)
    room.sun("Sun", (-0.35, -0.75, 0.7), 8, (1, 0.94, 0.85))
    room.world((0.65, 0.82, 1), 1.1)


def build(room):
    draw = random.Random(2)
    m = add_materials(room)
    add_shell(room, m, draw)
    add_counters(room, m)
    add_hob(room, m)
    open_shelves(room, m, draw)
    add_left_counter(room, m)
    add_island(room, m, draw)
    add_lights(room, m)
    room.camera((1.3, 1.45, 2.55), (-0.35, 1.07, -0.6), 0.78)


if __name__ == "__main__":
    run(build)
