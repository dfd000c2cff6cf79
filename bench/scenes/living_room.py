"""Writes a furnished living room as a .glb: python3 bench/scenes/living_room.py OUT.glb [--detail N]"""

import math
import random

import props
import textures
from room_writer import run
from solids import (ball, bevelled_box, box, joined, lathe, rectangle, sheet, smooth_line, soft_box,
                    tube)

X, Z0, Z1, HEIGHT = 3.0, -2.6, 2.9, 2.7  # the room: x from -X to X
WINDOW = (2.7, 0.75, 4.7, 2.3)  # hole in the left wall: distance from the front, height


def opaque_materials(room):
    """Materials that neither transmit nor emit, by name."""
    wood = room.image(textures.wood((0.33, 0.2, 0.11), (0.62, 0.42, 0.25), 1), 2)
    oak = room.image(textures.wood((0.5, 0.36, 0.22), (0.76, 0.6, 0.42), 2), 2)
    cloth = room.image(textures.weave((0.42, 0.5, 0.55), (0.35, 0.42, 0.48)), 12)
    linen = room.image(textures.weave((0.85, 0.78, 0.66), (0.8, 0.72, 0.6), 64), 4)
    rough = room.image(textures.brushed(0.2, 0.4, 3))
    return {
        "wall": room.matte("Wall paint", (1, 1, 1), room.image(
            textures.speckle((0.86, 0.83, 0.77), 0.02, 4))),
        "ceiling": room.matte("Ceiling", (0.78, 0.78, 0.76)),
        "white": room.paint("White paint", (0.75, 0.74, 0.71), 0.35),
        "floor a": room.paint("Oak a", (0.8, 0.75, 0.7), 0.35, texture=wood),
        "floor b": room.paint("Oak b", (0.95, 0.85, 0.8), 0.4, texture=wood),
        "floor c": room.paint("Oak c", (0.9, 0.9, 0.85), 0.35, texture=oak),
        "below": room.matte("Screed", (0.12, 0.1, 0.09)),
        "oak": room.paint("Oak furniture", (0.95, 0.95, 0.95), 0.45, texture=oak),
        "walnut": room.paint("Walnut", (0.8, 0.75, 0.7), 0.4, texture=wood),
        "sofa": room.matte("Sofa cloth", (1, 1, 1), cloth),
        "velvet": room.matte("Ochre velvet", (0.62, 0.36, 0.06)),
        "rust": room.matte("Rust cloth", (0.5, 0.14, 0.07), linen),
        "cream": room.matte("Cream wool", (0.8, 0.75, 0.66), linen),
        "rug": room.matte("Rug", (1, 1, 1), room.image(textures.stripes(
            [(0.72, 0.3, 0.22), (0.85, 0.75, 0.6), (0.25, 0.3, 0.42), (0.8, 0.55, 0.3)], 5), 0.5)),
        "fringe": room.matte("Fringe", (0.75, 0.68, 0.55)),
        "chrome": room.metal("Chrome", (0.8, 0.8, 0.82), 0.08),
        "brass": room.metal("Brass", (0.8, 0.6, 0.3), 1, rough_texture=rough),
        "black": room.metal("Black steel", (0.2, 0.2, 0.21), 0.5),
        "plastic": room.paint("Black plastic", (0.03, 0.03, 0.035), 0.25),
        "paper": room.matte("Paper", (0.78, 0.75, 0.66)),
        "pot": room.paint("Terracotta", (0.55, 0.25, 0.14), 0.7, normalTexture=room.image(
            textures.grain_bumps(24, 0.01))),
        "soil": room.matte("Soil", (0.08, 0.05, 0.03)),
        "stem": room.matte("Stem", (0.25, 0.3, 0.1)),
        "glaze": room.paint("Blue glaze", (0.08, 0.2, 0.4), 0.12),
        "wax": room.paint("Candle wax", (0.8, 0.74, 0.6), 0.4),
    }


