"""Writes a furnished workshop as a .glb: python3 bench/scenes/workshop.py OUT.glb [--detail N]"""

import math
import random

import parts
import props
import tableware
import textures
import vectors as v3
from room_writer import run
from solids import (ball, bevelled_box, disc_outline, extrude, joined, lathe, loft, rectangle,
                    smooth_line, tube)

X, Z0, Z1, HEIGHT = 2.6, -1.8, 2.6, 2.8  # the room: x from -X to X
BENCH = (-0.45, 2.5, 0.75, 0.86)  # middle, width, depth, height
LATHE = (1.75, 0.93)  # its middle and the height of its bed
TUBES = ((-1.1, -0.9), (1.1, -0.9), (-1.1, 0.9), (1.1, 0.9))


def opaque_materials(room):
    """Materials that neither transmit nor emit, by name."""
    oak = room.image(textures.wood((0.38, 0.25, 0.14), (0.62, 0.45, 0.3), 2), 2)
    pine = room.image(textures.wood((0.62, 0.46, 0.28), (0.78, 0.62, 0.42), 5, 7), 2)
    rough = room.image(textures.brushed(0.2, 0.45, 3), 4)
    concrete = room.image(textures.speckle((0.5, 0.49, 0.47), 0.1, 8, 128), 0.7)
    hammered = room.image(textures.grain_bumps(40, 0.006), 5)
    return {
        "block 0": room.matte("White block", (0.76, 0.76, 0.74)),
        "block 1": room.matte("Grey block", (0.68, 0.68, 0.67)),
        "mortar": room.matte("Mortar", (0.5, 0.5, 0.49)),
        "ceiling": room.matte("Ceiling", (0.75, 0.75, 0.74)),
        "concrete": room.paint("Concrete", (0.9, 0.9, 0.9), 0.5, texture=concrete),
        "plate": room.metal("Floor plate", (0.5, 0.5, 0.52), 0.35),
        "oak": room.paint("Bench top", (0.95, 0.95, 0.95), 0.5, texture=oak),
        "pine": room.paint("Pine", (0.95, 0.95, 0.95), 0.6, texture=pine),
        "peg": room.matte("Hardboard", (0.62, 0.48, 0.32)),
        "steel": room.metal("Tool steel", (0.62, 0.62, 0.64), 0.25),
        "brushed": room.metal("Brushed steel", (0.7, 0.7, 0.71), 1, rough_texture=rough),
        "chrome": room.metal("Chrome", (0.8, 0.8, 0.82), 0.06),
        "zinc": room.metal("Zinc", (0.72, 0.74, 0.76), 0.35),
        "brass": room.metal("Brass", (0.8, 0.62, 0.3), 0.2),
        "copper": room.metal("Copper", (0.8, 0.5, 0.38), 0.25),
        "black": room.metal("Burnt steel", (0.12, 0.12, 0.13), 0.45),
        "green": room.paint("Machine green", (0.16, 0.32, 0.26), 0.35, normalTexture=hammered),
        "grey": room.paint("Machine grey", (0.35, 0.38, 0.4), 0.4, normalTexture=hammered),
        "red": room.paint("Red enamel", (0.55, 0.06, 0.05), 0.25),
        "blue": room.paint("Blue bins", (0.08, 0.2, 0.5), 0.35),
        "yellow": room.paint("Yellow bins", (0.75, 0.5, 0.05), 0.35),
        "rubber": room.paint("Rubber", (0.04, 0.04, 0.04), 0.7),
        "amber": room.paint("Handle resin", (0.75, 0.35, 0.04), 0.15),
        "white": room.paint("White enamel", (0.78, 0.78, 0.76), 0.2),
        "card": room.matte("Cardboard", (0.5, 0.36, 0.22)),
        "rope": room.matte("Rope", (0.6, 0.48, 0.3)),
    }


