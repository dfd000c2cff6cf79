"""Writes a furnished museum hall as a .glb: python3 bench/scenes/museum.py OUT.glb [--detail N]"""

import math
import random

import architecture
import props
import statuary
import textures
from room_writer import run
from solids import bevelled_box, box, joined, lathe, merged, rectangle, tube

X, Z, HEIGHT = 5.0, 8.0, 5.2  # the hall: x from -X to X, z from -Z to Z
CELL, COLUMNS, ROWS = 2.0, 5, 8  # of the ceiling and of the floor
SKY_ROWS = range(1, 7)  # the cells of the middle column that are skylights
CASES = tuple((x, z) for z in (5.0, 2.0, -1.0, -4.0) for x in (-1.5, 1.5))
PLINTH, CASE = 0.95, (0.8, 1.0, 0.8)  # height of a plinth; width, height, depth of a glass cover
SHAPES = (((0.11, 0.005), (0.09, 0.03), (0.25, 0.3), (0.29, 0.55), (0.2, 0.75), (0.1, 0.86), (0.15, 1.0)),
          ((0.09, 0.005), (0.1, 0.05), (0.24, 0.45), (0.25, 0.62), (0.1, 0.78), (0.085, 0.92), (0.12, 1.0)),
          ((0.15, 0.005), (0.2, 0.1), (0.32, 0.35), (0.3, 0.5), (0.2, 0.72), (0.26, 1.0)))


def opaque_materials(room):
    """Materials that neither transmit nor emit, by name."""
    white = room.image(textures.stone((0.82, 0.81, 0.79), (0.62, 0.62, 0.63), 3), 0.7)
    oak = room.image(textures.wood((0.4, 0.26, 0.15), (0.62, 0.44, 0.28), 2), 2)
    rough = room.image(textures.brushed(0.2, 0.4, 3))
    patina = room.image(textures.grain_bumps(32, 0.004), 3)
    return {
        "wall": room.matte("Wall", (1, 1, 1), room.image(textures.speckle((0.8, 0.74, 0.66), 0.03, 4))),
        "plaster": room.matte("Plaster", (0.78, 0.77, 0.74)),
        "joint": room.matte("Joints", (0.3, 0.29, 0.28)),
        "column": room.paint("Column stone", (0.95, 0.93, 0.88), 0.45, texture=white),
        "plinth": room.paint("Plinth", (0.22, 0.23, 0.25), 0.3),
        "velvet": room.matte("Case lining", (0.15, 0.04, 0.05)),
        "marble": room.paint("Statue marble", (0.97, 0.96, 0.93), 0.3, texture=white),
        "bronze": room.metal("Bronze", (0.5, 0.34, 0.2), 0.3, normalTexture=patina),
        "gold": room.metal("Gold", (0.8, 0.65, 0.3), 0.15),
        "silver": room.metal("Silver", (0.8, 0.8, 0.78), 0.2),
        "copper": room.metal("Copper", (0.78, 0.48, 0.35), 0.3),
        "brass": room.metal("Brass", (0.78, 0.6, 0.32), 1, rough_texture=rough),
        "steel": room.metal("Black steel", (0.15, 0.15, 0.16), 0.4),
        "polished": room.metal("Polished bronze", (0.8, 0.62, 0.36), 0.05),
        "pearl": room.paint("Pearl", (0.8, 0.78, 0.74), 0.15),
        "bead": room.paint("Turquoise", (0.1, 0.5, 0.48), 0.2),
        "oak": room.paint("Oak", (0.95, 0.95, 0.95), 0.4, texture=oak),
        "rope": room.matte("Red rope", (0.5, 0.04, 0.05)),
        "card": room.paint("Label", (0.78, 0.77, 0.72), 0.5),
    }


def clear_and_emissive_materials(room):
    """Materials that transmit or emit, by name."""
    return {
        "glass": room.glass("Case glass", 1.5),
        "roof": room.glass("Roof glass", 1.5),
        "blue glass": room.glass("Blue glass", 1.5, absorb=((0.25, 0.5, 0.9), 0.02)),
        "diamond": room.glass("Diamond", 2.4),
        "ruby": room.glass("Ruby", 1.77, absorb=((0.8, 0.05, 0.08), 0.01)),
        "emerald": room.glass("Emerald", 1.58, absorb=((0.1, 0.7, 0.25), 0.01)),
        "disc": room.emitter("Case light", (1, 0.93, 0.82), 60),
        "wash": room.emitter("Wall light", (1, 0.86, 0.68), 14),
        "sign": room.emitter("Exit sign", (0.1, 0.9, 0.3), 6),
    }