def clear_and_emissive_materials(room):
    """Materials that transmit or emit, by name."""
    return {
        "curtain": room.paper("Curtain", (0.75, 0.7, 0.62), 0.4),
        "shade": room.paper("Lampshade", (0.8, 0.7, 0.55), 0.5, (0.9, 0.7, 0.45)),
        "glass": room.glass("Glass", 1.5, priority=2),
        "pane": room.glass("Window glass", 1.5),
        "smoked": room.glass("Table glass", 1.5, absorb=((0.7, 0.85, 0.8), 0.03)),
        "wine": room.glass("Red wine", 1.34, absorb=((0.45, 0.02, 0.04), 0.02), priority=1),
        "water": room.glass("Water", 1.333, priority=1),
        "leaf": room.paper("Leaf", (0.12, 0.3, 0.06), 0.35, (0.3, 0.55, 0.08)),
        "bulb": room.emitter("Warm bulb", (1, 0.76, 0.5), 120),
        "flame": room.emitter("Flame", (1, 0.6, 0.25), 90),
        "strip": room.emitter("Shelf strip", (1, 0.85, 0.65), 8),
        "screen": room.emitter("Screen", (1, 1, 1), 2.5, room.image(textures.landscape(4))),
    }


def add_materials(room):
    """All materials by name."""
    m = {**opaque_materials(room), **clear_and_emissive_materials(room)}
    for k, color in enumerate(((0.5, 0.08, 0.06), (0.1, 0.2, 0.4), (0.1, 0.3, 0.18), (0.7, 0.6, 0.4),
                               (0.15, 0.13, 0.12), (0.6, 0.35, 0.1), (0.7, 0.7, 0.68),
                               (0.3, 0.12, 0.3))):
        m[f"book {k}"] = room.paint(f"Book {k}", color, 0.4 + 0.05 * k)
    for k in range(3):
        m[f"painting {k}"] = room.matte(f"Painting {k}", (0.85, 0.85, 0.85),
                                        room.image(textures.painting(11 + k)))
    return m


def add_shell(room, m, draw):
    """Walls, ceiling, floor boards, mouldings, and the window in the left wall."""
    props.floor_of_planks(room, "Floor", [m["floor a"], m["floor b"], m["floor c"]],
                          (-X, Z0, X, Z1), (1.5, 0.18), draw)
    room.add("Screed", m["below"], rectangle((-X, -0.006, Z1), (2 * X, 0, 0), (0, 0, Z0 - Z1)))
    room.add("Ceiling", m["ceiling"], rectangle((-X, HEIGHT, Z0), (2 * X, 0, 0), (0, 0, Z1 - Z0)))
    low = -0.006
    walls = [rectangle((-X, low, Z0), (2 * X, 0, 0), (0, HEIGHT - low, 0)),
             rectangle((X, low, Z0), (0, 0, Z1 - Z0), (0, HEIGHT - low, 0)),
             rectangle((X, low, Z1), (-2 * X, 0, 0), (0, HEIGHT - low, 0))]
    left = props.wall_with_hole(Z1 - Z0, HEIGHT - low, WINDOW, 0.25)
    walls.append(left.turned("y", 90).moved(-X, low, Z1))
    room.add("Walls", m["wall"], joined(walls))
    corners = [(-X + 0.001, Z1 - 0.001), (X - 0.001, Z1 - 0.001), (X - 0.001, Z0 + 0.001),
               (-X + 0.001, Z0 + 0.001)]
    room.add("Skirting board", m["white"], props.skirting(
        corners, [(0.018, 0.001), (0.018, 0.08), (0.012, 0.09), (0.006, 0.1), (0.0, 0.1)]))
    room.add("Cornice", m["ceiling"], props.skirting(
        corners, [(0.0, HEIGHT - 0.12), (0.02, HEIGHT - 0.11), (0.02, HEIGHT - 0.09),
                  (0.05, HEIGHT - 0.05), (0.09, HEIGHT - 0.03), (0.1, HEIGHT - 0.001)]))
    add_window(room, m)