def clear_and_emissive_materials(room):
    """Materials that transmit or emit, by name."""
    return {
        "glass": room.glass("Glass", 1.5, priority=2),
        "lens": room.glass("Lens", 1.52),
        "oil": room.glass("Oil", 1.47, absorb=((0.75, 0.5, 0.06), 0.03), priority=1),
        "spirit": room.glass("Spirit", 1.36, absorb=((0.4, 0.3, 0.85), 0.06), priority=1),
        "tube": room.emitter("Fluorescent tube", (0.92, 1, 0.96), 22),
        "bulb": room.emitter("Work bulb", (1, 0.8, 0.55), 150),
        "led": room.emitter("Green LED", (0.1, 1, 0.2), 12),
        "red led": room.emitter("Red LED", (1, 0.08, 0.04), 12),
    }


def add_materials(room):
    """All materials by name."""
    m = {**opaque_materials(room), **clear_and_emissive_materials(room)}
    for k, color in enumerate(((0.7, 0.68, 0.6), (0.2, 0.35, 0.55), (0.55, 0.2, 0.1))):
        m[f"can {k}"] = room.paint(f"Can label {k}", (0.85, 0.85, 0.85), 0.3,
                                   texture=room.image(textures.stripes([color, (0.8, 0.8, 0.78)], k, 6), 5))
    return m


def block_wall(room, m, name, wide, draw, at, turn):
    """A wall of blocks in half bond over a plane of mortar, facing +z before its turn."""
    lists = ([], [])
    for row in range(14):
        x = -0.2 * (row % 2)
        while x < wide - 0.005:
            left, right = max(x, 0.0), min(x + 0.4, wide)
            shape = props.tile(right - left - 0.008, 0.192, 0.006, room.steps(4, 4))
            lists[draw.random() < 0.3].append(shape.moved(left + 0.004, 0.2 * row + 0.004, 0.001))
            x += 0.4
    plane = rectangle((0, -0.002, 0), (wide, 0, 0), (0, HEIGHT + 0.002, 0))
    room.place(name, room.mesh_of(name, [(m["mortar"], plane), (m["block 0"], joined(lists[0])),
                                         (m["block 1"], joined(lists[1]))]), at=at, turn=turn)


def add_shell(room, m, draw):
    """Block walls, ceiling, concrete floor, a floor plate with bumps in front of the bench."""
    room.add("Floor", m["concrete"], rectangle((-X, -0.002, Z1), (2 * X, 0, 0), (0, 0, Z0 - Z1)))
    room.add("Ceiling", m["ceiling"], rectangle((-X, HEIGHT, Z0), (2 * X, 0, 0), (0, 0, Z1 - Z0)))
    block_wall(room, m, "Back wall", 2 * X, draw, (-X, 0, Z0), 0)
    block_wall(room, m, "Left wall", Z1 - Z0, draw, (-X, 0, Z1), 90)
    block_wall(room, m, "Right wall", Z1 - Z0, draw, (X, 0, Z0), -90)
    room.add("Front wall", m["mortar"], rectangle((X, -0.002, Z1), (-2 * X, 0, 0), (0, HEIGHT + 0.002, 0)))
    bump = lathe([(0.025, 0), (0.021, 0.0028), (0.014, 0.0046), (0.006, 0.0054), (0, 0.0055)],
                 room.steps(16, 16)).scaled(1, 1, 0.4)
    bumps = [bump.turned("y", 45 if (i + j) % 2 else -45).moved(0.06 * i - 0.96, 0.0066, 0.06 * j - 0.3)
             for i in range(33) for j in range(11)]
    plate = bevelled_box(2.06, 0.006, 0.68, 0.001, 1)
    room.add("Floor plate", m["plate"], joined([plate] + bumps), at=(BENCH[0], 0.001, -0.55))