def add_materials(room):
    """All materials by name."""
    m = {**opaque_materials(room), **clear_and_emissive_materials(room)}
    for k, (base, vein) in enumerate((((0.8, 0.78, 0.72), (0.65, 0.62, 0.56)), ((0.5, 0.22, 0.17), (0.7, 0.5, 0.42)),
                                      ((0.2, 0.3, 0.25), (0.5, 0.58, 0.5)), ((0.15, 0.15, 0.16), (0.42, 0.4, 0.38)))):
        m[f"stone {k}"] = room.paint(f"Floor stone {k}", (0.95, 0.95, 0.95), 0.12,
                                     texture=room.image(textures.stone(base, vein, 30 + k)))
    for k, colors in enumerate((((0.7, 0.3, 0.12), (0.08, 0.06, 0.05)), ((0.75, 0.7, 0.6), (0.12, 0.2, 0.45)),
                                ((0.2, 0.4, 0.36), (0.75, 0.65, 0.4)))):
        m[f"vase {k}"] = room.paint(f"Painted vase {k}", (0.95, 0.95, 0.95), 0.25,
                                    texture=room.image(textures.stripes(list(colors), 40 + k, 14), 4))
    for k in range(4):
        m[f"painting {k}"] = room.matte(f"Painting {k}", (0.85, 0.85, 0.85),
                                        room.image(textures.painting(50 + k)))
    return m


def add_shell(room, m):
    """Walls with mouldings, a floor of inlaid panels, a coffered ceiling with skylights."""
    room.add("Joints", m["joint"], rectangle((-X, -0.003, Z), (2 * X, 0, 0), (0, 0, -2 * Z)))
    low, high = -0.003, HEIGHT
    walls = [rectangle((-X, low, -Z), (2 * X, 0, 0), (0, high - low, 0)),
             rectangle((X, low, Z), (-2 * X, 0, 0), (0, high - low, 0)),
             rectangle((-X, low, Z), (0, 0, -2 * Z), (0, high - low, 0)),
             rectangle((X, low, -Z), (0, 0, 2 * Z), (0, high - low, 0))]
    room.add("Walls", m["wall"], joined(walls))
    kinds = architecture.inlay(CELL)
    panel = room.mesh_of("Floor panel", [(m[f"stone {k}"], joined(kinds[k])) for k in range(4)])
    for i in range(COLUMNS):
        for j in range(ROWS):
            room.place(f"Floor panel {i}.{j}", panel, turn=90.0 * ((i + j) % 4),
                       at=(CELL * (i + 0.5) - X, 0, CELL * (j + 0.5) - Z))
    corners = [(-X + 0.001, Z - 0.001), (X - 0.001, Z - 0.001), (X - 0.001, -Z + 0.001),
               (-X + 0.001, -Z + 0.001)]
    room.add("Skirting", m["column"], props.skirting(corners, [
        (0.05, 0.001), (0.05, 0.2), (0.035, 0.22), (0.02, 0.225), (0.015, 0.25), (0.0, 0.25)]))
    room.add("Cornice", m["plaster"], props.skirting(corners, [
        (0.0, high - 0.6), (0.03, high - 0.58), (0.03, high - 0.48), (0.06, high - 0.46), (0.08, high - 0.4),
        (0.14, high - 0.34), (0.22, high - 0.3), (0.22, high - 0.22), (0.28, high - 0.12), (0.3, high - 0.001)]))
    add_ceiling(room, m)