def add_window(room, m):
    """Frame, panes, sill, rod with rings, and two curtains."""
    wide, high = WINDOW[2] - WINDOW[0] - 0.004, WINDOW[3] - WINDOW[1] - 0.004
    z, y = Z1 - (WINDOW[0] + WINDOW[2]) / 2, (WINDOW[1] + WINDOW[3]) / 2 - 0.006
    frame, panes = props.window(wide, high, 3)
    room.place("Window", room.mesh_of("Window", [(m["white"], frame), (m["pane"], panes)]),
               at=(-X - 0.15, y, z), turn=90)
    room.add("Sill", m["white"], bevelled_box(0.2, 0.03, wide + 0.2, 0.008, 4),
             at=(-X + 0.102, WINDOW[1] - 0.04, z))
    rod = tube([(0, 0, -wide / 2 - 0.4), (0, 0, wide / 2 + 0.4)], 0.012, 16)
    ends = [ball(0.025, 20).moved(0, 0, s * (wide / 2 + 0.43)) for s in (-1, 1)]
    room.add("Curtain rod", m["brass"], joined([rod] + ends), at=(-X + 0.16, 2.45, z))
    columns, rows = room.steps(190), room.steps(36)
    for k, shift in enumerate((-wide / 2 - 0.38, wide / 2 - 0.12)):
        cloth = props.curtain(0.5, 2.41, 9, 0.035, columns, rows, 2.0 * k)
        room.add(f"Curtain {k}", m["curtain"], cloth.turned("y", -90),
                 at=(-X + 0.16, 2.43, z + shift))
    ring = tube([(0.022 * math.cos(a), 0.022 * math.sin(a) - 0.008, 0) for a in
                 (2 * math.pi * k / 20 for k in range(20))], 0.003, 8, closed=True)
    mesh = room.mesh_of("Curtain ring", [(m["brass"], ring)], 60)
    for k in range(18):
        side, i = divmod(k, 9)
        room.place(f"Curtain ring {k}", mesh, scale=0.9,
                   at=(-X + 0.16, 2.447, z + (-wide / 2 - 0.36, wide / 2 - 0.1)[side] + 0.056 * i))


def cushion(room, size, seed, cells=30, puff=0.03, wrinkle=0.006):
    """A smooth cushion with wrinkles."""
    soft = soft_box(size, min(size) * 0.42, room.steps(cells, 8), puff)
    return soft.displaced(props.crumple(wrinkle, 7, seed))


def add_sofa(room, m, name, cloth, seats, at, turn, draw):
    """A sofa or armchair: base, arms, seat and back cushions, legs, loose pillows."""
    wide = 0.68 * seats
    base = [bevelled_box(wide, 0.2, 0.85, 0.03, 4).moved(0, 0.12, 0),
            bevelled_box(wide, 0.45, 0.16, 0.05, 4).moved(0, 0.33, -0.34)]
    for side in (-1, 1):
        arm = soft_box((0.17, 0.5, 0.9), 0.06, room.steps(24), 0.006)
        base.append(arm.moved(side * (wide / 2 + 0.087), 0.37, 0))
    parts = [(cloth, joined(base))]
    soft = []
    for k in range(seats):
        x = -wide / 2 + 0.68 * (k + 0.5)
        soft.append(cushion(room, (0.66, 0.17, 0.66), 3 * k + seats).moved(x, 0.415, 0.09))
        soft.append(cushion(room, (0.64, 0.46, 0.17), 5 * k + 1).turned("x", -14)
                    .moved(x, 0.735, -0.17))
    parts.append((cloth, joined(soft)))
    legs = [lathe([(0.012, 0), (0.014, 0.001), (0.025, 0.118)], 20).moved(x, 0, z)
            for x in (-wide / 2 + 0.06, wide / 2 - 0.06) for z in (-0.35, 0.35)]
    parts.append((m["brass"], joined(legs)))
    room.place(name, room.mesh_of(name, parts), at=at, turn=turn)
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    for k, key in enumerate(("velvet", "rust", "cream")[:max(1, seats)]):
        x = (-0.42, 0.36, 0.12)[k] * wide if seats > 1 else 0.0
        pillow = cushion(room, (0.42, 0.42, 0.1), 9 * k + draw.random(), 44, 0.05, 0.012)
        pillow = pillow.turned("x", -22).turned("y", draw.uniform(-20, 20))
        room.add(f"{name} pillow {k}", m[key], pillow, turn=turn,
                 at=(at[0] + c * x + s * 0.08, 0.76, at[2] - s * x + c * 0.08))