def add_bench(room, m):
    """A bench of planks on a steel frame with drawers and a lower shelf."""
    x, wide, deep, high = BENCH
    z = Z0 + 0.02 + deep / 2
    tops = [bevelled_box(wide, 0.05, deep / 5 - 0.001, 0.003, 1).moved(0, 0, deep * (k - 2) / 5)
            for k in range(5)]
    room.add("Bench top", m["oak"], joined(tops), at=(x, high - 0.05, z))
    legs = [bevelled_box(0.06, high - 0.053, 0.06, 0.006, 4).moved(sx * (wide / 2 - 0.1), 0,
                                                                  sz * (deep / 2 - 0.06))
            for sx in (-1, 1) for sz in (-1, 1)]
    bars = [bevelled_box(wide - 0.262, 0.05, 0.03, 0.004, 4).moved(0, y, sz * (deep / 2 - 0.06))
            for sz in (-1, 1) for y in (0.15, high - 0.11)]
    room.add("Bench frame", m["grey"], joined(legs + bars), at=(x, 0.001, z))
    room.add("Bench shelf", m["pine"], bevelled_box(wide - 0.3, 0.02, deep - 0.22, 0.003, 1),
             at=(x, 0.21, z))
    drawers, handles = [], []
    for k in range(3):
        drawers.append(bevelled_box(0.5, 0.14, 0.5, 0.005, 4).moved(0.6, 0.33 + 0.15 * k, 0.04))
        handles.append(props.handle(0.14, 0.006, 0.03, 14, 6).moved(0.6, 0.4 + 0.15 * k, 0.2905))
    room.place("Drawers", room.mesh_of("Drawers", [(m["red"], joined(drawers)),
                                                   (m["chrome"], joined(handles))]), at=(x, 0.001, z))
    for k in range(3):
        room.add(f"Carton {k}", m["card"], parts.crate(0.3, 0.2 + 0.04 * k, 0.3),
                 at=(x - 0.85 + 0.42 * k, 0.2315, z - 0.02), turn=4 * k - 5)
    vise, steel = parts.vise(room.steps(3))
    room.place("Vise", room.mesh_of("Vise", [(m["blue"], vise), (m["steel"], steel)]),
               at=(x - 0.95, high + 0.001, z + 0.2))


def add_pegboard(room, m):
    """A pegboard with hooks and the tools that hang on it."""
    x0, y0, z, pitch = BENCH[0] - 1.2, 1.22, Z0 + 0.03, 0.04
    board = parts.pegboard(60, 27, pitch, 0.0045, room.steps(4, 3))
    room.add("Pegboard", m["peg"], board, at=(x0, y0, z))
    slats = [bevelled_box(2.4, 0.03, 0.019, 0.002, 1).moved(1.2, y, -0.012) for y in (-0.031, 1.081)]
    room.add("Slats", m["pine"], joined(slats), at=(x0, y0, z))
    hooks = []
    def hang(name, column, row, solids, tilt=0.0):
        px, py = pitch * (column + 0.5), pitch * (row + 0.5)
        hooks.append(parts.hook(0.05, 0.002, 13).moved(px, py, 0))
        room.place(name, room.mesh_of(name, solids), at=(x0 + px, y0 + py, z + 0.022),
                   rotation=v3.axis_turn((0, 0, 1), tilt))
    steps = room.steps(3)
    for k in range(9):
        length, jaw = 0.13 + 0.022 * k, 0.011 + 0.0022 * k
        tool = parts.wrench(length, jaw, steps).turned("z", 180).moved(0, -length / 2 + 0.9 * jaw, 0)
        hang(f"Wrench {k}", 2 + 2 * k, 24, [(m["chrome"], tool)], 0.8 * (k % 3 - 1))
    for k in range(8):
        steel, grip = parts.screwdriver(0.16 + 0.015 * k, 0.014, steps)
        hang(f"Screwdriver {k}", 22 + 2 * k, 24, [
            (m["steel"], steel.moved(0, -0.1 - 0.011 * k, 0)), (m["amber"], grip.moved(0, -0.1 - 0.011 * k, 0))])
    for k in range(3):
        head, grip = parts.hammer(0.3 - 0.03 * k, steps)
        turned = [(m["steel"], head), (m["pine"], grip)]
        hang(f"Hammer {k}", 42 + 6 * k, 14, [(a, b.turned("y", 90).moved(0, -0.24 + 0.03 * k, 0.012))
                                             for a, b in turned], 2 * k)
    for k in range(5):
        steel, rubber = parts.pliers(0.16 + 0.02 * k, steps)
        hang(f"Pliers {k}", 3 + 4 * k, 13, [(m["steel"], steel), (m["red"], rubber)])
    blade, grip = parts.saw(0.42, 70)
    hang("Saw", 26, 12, [(m["brushed"], blade.moved(0.04, -0.06, 0)), (m["pine"], grip.moved(0.04, -0.06, 0))], -4)
    add_hanging_gears(m, hang)
    coil = [tube([((0.09 + 0.006 * math.sin(9 * a + k)) * math.cos(a), (0.1 + 0.004 * k) * math.sin(a) - 0.09,
                   0.006 * k + 0.004 * math.sin(5 * a)) for a in (2 * math.pi * i / 60 for i in range(60))],
                 0.0035, 14, closed=True) for k in range(5)]
    hang("Cable", 54, 24, [(m["rope"], joined(coil))])
    room.add("Hooks", m["zinc"], joined(hooks), at=(x0, y0, z))