def add_ceiling(room, m):
    """Coffers with rosettes; the middle cells are wells under panes of glass in steel bars."""
    coffers, wells = [], []
    flower = architecture.rosette(0.28, 8, room.steps(6, 4), room.steps(6, 4))
    mesh = room.mesh_of("Rosette", [(m["plaster"], flower)])
    for i in range(COLUMNS):
        for j in range(ROWS):
            x, z = CELL * (i + 0.5) - X, CELL * (j + 0.5) - Z
            if i == COLUMNS // 2 and j in SKY_ROWS:
                wells.append(architecture.coffer(CELL, x, z, HEIGHT, 0.7, is_open=True))
                skylight(room, m, f"Skylight {j}", (x, HEIGHT + 0.6, z), CELL * 0.8)
            else:
                coffers.append(architecture.coffer(CELL, x, z, HEIGHT, 0.36))
                room.place(f"Rosette {i}.{j}", mesh, at=(x, HEIGHT + 0.359, z), turn=11.0 * (i + j))
    room.add("Ceiling", m["plaster"], merged(joined(coffers + wells), 1e-6))


def skylight(room, m, name, at, size):
    """Four panes of 12 mm in a frame of steel bars."""
    bars, panes, half = [], [], size / 2
    for k in (-1, 0, 1):
        bars.append(bevelled_box(0.05, 0.06, size - 0.004, 0.004, 4).moved(k * (half - 0.028), -0.03, 0))
        for s in (-1, 1):
            bars.append(box((half - 0.079), 0.05, 0.05, ("left", "right"))
                        .moved(s * (half / 2 - 0.0015), -0.026, k * (half - 0.028)))
    for sx in (-1, 1):
        for sz in (-1, 1):
            panes.append(box(half - 0.07, 0.012, half - 0.07).moved(sx * (half / 2 - 0.002), -0.006,
                                                                  sz * (half / 2 - 0.002)))
    room.place(name, room.mesh_of(name, [(m["steel"], joined(bars)), (m["roof"], joined(panes))]), at=at)


def add_columns(room, m):
    """Two rows of fluted columns."""
    shaft, rest = architecture.column(0.3, HEIGHT - 0.001, 20, room.steps(6, 6), room.steps(14, 6),
                                      room.steps(64, 16))
    mesh = room.mesh_of("Column", [(m["column"], joined([shaft, rest]))])
    for k in range(5):
        for side in (-1, 1):
            room.place(f"Column {side} {k}", mesh, at=(side * 3.5, 0.001, 6.4 - 3.2 * k))


def add_case(room, m, name, at, exhibits, turn=0.0):
    """A showcase: plinth, lining, glass cover, four small lights inside, a label, a spot light above."""
    wide, high, deep = CASE
    discs = [lathe([(0, 0), (0.018, 0), (0.02, 0.002), (0.02, 0.008), (0, 0.008)], 24)
             .moved(sx * (wide / 2 - 0.06), high - 0.02, sz * (deep / 2 - 0.06)) for sx in (-1, 1) for sz in (-1, 1)]
    label = bevelled_box(0.2, 0.08, 0.004, 0.001, 1).turned("x", -20).moved(0, 0.003, deep / 2 - 0.06)
    room.place(name, room.mesh_of(name, [
        (m["plinth"], architecture.plinth(wide + 0.04, PLINTH, deep + 0.04, room.steps(4, 4)).moved(0, -PLINTH, 0)),
        (m["velvet"], bevelled_box(wide - 0.04, 0.012, deep - 0.04, 0.003, 4).moved(0, 0.001, 0)),
        (m["glass"], architecture.glass_cover(wide, high, deep, 0.008).moved(0, 0.001, 0)),
        (m["disc"], joined(discs)), (m["card"], label.moved(0, 0.0135, 0))]),
        at=(at[0], PLINTH + 0.001, at[1]), turn=turn)
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    for k, (key, solid, x, z) in enumerate(exhibits):
        room.add(f"{name} exhibit {k}", m[key], solid, turn=turn,
                 at=(at[0] + c * x + s * z, PLINTH + 0.0145, at[1] - s * x + c * z))
    side = -1 if at[0] > 0 else 1
    lamp = (at[0] + side * 0.9, HEIGHT - 0.35, at[1] + 0.8)
    room.place(f"{name} lamp", room.mesh_of(f"{name} lamp", [(m["steel"], joined(
        [architecture.track_light(room.steps(32, 16)), tube([(0, 0.15, 0), (0, 0.345, 0)], 0.006, 14)]))]), at=lamp)
    room.spot_at(f"{name} spot", (lamp[0], lamp[1] - 0.002, lamp[2]), (at[0], PLINTH + 0.4, at[1]), 130, 0.3,
                 (1, 0.93, 0.84), 0.03)