def add_rug(room, m, at, size):
    """A rug with a bumpy pile, a field of knots, and a fringe of ribbons at both ends."""
    wide, deep = size
    def pile(u, v):
        x, z = wide * (u - 0.5), deep * (0.5 - v)
        edge = min(u, 1 - u, v, 1 - v)
        return (x, 0.002 + 0.012 * min(1.0, 30 * edge) + 0.0012 * math.sin(70 * x) *
                math.sin(66 * z), z)
    body = sheet(room.steps(110), room.steps(80), pile)
    body.uvs = [tuple((u, v) for u, v in uv) for uv in body.uvs]
    knot = lathe([(0.016, 0), (0.0145, 0.005), (0.0105, 0.009), (0.006, 0.0115), (0, 0.0125)],
                 room.steps(14, 14))
    knots = [knot.moved(wide * (i / 25 - 0.5) * 0.96, 0.013, deep * (j / 15 - 0.5) * 0.94)
             for i in range(26) for j in range(16)]
    ribbons = []
    for side in (-1, 1):
        for k in range(140):
            z = deep * (k / 139 - 0.5) * 0.985
            bend = 0.02 * math.sin(12.9 * k)
            ribbons.append(sheet(1, 4, lambda u, v, z=z, b=bend, s=side: (
                s * (wide / 2 + 0.07 * v - 0.004), 0.006 - 0.004 * v + 0.002 * math.sin(5 * v + z),
                z + (0.008 * u - 0.004) * s * -1 + b * v * v)))
    room.place("Rug", room.mesh_of("Rug", [(m["rug"], body), (m["cream"], joined(knots)),
                                           (m["fringe"], joined(ribbons))]), at=at)


def add_table(room, m, at):
    """A coffee table: glass top, steel legs, wooden shelf; returns the height of its top."""
    wide, deep, top = 1.15, 0.65, 0.42
    glass = bevelled_box(wide, 0.012, deep, 0.004, 4).moved(0, top - 0.012, 0)
    shelf = bevelled_box(wide - 0.16, 0.02, deep - 0.14, 0.006, 4).moved(0, 0.17, 0)
    steel = []
    for x in (-wide / 2 + 0.06, wide / 2 - 0.06):
        path = [(x, top - 0.025, -deep / 2 + 0.06), (x, 0.03, -deep / 2 + 0.03),
                (x, 0.014, -deep / 2 + 0.05), (x, 0.014, deep / 2 - 0.05),
                (x, 0.03, deep / 2 - 0.03), (x, top - 0.025, deep / 2 - 0.06)]
        steel.append(tube(smooth_line(path, 8), 0.011, room.steps(16, 14)))
        for z in (-deep / 2 + 0.06, deep / 2 - 0.06):
            steel.append(lathe([(0, 0), (0.02, 0), (0.02, 0.008), (0, 0.008)], 24)
                         .moved(x, top - 0.0215, z))
        for z in (-0.2, 0.2):
            steel.append(tube([(x, 0.18, z), (x * 0.8, 0.18, z)], 0.006, 14))
    room.place("Coffee table", room.mesh_of("Coffee table", [
        (m["smoked"], glass), (m["walnut"], shelf), (m["chrome"], joined(steel))]), at=at)
    return top + 0.001


def add_tableware(room, m, at):
    """Wine glasses (two of them filled), a carafe of water, tumblers, candles, a bowl of fruit."""
    x, y, z = at
    segments, steps = room.steps(40, 16), room.steps(7, 4)
    glass, inside = props.wine_glass(0.21, 0.042, 0.0016, segments, steps)
    full = [(m["glass"], glass), (m["wine"], props.filling(inside, 0.135, 0.0008, segments))]
    meshes = [room.mesh_of("Wine glass", full[:1]), room.mesh_of("Wine glass filled", full)]
    for k, (dx, dz) in enumerate(((-0.3, 0.14), (0.02, 0.2), (-0.14, -0.16), (0.3, -0.12))):
        room.place(f"Wine glass {k}", meshes[k % 2], at=(x + dx, y, z + dz))
    glass, inside = props.carafe(0.27, 0.075, 0.0025, segments, steps)
    room.place("Carafe", room.mesh_of("Carafe", [
        (m["glass"], glass), (m["water"], props.filling(inside, 0.13, 0.001, segments))]),
        at=(x - 0.06, y, z + 0.02))
    glass, inside = props.drinking_glass(0.1, 0.034, 0.002, segments, steps)
    tumbler = room.mesh_of("Tumbler", [
        (m["glass"], glass), (m["water"], props.filling(inside, 0.06, 0.0008, segments))])
    for k, (dx, dz) in enumerate(((-0.42, -0.08), (0.18, 0.05))):
        room.place(f"Tumbler {k}", tumbler, at=(x + dx, y, z + dz))
    add_candles(room, m, [(x + 0.4, y, z + 0.1), (x + 0.46, y, z + 0.16), (x + 0.47, y, z + 0.05)])
    bowl = lathe([(0, 0), (0.05, 0), (0.05, 0.006)] + smooth_line(
        [(0.055, 0.007), (0.11, 0.04), (0.13, 0.075)], 6) + [(0.126, 0.076)] + smooth_line(
            [(0.124, 0.072), (0.105, 0.044), (0.05, 0.014), (0.001, 0.0125)], 6) +
        [(0, 0.0125)], segments)
    room.add("Bowl", m["glaze"], bowl, at=(x + 0.02, y, z - 0.2))
    fruit = ball(0.034, room.steps(24, 16), 0.93)
    spots = [(0.035 * math.cos(a), 0.052, 0.045 * math.sin(a)) for a in (0.3, 1.9, 3.4, 5.0)]
    for k, (dx, dy, dz) in enumerate(spots + [(0, 0.1, 0)]):
        room.add(f"Fruit {k}", m[("velvet", "rust")[k % 2]], fruit,
                 at=(x + 0.02 + dx, y + dy, z - 0.2 + dz))