def add_hanging_gears(m, hang):
    """Gears of several sizes on the lower rows of the pegboard."""
    for k, teeth in enumerate((18, 24, 36, 30, 20, 28)):
        wheel = parts.gear(teeth, 0.0035, 0.012, 0.008)
        metal = m[("steel", "brass", "black")[k % 3]]
        hang(f"Gear {k}", 5 + 4 * k + (k > 2) * 2, 5 + k % 2, [(metal, wheel.moved(0, -0.006, 0.004))], 7 * k)


def spread(draw, count, area, cell):
    """Places on a jittered grid over area (x0, z0, x1, z1), `cell` metres apart, with a turn."""
    x0, z0, x1, z1 = area
    columns, rows = int((x1 - x0) / cell), int((z1 - z0) / cell)
    spots = [(i, j) for j in range(rows) for i in range(columns)]
    draw.shuffle(spots)
    for i, j in spots[:count]:
        yield (x0 + (i + 0.5 + draw.uniform(-0.12, 0.12)) * cell,
               z0 + (j + 0.5 + draw.uniform(-0.12, 0.12)) * cell, draw.uniform(0, 360))


def add_small_parts(room, m, draw):
    """Nuts, bolts, washers, springs, gears and balls, loose on the bench."""
    x, _, _, high = BENCH
    y, z0 = high + 0.001, Z0 + 0.02
    kinds = []  # name, metal, shape and the size of its cell
    for size in (0.014, 0.019, 0.024):
        kinds.append((f"Nut {size}", "zinc", parts.nut(size, room.steps(4, 4)), size * 1.5))
        kinds.append((f"Washer {size}", "brass", parts.washer(size * 0.6, size * 0.32, size * 0.09,
                                                             room.steps(28, 16)), size * 1.7))
        kinds.append((f"Bolt {size}", "zinc", parts.bolt(size, size * 3, 8, room.steps(18, 16)),
                      size * 1.5))
    areas = ((x - 0.75, z0 + 0.28, x - 0.15, z0 + 0.56), (x - 0.1, z0 + 0.28, x + 0.5, z0 + 0.56))
    for number, (name, metal, solid, cell) in enumerate(kinds):
        mesh = room.mesh_of(name, [(m[metal], solid)])
        a = areas[number % 2]
        third = (a[2] - a[0]) / 5
        low = a[0] + third * (number // 2)
        for k, (px, pz, turn) in enumerate(spread(draw, 15, (low, a[1], low + third, a[3]), cell)):
            room.place(f"{name} {k}", mesh, at=(px, y, pz), turn=turn)
    for k, (px, pz, turn) in enumerate(spread(draw, 8, (x + 0.55, z0 + 0.28, x + 0.85, z0 + 0.7), 0.1)):
        wheel = parts.gear(12 + 2 * k, 0.0028, 0.01, 0.005).turned("x", -90).moved(0, 0.0021, 0)
        room.add(f"Loose gear {k}", m[("brass", "steel", "copper")[k % 3]], wheel, at=(px, y, pz), turn=turn)
    coil = parts.spring(0.009, 0.0011, 0.045, 9, room.steps(18, 12), 14)
    mesh = room.mesh_of("Spring", [(m["steel"], coil.turned("x", 90).moved(0, 0.0102, 0))])
    for k, (px, pz, turn) in enumerate(spread(draw, 14, (x + 0.88, z0 + 0.28, x + 1.08, z0 + 0.7), 0.07)):
        room.place(f"Spring {k}", mesh, at=(px, y, pz), turn=turn)


def tray_of_balls(room, m, at, draw):
    """A steel tray with bearing balls in a heap of layers."""
    tray = parts.bin_of(0.2, 0.04, 0.14, 0.002)
    shape, balls = ball(0.0095, room.steps(20, 16)), []
    for layer in range(2):
        for i in range(9 - layer):
            for j in range(6 - layer):
                balls.append(shape.moved(-0.08 + 0.0195 * (i + layer / 2), 0.0122 + 0.0139 * layer,
                                         -0.05 + 0.0195 * (j + layer / 2) + draw.uniform(0, 1e-4)))
    room.place("Ball tray", room.mesh_of("Ball tray", [(m["brushed"], tray), (m["chrome"], joined(balls))]),
               at=at, turn=12)


def add_bins(room, m, draw):
    """A row of plastic bins with nuts, pins and washers, below the pegboard."""
    x, _, _, high = BENCH
    pin = lathe([(0, 0), (0.004, 0), (0.005, 0.001), (0.005, 0.034), (0.004, 0.035), (0, 0.035)], 16)
    fill = (parts.nut(0.02, 3), pin.turned("x", 90), parts.washer(0.012, 0.006, 0.0015, 16))
    for k in range(16):
        at = (x - 1.14 + 0.152 * k, high + 0.0015, Z0 + 0.14)
        things = []
        for layer in range(2):
            for px, pz, turn in spread(draw, 5, (-0.055, -0.085, 0.055, 0.085), 0.03):
                thing = fill[k % 3].turned("x", draw.uniform(-25, 25)).turned("y", turn)
                things.append(thing.moved(px, 0.014 + 0.021 * layer, pz))
        room.place(f"Bin {k}", room.mesh_of(f"Bin {k}", [
            (m[("blue", "yellow", "red")[k % 3]], parts.bin_of(0.145, 0.12, 0.22, 0.003)),
            (m[("zinc", "steel", "brass")[k % 3]], joined(things))]), at=at)


def add_bottles(room, m):
    """Jars, an oil bottle, a bottle of spirit, and a magnifier on an arm."""
    x, _, _, high = BENCH
    y, segments = high + 0.001, room.steps(36, 16)
    for k, (radius, tall, liquid) in enumerate(((0.035, 0.22, "oil"), (0.04, 0.26, "spirit"))):
        glass, inside = tableware.bottle(radius, tall, segments)
        room.place(f"Bottle of {liquid}", room.mesh_of(f"Bottle of {liquid}", [
            (m["glass"], glass), (m[liquid], props.filling(inside, tall * 0.5, 0.0008, segments))]),
            at=(x + 1.16, y, Z0 + 0.36 + 0.12 * k))
    lens = lathe([(0, -0.012)] + [(0.06 * math.sin(t), -0.012 * math.cos(t) ** 2 - 0.002 * (t > 0))
                                  for t in (math.pi / 2 * k / 12 for k in range(1, 13))] +
                 [(0.06 * math.sin(t), 0.012 * math.cos(t) ** 2 + 0.002)
                  for t in (math.pi / 2 * k / 12 for k in range(12, 0, -1))] + [(0, 0.014)], segments)
    rim = parts.extrude_ring(disc_outline(0.067, 48), disc_outline(0.0605, 48), 0.012)
    arm = tube(smooth_line([(0.06, 0, 0), (0.1, 0.005, 0), (0.18, -0.08, -0.02), (0.2, -0.22, -0.02)], 8),
               0.006, 16)
    foot = lathe([(0, 0), (0.06, 0), (0.06, 0.012), (0.05, 0.018), (0.01, 0.02)], segments)
    room.place("Magnifier", room.mesh_of("Magnifier", [
        (m["lens"], lens), (m["black"], joined([rim.turned("x", -90).moved(0, -0.006, 0), arm,
                                               foot.moved(0.2, -0.24, -0.02)]))]),
        at=(x + 0.1, y + 0.24, Z0 + 0.69))


def add_lathe(room, m):
    """A metal lathe on a cabinet: bed, headstock, chuck with a turned work piece, carriage, tailstock."""
    x, y = LATHE
    z = Z0 + 0.36
    legs = [bevelled_box(0.36, y - 0.16, 0.44, 0.01, 4).moved(dx, 0, 0) for dx in (-0.42, 0.42)]
    tray = [bevelled_box(1.3, 0.02, 0.56, 0.004, 4).moved(0, y - 0.159, 0)]
    bed = [bevelled_box(1.2, 0.11, 0.035, 0.004, 1).moved(0, y - 0.13, s * 0.07) for s in (-1, 1)]
    bed += [extrude([(-0.02, 0), (0.02, 0), (0, 0.014)], 1.19).turned("y", 90)
            .moved(-0.595, y - 0.0195, s * 0.07) for s in (-1, 1)]
    head = [bevelled_box(0.32, 0.27, 0.26, 0.02, 4).moved(-0.42, y - 0.018, 0)]
    room.place("Lathe body", room.mesh_of("Lathe body", [
        (m["green"], joined(legs + head)), (m["grey"], joined(tray)), (m["brushed"], joined(bed))]),
        at=(x, 0.001, z))
    axis = y + 0.13
    add_chuck(room, m, (x - 0.258, axis, z))
    slide = [bevelled_box(0.16, 0.03, 0.24, 0.005, 4).moved(0, y - 0.004, 0.02),
             bevelled_box(0.09, 0.035, 0.15, 0.004, 1).moved(0, y + 0.027, 0.05),
             bevelled_box(0.06, 0.05, 0.06, 0.003, 1).moved(0, y + 0.063, 0.06),
             bevelled_box(0.012, 0.012, 0.1, 0.001, 1).moved(-0.01, y + 0.1245, 0.03),
             bevelled_box(0.14, 0.16, 0.05, 0.008, 4).moved(0, y - 0.17, 0.145)]
    wheels = [parts.handwheel(0.055, 14, room.steps(40, 16)).moved(-0.03, y - 0.1, 0.19),
              parts.handwheel(0.03, 14, room.steps(32, 16)).moved(0, y + 0.05, 0.16)]
    room.place("Carriage", room.mesh_of("Carriage", [(m["green"], joined(slide[:1] + slide[4:])),
                                                     (m["steel"], joined(slide[1:4])),
                                                     (m["chrome"], joined(wheels))]), at=(x + 0.1, 0, z))
    tail = [bevelled_box(0.16, 0.16, 0.13, 0.015, 4).moved(0, y - 0.004, 0)]
    quill = lathe([(0, -0.03), (0.02, -0.03), (0.02, 0.13), (0.014, 0.132), (0.0, 0.17)], room.steps(28, 16))
    room.place("Tailstock", room.mesh_of("Tailstock", [
        (m["green"], joined(tail)), (m["steel"], quill.turned("z", 90).moved(-0.04, axis, 0)),
        (m["chrome"], parts.handwheel(0.05, 14, room.steps(40, 16)).turned("y", 90).moved(0.1, axis, 0))]),
        at=(x + 0.42, 0, z))
    screw = parts.thread(0.011, 0.008, room.steps(110, 40), 16).turned("z", -90)
    room.add("Lead screw", m["steel"], screw, at=(x - 0.3, y - 0.08, z + 0.125))
    lamps = [lathe([(0.008, 0), (0.007, 0.004), (0.003, 0.006), (0, 0.0065)], 20).turned("x", 90)
             .moved(-0.5 + 0.05 * k, y + 0.2, 0.1305) for k in range(3)]
    dials = [props.knob(0.022, 24).moved(-0.5 + 0.07 * k, y + 0.1, 0.1303) for k in range(3)]
    room.place("Lathe panel", room.mesh_of("Lathe panel", [
        (m["led"], joined(lamps[:2])), (m["red led"], lamps[2]), (m["rubber"], joined(dials))]), at=(x, 0, z))


def add_chuck(room, m, at):
    """A chuck with three stepped jaws that holds a turned brass work piece, along +x from `at`."""
    body = lathe([(0, 0), (0.075, 0), (0.08, 0.004), (0.08, 0.05), (0.076, 0.054), (0.02, 0.054),
                  (0.02, 0.03), (0, 0.03)], room.steps(56, 16))
    jaws = []
    for k in range(3):
        jaw = [bevelled_box(0.03, 0.02, 0.022, 0.001, 1).moved(0.055, 0.053, 0),
               bevelled_box(0.018, 0.015, 0.0221, 0.001, 1).moved(0.046, 0.072, 0)]
        jaws += [part.turned("y", 120 * k + 20) for part in jaw]
    work = lathe([(0, 0.032), (0.036, 0.032), (0.036, 0.12), (0.03, 0.122), (0.03, 0.15), (0.024, 0.152)] +
                 smooth_line([(0.024, 0.16), (0.033, 0.18), (0.02, 0.21), (0.028, 0.235)], 6) +
                 [(0.024, 0.25), (0.024, 0.3), (0.012, 0.302), (0.012, 0.38), (0, 0.38)], room.steps(48, 16))
    shapes = [(m["brushed"], body), (m["steel"], joined(jaws)), (m["brass"], work)]
    room.place("Chuck", room.mesh_of("Chuck", [(a, s.turned("z", -90)) for a, s in shapes]), at=at)


def add_shelves(room, m):
    """Shelves on the left wall with cans, cartons and jars of screws."""
    z, wide, segments = -0.55, 1.5, room.steps(40, 16)
    boards = [bevelled_box(0.32, 0.025, wide, 0.003, 1).moved(0, y, 0) for y in (0.1, 0.6, 1.1, 1.6, 2.05)]
    posts = [bevelled_box(0.035, 2.2, 0.035, 0.003, 4).moved(sx * 0.18, 0, sz * 0.6)
             for sx in (-1, 1) for sz in (-1, 1)]
    room.place("Shelves", room.mesh_of("Shelves", [(m["pine"], joined(boards)), (m["grey"], joined(posts))]),
               at=(-X + 0.22, 0.001, z))
    shape = parts.can(0.085, 0.2, segments)
    for k in range(10):
        mesh = room.mesh_of(f"Can {k % 3}", [(m[f"can {k % 3}"], shape)])
        room.place(f"Can {k}", mesh, turn=50.0 * k,
                   at=(-X + 0.25, (0.627, 1.127)[k // 5], z - 0.48 + 0.21 * (k % 5)))
    for k in range(8):
        glass, top, full = tableware.jar(0.05, 0.14, segments)
        full = full.scaled(1, 0.9, 1).moved(0, 0.0007, 0)
        room.place(f"Screw jar {k}", room.mesh_of(f"Screw jar {k}", [
            (m["glass"], glass), (m[("zinc", "red")[k % 2]], top), (m[("brass", "zinc")[k % 2]], full)]),
            at=(-X + 0.28, 1.627, z - 0.5 + 0.14 * k))
    for k in range(3):
        room.add(f"Box {k}", m["card"], parts.crate(0.28, 0.3 - 0.04 * k, 0.36), turn=3 * k,
                 at=(-X + 0.23, (0.127, 2.077, 2.077)[k], z - 0.3 + 0.45 * (k % 2)))


def add_lights(room, m):
    """Four fluorescent fittings, two work lamps on jointed arms, spots."""
    high = HEIGHT - 0.32
    tube_shape = lathe([(0, -0.6), (0.013, -0.598), (0.013, 0.598), (0, 0.6)], room.steps(20, 16)).turned("z", 90)
    reflector = loft([[(x, y, z) for x in (-0.64, 0.64)] for y, z in
                      ((0.02, 0.14), (0.06, 0.07), (0.09, 0.05), (0.09, -0.05), (0.06, -0.07), (0.02, -0.14))],
                     caps=False, open_rings=True)
    wires = [tube([(dx, 0.09, 0), (dx, 0.3, 0)], 0.002, 14, caps=False) for dx in (-0.5, 0.5)]
    fitting = room.mesh_of("Fitting", [(m["white"], reflector), (m["black"], joined(wires)),
                                       (m["tube"], joined([tube_shape.moved(0, 0.02, s * 0.04)
                                                           for s in (-1, 1)]))])
    for k, (x, z) in enumerate(TUBES):
        room.place(f"Fitting {k}", fitting, at=(x, high, z))
    for k, (x, z, turn) in enumerate(((BENCH[0] - 1.1, Z0 + 0.37, 10), (LATHE[0] + 0.05, Z0 + 0.12, 10))):
        work_lamp(room, m, f"Work lamp {k}", (x, BENCH[3] + 0.002 if k == 0 else LATHE[1] - 0.136, z), turn)
    for k, (x, tx) in enumerate(((-1.3, -1.1), (0.3, 0.2), (1.6, 1.6))):
        room.spot_at(f"Wall spot {k}", (x, 2.6, -0.6), (tx, 1.2, Z0), 14, 0.5, (1, 0.9, 0.8), 0.03)


def work_lamp(room, m, name, at, turn):
    """A jointed arm on a foot with a shade, a bulb and a spot light."""
    foot = lathe([(0, 0), (0.08, 0), (0.08, 0.015), (0.07, 0.022), (0.012, 0.024), (0.012, 0.04), (0, 0.04)], 40)
    low, elbow, head = (0, 0.035, 0), (-0.16, 0.42, 0), (0.08, 0.66, 0.14)
    arms = [tube([v3.along(a, (0, 0, 1), dz), v3.along(b, (0, 0, 1), dz)], 0.005, 14)
            for a, b in ((low, elbow), (elbow, head)) for dz in (-0.012, 0.012)]
    joints = [lathe([(0, -0.02), (0.013, -0.02), (0.013, 0.02), (0, 0.02)], 24).turned("x", 90).moved(*p)
              for p in (elbow, head)]
    coils = [parts.spring(0.007, 0.0012, 0.12, 16, 16, 14).turned("z", 22).moved(-0.02, 0.14, s * 0.026)
             for s in (-1, 1)]
    shade = lathe([(0.085, -0.09), (0.08, -0.05), (0.05, 0.0), (0.03, 0.03), (0.03, 0.07), (0, 0.07)], 40)
    bulb = props.bulb(0.022, 24).turned("x", 180).moved(0, 0.02, 0)
    aim = [s.turned("x", -25).turned("z", 15).moved(head[0], head[1] - 0.09, head[2] + 0.01) for s in (shade, bulb)]
    room.place(name, room.mesh_of(name, [(m["red"], joined([foot, aim[0]])), (m["steel"], joined(arms + joints)),
                                         (m["zinc"], joined(coils)), (m["bulb"], aim[1])]), at=at, turn=turn)
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    x, z = at[0] + c * head[0] + s * head[2], at[2] - s * head[0] + c * head[2]
    room.spot_at(f"{name} spot", (x, at[1] + head[1] - 0.22, z), (x, at[1], z + 0.1), 8, 0.6, (1, 0.85, 0.65))


def build(room):
    draw = random.Random(3)
    m = add_materials(room)
    add_shell(room, m, draw)
    add_bench(room, m)
    add_pegboard(room, m)
    add_small_parts(room, m, draw)
    tray_of_balls(room, m, (BENCH[0] - 0.3, BENCH[3] + 0.001, Z0 + 0.67), draw)
    add_bins(room, m, draw)
    add_bottles(room, m)
    add_lathe(room, m)
    add_shelves(room, m)
    add_lights(room, m)
    room.camera((-0.8, 1.5, 0.45), (0.08, 1.2, -1.6), 0.9)


if __name__ == "__main__":
    run(build)