def exhibits(room, draw):
    """What stands in each of the eight showcases: (material, solid, x, z)."""
    n, steps = room.steps(72, 24), room.steps(8, 4)
    bust = statuary.bust(room.steps(110, 40), steps, 1.0)
    other = statuary.bust(room.steps(90, 40), steps, 7.0).scaled(0.95)
    vases = [statuary.vase(high, 0.006, n, steps, SHAPES[k % 3]) for k, high in enumerate((0.55, 0.34, 0.3))]
    amphora = joined([statuary.vase(0.6, 0.006, n, steps, SHAPES[1]),
                      statuary.handles(0.6, 0.06, ((0.4, 0.118), (0.53, 0.052)), 0.011, 16, 6)])
    coins = []
    for k in range(40):
        struck = statuary.coin(draw.uniform(0.012, 0.02), room.steps(36, 16), k)
        coins.append((("gold", "silver", "copper")[k % 3], struck.turned("y", draw.uniform(0, 360)),
                      0.08 * (k % 8) - 0.28, 0.07 * (k // 8) - 0.3))
    gems = [(("diamond", "ruby", "emerald")[k % 3], statuary.gem(draw.uniform(0.025, 0.038), 8).moved(0, 0.0005, 0),
             0.115 * (k % 6) - 0.29, 0.12 * (k // 6) + 0.08) for k in range(12)]
    jewels = [("bead", statuary.necklace(0.13, 40, 0.007, room.steps(20, 16)), -0.2, 0.2),
              ("pearl", statuary.necklace(0.12, 42, 0.006, room.steps(20, 16)), 0.2, 0.2)]
    figures = [("bronze", statuary.figure(0.42 + 0.1 * k, room.steps(64, 32), steps // 2, k + 3.0),
                (-0.22, 0.0, 0.22)[k], (0.1, -0.12, 0.1)[k]) for k in range(3)]
    return (
        [("vase 0", vases[0], -0.14, -0.15), ("vase 1", vases[1], 0.2, -0.1)] + jewels,
        coins + gems,
        [("marble", bust, 0, 0)],
        figures,
        [("blue glass", statuary.knot(0.24, 0.05, room.steps(160, 64), room.steps(28, 16)), 0, 0)],
        [("vase 1", amphora, -0.12, 0), ("vase 0", vases[2], 0.2, 0.1)],
        [("marble", other, -0.15, 0), ("polished", statuary.bird(0.8, n, steps), 0.2, 0.05)],
        [("vase 2", vases[2].scaled(2), 0, 0)])


def add_centre(room, m):
    """A large marble figure on a round plinth behind ropes, and benches."""
    z = -5.6
    foot = lathe([(0, 0), (0.75, 0), (0.75, 0.14), (0.7, 0.15), (0.68, 0.2), (0.6, 0.22), (0.6, 0.68),
                  (0.64, 0.72), (0.68, 0.74), (0.68, 0.8), (0.66, 0.81), (0, 0.81)], room.steps(80, 24))
    room.add("Round plinth", m["plinth"], foot, at=(0, 0.001, z))
    room.add("Figure", m["marble"], statuary.figure(2.0, room.steps(150, 40), room.steps(12, 4), 0.5),
             at=(0, 0.812, z))
    post, places = architecture.barrier_post(room.steps(36, 16)), []
    for k in range(8):
        a = 2 * math.pi * (k + 0.5) / 8
        places.append((1.25 * math.cos(a), 0.0, 1.25 * math.sin(a)))
    ropes = [architecture.rope((a[0], 0.86, a[2]), (b[0], 0.86, b[2]), 0.18, 0.016, room.steps(24, 8), 14)
             for a, b in zip(places, places[1:] + places[:1])]
    room.place("Barrier", room.mesh_of("Barrier", [
        (m["brass"], joined([post.moved(*p) for p in places])), (m["rope"], joined(ropes))]), at=(0, 0.001, z))
    wood, frames = architecture.bench(1.6, 7, 6)
    mesh = room.mesh_of("Bench", [(m["oak"], wood), (m["steel"], frames)])
    for k, (x, bz) in enumerate(((0, 3.5), (0, 0.3), (-4.4, 4.8), (4.4, 4.8), (-4.4, -1.6), (4.4, -1.6))):
        room.place(f"Bench {k}", mesh, at=(x, 0.001, bz), turn=90)


def add_walls(room, m):
    """Framed paintings, wall lights and exit signs between the columns."""
    for k in range(8):
        side, row = (-1, 1)[k % 2], k // 2
        wide, high = ((1.5, 1.1), (1.1, 1.5))[(k + row) % 2]
        moulding = props.frame(wide, high, 0.1, 0.06)
        canvas = rectangle((-wide / 2 + 0.09, -high / 2 + 0.09, 0.01), (wide - 0.18, 0, 0), (0, high - 0.18, 0))
        canvas.uvs = [((0, 0), (1, 0), (1, 1), (0, 1))]
        z = 4.8 - 3.2 * row
        room.place(f"Painting {k}", room.mesh_of(f"Painting {k}", [
            (m[("gold", "oak", "bronze")[k % 3]], moulding), (m[f"painting {k % 4}"], canvas)]),
            at=(side * (X - 0.002), 2.0, z), turn=-90 * side)
        lamp = [tube([(0, 0, 0.0), (0, 0.06, 0.12)], 0.008, 14, caps=False), tube(
            [(-0.3, 0.06, 0.13), (0.3, 0.06, 0.13)], 0.022, 20)]
        glow = box(0.56, 0.006, 0.02).moved(0, 0.029, 0.13)
        room.place(f"Picture light {k}", room.mesh_of("Picture light", [(m["brass"], joined(lamp)), (m["wash"], glow)]),
                   at=(side * (X - 0.002), 2.0 + high / 2 + 0.12, z), turn=-90 * side)
    for k, z in enumerate((-Z, Z)):
        door = [bevelled_box(1.0, 2.6, 0.06, 0.008, 4).moved(s * 0.503, 0, 0.03) for s in (-1, 1)]
        panels = [props.frame(0.74, 0.7, 0.05, 0.018).moved(s * 0.503, 0.5 + 0.8 * j, 0.061)
                  for s in (-1, 1) for j in range(3)]
        knobs = [props.knob(0.03, 28).moved(s * 0.08, 1.05, 0.061) for s in (-1, 1)]
        sign = bevelled_box(0.5, 0.18, 0.03, 0.006, 4).moved(0, 3.3, 0.02)
        room.place(f"Door {k}", room.mesh_of(f"Door {k}", [
            (m["oak"], joined(door + panels)), (m["brass"], joined(knobs)), (m["sign"], sign)]),
            at=(0, 0.002, z + 0.002 * (1 - 2 * k)), turn=180.0 * k)


def add_lights(room):
    """Sun and sky above the skylights, spot lights on the figure, point lights in the aisles."""
    room.sun("Sun", (0.25, -1, -0.18), 6, (1, 0.95, 0.86))
    room.world((0.75, 0.87, 1), 1.6)
    for k, x in enumerate((-1.6, 1.6)):
        room.spot_at(f"Figure spot {k}", (x, HEIGHT - 0.3, -3.4), (0, 2.0, -5.6), 220, 0.35, (1, 0.92, 0.82), 0.04)
    for k, z in enumerate((-4.8, 0.0, 4.8)):
        for side in (-1, 1):
            room.point(f"Aisle light {k} {side}", (side * 4.3, HEIGHT - 0.7, z), 45, (1, 0.88, 0.72), 0.08)


def build(room):
    draw = random.Random(4)
    m = add_materials(room)
    add_shell(room, m)
    add_columns(room, m)
    for k, (at, things) in enumerate(zip(CASES, exhibits(room, draw))):
        add_case(room, m, f"Case {k}", at, things, 0.0)
    add_centre(room, m)
    add_walls(room, m)
    add_lights(room)
    room.camera((0.55, 1.78, 6.9), (0.05, 1.55, -2.0), 0.86)


if __name__ == "__main__":
    run(build)