def add_candles(room, m, places):
    """Candles in small glass cups, with flames that emit."""
    for k, place in enumerate(places):
        cup, _ = props.drinking_glass(0.07, 0.028, 0.002, room.steps(28, 16), 4)
        wax = lathe([(0, 0.014), (0.0195, 0.014), (0.0195, 0.045), (0.012, 0.043), (0, 0.0425)], 28)
        flame = lathe([(0, 0)] + smooth_line([(0.001, 0.0005), (0.005, 0.007), (0.003, 0.018),
                                             (0.0003, 0.028)], 4) + [(0, 0.0285)], 16)
        room.place(f"Candle {k}", room.mesh_of("Candle", [
            (m["glass"], cup), (m["wax"], wax), (m["flame"], flame.moved(0, 0.05, 0)),
            (m["black"], tube([(0, 0.0435, 0), (0.001, 0.0495, 0)], 0.0008, 6))]), at=place)


def book_sizes(draw):
    return draw.uniform(0.018, 0.05), draw.uniform(0.17, 0.28), draw.uniform(0.13, 0.2)


def add_bookshelf(room, m, at, draw):
    """A bookshelf of 2 x 5 bays with books: some objects each, some rows joined to one object."""
    wide, high, deep, board = 1.9, 2.1, 0.3, 0.025
    boards = [bevelled_box(board, high, deep, 0.003, 1).moved(x, 0, 0)
              for x in (-wide / 2, 0, wide / 2)]
    levels = [0.06 + k * (high - 0.085) / 5 for k in range(6)]
    bay = wide / 2 - board
    for level in levels:
        boards += [bevelled_box(bay - 0.001, board, deep - 0.01, 0.003, 1).moved(x, level, 0)
                   for x in (-wide / 4, wide / 4)]
    boards.append(rectangle((-wide / 2, 0.01, -deep / 2 + 0.002), (wide, 0, 0), (0, high - 0.02, 0)))
    room.add("Bookshelf", m["oak"], joined(boards), at=at)
    shapes = []
    for k in range(24):
        size = book_sizes(draw)
        parts = [(m[f"book {k % 8}"], bevelled_box(*size, 0.002, room.steps(4, 4)))]
        if k % 3:
            cover, pages = props.book(*size, room.steps(8, 8))
            parts = [(m[f"book {k % 8}"], cover), (m["paper"], pages)]
        shapes.append((size, parts))
    meshes = [room.mesh_of(f"Book {k}", parts) for k, (_, parts) in enumerate(shapes)]
    for row in range(10):
        bay_x = (-wide / 2 if row % 2 == 0 else 0) + board / 2 + 0.004
        y = at[1] + levels[row // 2] + board + 0.001
        row_of_books(room, (shapes, meshes), row, (at[0] + bay_x, y, at[2] + deep / 2 - 0.03),
                     bay - 0.01, draw)
    strips = [box(bay - 0.1, 0.008, 0.012).moved(x, level - 0.0095, deep / 2 - 0.03)
              for level in levels[3:] for x in (-wide / 4, wide / 4)]
    room.add("Shelf lights", m["strip"], joined(strips), at=at)


def row_of_books(room, books, row, at, room_left, draw):
    """Books side by side from at to the right; odd rows are joined to one object."""
    shapes, meshes = books
    x, k, parts = 0.0, 0, {}
    limit = room_left * draw.choice((1.0, 1.0, 0.8, 0.65))
    while True:
        pick = draw.randrange(len(shapes))
        (thick, _, deep), book = shapes[pick]
        if x + thick > limit:
            break
        place = (at[0] + x + thick / 2, at[1], at[2] - deep / 2 - draw.uniform(0, 0.02))
        if row % 3:
            for material, solid in book:
                parts.setdefault(material, []).append(solid.moved(*place))
        else:
            room.place(f"Book {row}.{k}", meshes[pick], at=place)
        x += thick + draw.uniform(0.001, 0.003)
        k += 1
    if parts:
        room.place(f"Books {row}", room.mesh_of(f"Books {row}", [
            (material, joined(solids)) for material, solids in parts.items()]))


def add_sideboard(room, m, at):
    """A sideboard with doors and handles, a TV, loudspeakers and a table lamp on it."""
    wide, high, deep = 2.0, 0.5, 0.42
    body = [bevelled_box(wide, high - 0.1, deep, 0.004, 1).moved(0, 0.1, 0)]
    doors = [bevelled_box(wide / 4 - 0.008, high - 0.13, 0.018, 0.004, 4)
             .moved(-wide / 2 + wide / 4 * (k + 0.5), 0.115, deep / 2 + 0.0105) for k in range(4)]
    handles = [props.handle(0.12, 0.005, 0.03, 14, 6).turned("z", 90)
               .moved(-wide / 4 * s + d, 0.3, deep / 2 + 0.0185)
               for s in (-1, 1) for d in (-0.04, 0.04)]
    legs = [lathe([(0.01, 0), (0.02, 0.0985)], 20).moved(x, 0, z)
            for x in (-0.9, 0.9) for z in (-0.15, 0.15)]
    room.place("Sideboard", room.mesh_of("Sideboard", [
        (m["walnut"], joined(body)), (m["white"], joined(doors)),
        (m["brass"], joined(handles + legs))]), at=at)
    x, _, z = at
    y = at[1] + high + 0.001
    case = bevelled_box(1.12, 0.65, 0.04, 0.006, 4).moved(0, 0.08, 0)
    foot = [bevelled_box(0.4, 0.012, 0.2, 0.004, 4), box(0.08, 0.07, 0.03).moved(0, 0.013, 0)]
    screen = rectangle((-0.54, 0.1, 0.0212), (1.08, 0, 0), (0, 0.61, 0))
    screen.uvs = [((0, 0), (1, 0), (1, 1), (0, 1))]
    room.place("TV", room.mesh_of("TV", [(m["plastic"], joined([case] + foot)),
                                         (m["screen"], screen)]), at=(x - 0.1, y, z - 0.02))
    for k, dx in enumerate((-0.85, 0.62)):
        speaker(room, m, f"Speaker {k}", (x + dx, y, z))
    table_lamp(room, m, (x + 0.86, y, z))


def speaker(room, m, name, at):
    """A loudspeaker with two cones."""
    case = bevelled_box(0.16, 0.28, 0.2, 0.006, 4)
    cones = []
    for radius, y in ((0.058, 0.1), (0.03, 0.21)):
        cone = lathe([(radius, 0.0015), (radius * 1.1, 0.0015), (radius * 1.1, 0.008), (radius, 0.006),
                      (radius * 0.3, 0.0025), (radius * 0.28, 0.006), (0, 0.009)], 32)
        cones.append(cone.turned("x", 90).moved(0, y, 0.1))
    room.place(name, room.mesh_of(name, [(m["oak"], case), (m["plastic"], joined(cones))]), at=at)


def table_lamp(room, m, at, scale=1.0):
    """A lamp with a turned glazed foot and a shade over a bulb."""
    foot = lathe([(0, 0), (0.06, 0)] + smooth_line(
        [(0.062, 0.004), (0.07, 0.06), (0.03, 0.14), (0.012, 0.2)], 8) + [(0.012, 0.24), (0, 0.24)],
        room.steps(36, 16))
    shade = props.lampshade(0.14, 0.09, 0.2, room.steps(48, 16)).moved(0, 0.2, 0)
    room.place("Table lamp", room.mesh_of("Table lamp", [
        (m["glaze"], foot), (m["shade"], shade),
        (m["bulb"], props.bulb(0.028, 24).moved(0, 0.241, 0))]), at=at, scale=scale)


def floor_lamp(room, m, at):
    """A floor lamp: brass foot and pole, open shade, a bulb, and a small point light above it."""
    pole = lathe([(0, 0), (0.15, 0), (0.15, 0.012), (0.14, 0.02), (0.02, 0.03), (0.011, 0.04),
                  (0.011, 1.42), (0, 1.42)], room.steps(36, 16))
    shade = props.lampshade(0.24, 0.17, 0.28, room.steps(64, 16)).moved(0, 1.38, 0)
    ring = tube([(0.169 * math.cos(a), 1.655, 0.169 * math.sin(a)) for a in
                 (2 * math.pi * k / 48 for k in range(48))], 0.003, 8, closed=True)
    room.place("Floor lamp", room.mesh_of("Floor lamp", [
        (m["brass"], joined([pole, ring])), (m["shade"], shade),
        (m["bulb"], props.bulb(0.035, 24).moved(0, 1.421, 0))]), at=at)
    room.point("Floor lamp light", (at[0], at[1] + 1.6, at[2]), 6, (1, 0.72, 0.42), 0.03)


def ceiling_lamp(room, m, at):
    """A ring with seven glass globes, each round a bulb, that hangs from the ceiling."""
    drop = 0.75
    canopy = lathe([(0.0, -0.03), (0.05, -0.03), (0.06, -0.001)], 32)
    wires = [tube([(0.02 * math.cos(a), -0.02, 0.02 * math.sin(a)),
                   (0.34 * math.cos(a), -drop, 0.34 * math.sin(a))], 0.002, 8)
             for a in (2 * math.pi * k / 3 for k in range(3))]
    ring = tube([(0.35 * math.cos(a), -drop, 0.35 * math.sin(a)) for a in
                 (2 * math.pi * k / 72 for k in range(72))], 0.012, 16, closed=True)
    room.place("Ceiling lamp", room.mesh_of("Ceiling lamp", [
        (m["brass"], joined([canopy, ring] + wires))]), at=at)
    segments = room.steps(32, 16)
    rows = segments // 2
    side = [(math.sin(math.pi * k / rows), -math.cos(math.pi * k / rows)) for k in range(1, rows)]
    neck = [p for p in side if p[1] < 0.93]
    shell = lathe([(0, -0.07)] + [(0.07 * r, 0.07 * y) for r, y in neck] +
                  [(0.067 * r, 0.067 * y) for r, y in reversed(neck)] + [(0, -0.067)], segments)
    socket = lathe([(0, -0.02), (0.012, -0.02), (0.018, 0.02), (0.018, 0.056), (0, 0.056)], 24)
    globe = room.mesh_of("Globe", [
        (m["glass"], shell), (m["brass"], socket.moved(0, 0.03, 0)),
        (m["bulb"], ball(0.025, 20).moved(0, -0.02, 0))])
    for k in range(7):
        a = 2 * math.pi * k / 7
        room.place(f"Globe {k}", globe, turn=20.0 * k,
                   at=(at[0] + 0.35 * math.cos(a), at[1] - drop - 0.105, at[2] + 0.35 * math.sin(a)))


def add_plant(room, m, at, draw, leaves=90):
    """A pot with a plant of folded open leaves on bent stems."""
    pot = lathe([(0, 0), (0.13, 0), (0.135, 0.004), (0.17, 0.28), (0.185, 0.285), (0.185, 0.32),
                 (0.165, 0.32), (0.16, 0.25)], room.steps(48, 16))
    soil = sheet(24, 8, lambda u, v: ((0.001 + 0.16 * v) * math.cos(2 * math.pi * u),
                                      0.28 + 0.012 * math.sin(37 * u) * v * (1 - v),
                                      -(0.001 + 0.16 * v) * math.sin(2 * math.pi * u)), wrap=True)
    stems, blades = [], []
    for k in range(leaves):
        turn, reach = 137.5 * k, 0.12 + 0.4 * (k / leaves)
        rise = 0.35 + 1.0 * (1 - k / leaves) + draw.uniform(0, 0.15)
        a = math.radians(turn)
        tip = (reach * math.sin(a), 0.27 + rise, reach * math.cos(a))
        path = smooth_line([(0.04 * math.sin(a), 0.27, 0.04 * math.cos(a)),
                            (0.25 * tip[0], 0.27 + rise * 0.6, 0.25 * tip[2]), tip], 4)
        stems.append(tube(path, 0.0035, 14, caps=False))
        length = draw.uniform(0.2, 0.34)
        blade = props.leaf(length, length * 0.42, length * 0.35, room.steps(8, 4))
        blades.append(blade.turned("x", draw.uniform(-30, 25)).turned("y", turn).moved(*tip))
    room.place("Plant", room.mesh_of("Plant", [
        (m["pot"], pot), (m["soil"], soil), (m["stem"], joined(stems)),
        (m["leaf"], joined(blades))]), at=at)


def add_pictures(room, m):
    """Framed paintings on the back wall and the right wall; each behind a pane of glass."""
    spots = [((-1.75, 1.95, Z0), 0, 0.5, 0.6), ((-1.1, 1.95, Z0), 0, 0.6, 0.6),
             ((-0.35, 1.95, Z0), 0, 0.7, 0.6), ((X, 1.6, 0.3), -90, 0.8, 1.0)]
    for k, (at, turn, wide, high) in enumerate(spots):
        moulding = props.frame(wide, high, 0.04, 0.025)
        canvas = rectangle((-wide / 2 + 0.035, -high / 2 + 0.035, 0.004), (wide - 0.07, 0, 0),
                           (0, high - 0.07, 0))
        canvas.uvs = [((0, 0), (1, 0), (1, 1), (0, 1))]
        pane = box(wide - 0.074, high - 0.074, 0.002).moved(0, -high / 2 + 0.037, 0.008)
        shift = (0.002 if turn == -90 else 0, 0.002 if turn == 0 else 0)
        room.place(f"Picture {k}", room.mesh_of(f"Picture {k}", [
            (m[("walnut", "brass", "black")[k % 3]], moulding), (m[f"painting {k % 3}"], canvas),
            (m["pane"], pane)], 30), at=(at[0] - shift[0], at[1], at[2] + shift[1]), turn=turn)


def add_lights(room, m):
    """Sun, sky, and four spot lights in the ceiling."""
    room.sun("Sun", (0.75, -0.6, -0.12), 8, (1, 0.93, 0.82))
    room.world((0.7, 0.85, 1), 0.9)
    ring = lathe([(0.035, -0.004), (0.05, -0.004), (0.05, -0.001)], 32)
    mesh = room.mesh_of("Spot ring", [(m["chrome"], ring)])
    for k, (x, z, tx, ty, tz) in enumerate(((-1.4, -2.0, -1.4, 1.9, -2.6), (-0.4, -2.0, -0.4, 1.9, -2.6),
                                            (1.4, -1.9, 1.4, 1.0, -2.5), (2.2, 0.3, 3.0, 1.5, 0.3))):
        room.place(f"Spot ring {k}", mesh, at=(x, HEIGHT, z))
        room.spot_at(f"Spot {k}", (x, HEIGHT - 0.01, z), (tx, ty, tz), 40, 0.6, (1, 0.86, 0.68), 0.02)


def build(room):
    draw = random.Random(1)
    m = add_materials(room)
    add_shell(room, m, draw)
    add_sofa(room, m, "Sofa", m["sofa"], 3, (-2.3, 0.001, -0.7), 90, draw)
    add_sofa(room, m, "Armchair", m["rust"], 1, (1.05, 0.001, -0.55), -110, draw)
    add_rug(room, m, (-0.65, 0.001, -0.65), (2.5, 1.9))
    table = (-0.85, 0.015, -0.65)
    top = add_table(room, m, table)
    add_tableware(room, m, (table[0], table[1] + top, table[2]))
    add_bookshelf(room, m, (1.5, 0.001, Z0 + 0.18), draw)
    add_sideboard(room, m, (-1.0, 0.001, Z0 + 0.26))
    floor_lamp(room, m, (-2.6, 0.001, -2.25))
    floor_lamp(room, m, (2.4, 0.001, -0.6))
    ceiling_lamp(room, m, (-0.65, HEIGHT, -0.65))
    add_plant(room, m, (2.55, 0.001, 0.6), draw)
    add_plant(room, m, (-2.55, 0.001, 0.95), draw, 60)
    add_pictures(room, m)
    add_lights(room, m)
    room.camera((1.9, 1.55, 2.7), (-0.75, 0.75, -1.2), 0.82)


if __name__ == "__main__":
    run(build)
