"""Some fifty rooms with one nasty thing each: {name: function that builds it}.

A function takes nothing and returns a Room; its docstring says what is nasty.
"""

import math
import random

from room import WALLS, Room, box, circle, fan, grid, line, quad, sphere, triangles_of, turned

ROOMS = {}  # {name: function}
FLOOR = WALLS["floor"]


def nasty(function):
    ROOMS[function.__name__] = function
    return function


def family(name, builder, values, doc):
    """A room for each value: name_value."""
    for value in values:
        def build(value=value):
            return builder(value)
        build.__doc__ = f"{doc} {value:g}"
        ROOMS[f"{name}_{value:g}"] = build


@nasty
def plain():
    """nothing: the room that all others are built on"""
    return Room()


# Faces that coincide

@nasty
def coincident_faces():
    """the floor twice, in the same place"""
    room = Room()
    room.add("Again", room.grey, triangles_of(quad(*FLOOR)))
    return room


@nasty
def coincident_turned():
    """the floor twice, the second one facing down"""
    room = Room()
    room.add("Again", room.grey, turned(triangles_of(quad(*FLOOR))))
    return room


@nasty
def coincident_cut_otherwise():
    """a second floor cut along the other diagonal and into a grid"""
    room = Room()
    room.add("Again", room.grey, grid(*FLOOR, 3, 7))
    return room


@nasty
def poster_on_wall():
    """a dark quad in the plane of the back wall"""
    room = Room()
    dark = room.material("Dark", (0.1, 0.1, 0.3))
    room.add("Poster", dark, triangles_of(quad((-0.63, 0.31, -1), (1.1, 0, 0), (0, 0.97, 0))))
    return room


@nasty
def box_of_doubled_faces():
    """a box whose faces are all there twice, wound both ways"""
    room = Room()
    faces = triangles_of(box((-0.5, 0, -0.6), (0.3, 0.9, 0.1)))
    room.add("Box", room.grey, faces + turned(faces))
    return room


@nasty
def boxes_in_one_place():
    """two equal diffuse boxes in the same place, of different colours"""
    room = Room()
    dark = room.material("Dark", (0.1, 0.1, 0.3))
    room.add_box(room.grey, (-0.5, 0, -0.6), (0.3, 0.9, 0.1))
    room.add_box(dark, (-0.5, 0, -0.6), (0.3, 0.9, 0.1))
    return room


# Slivers

@nasty
def fan_of_slivers():
    """a floor of 600 slivers that share one corner"""
    room = Room(without=("floor",))
    outline = line((1, 0, 1), (1, 0, -1), 300) + line((1, 0, -1), (-1, 0, -1), 300)[1:]
    room.add("Floor", room.grey, fan((-1, 0, 1), outline))
    return room


@nasty
def fan_of_slivers_far_vertex():
    """a floor of 600 slivers that share a vertex 60 m away"""
    room = Room(without=("floor",))
    room.add("Floor", room.grey, fan((60, 0, 0), line((-1, 0, -1.1), (-1, 0, 1.1), 600)))
    return room


@nasty
def curtain_of_slivers_very_far_vertex():
    """a curtain of 600 slivers that hangs from a vertex 10 km above the room"""
    room = Room()
    hem = line((-0.9, 0.1, -0.3), (0.9, 0.1, -0.3), 600)
    room.add("Curtain", room.grey, fan((0, 1e4, -0.3), hem))
    return room


@nasty
def room_in_a_city():
    """one triangle 10 km away, so that the room's coordinates are rounded to 0.5 mm"""
    room = Room()
    room.add("Tower", room.grey, [((0, 1e4, -30), (-1, 9990, -30), (1, 9990, -30))])
    return room


@nasty
def pleated_fan():
    """600 slivers that share a vertex, folded into pleats 10 cm deep and 2 mm wide"""
    return pleats(0.9, 0.1)


@nasty
def pleated_fan_far_vertex():
    """the same, 1 cm deep, the vertex 60 m away"""
    return pleats(60, 0.01)


def pleats(far, depth):
    room = Room()
    base = [(x, y + depth * (i % 2), z)
            for i, (x, y, z) in enumerate(line((-0.9, 0.4, -0.8), (-0.9, 0.4, 0.3), 600))]
    room.add("Fan", room.grey, fan((far, 0.4, -0.3), base))
    return room


@nasty
def upright_fan_far_vertex():
    """600 upright slivers that share a vertex 60 m away, and cut through the wall before it"""
    room = Room()
    room.add("Fan", room.grey, fan((60, 0.4, -0.3), line((-0.9, 0.3, -0.8), (-0.9, 0.9, 0.3), 600)))
    return room


@nasty
def disc_of_slivers():
    """a disc of 2000 slivers around its middle, on legs of air"""
    room = Room()
    room.add("Disc", room.grey, fan((0, 0.5, -0.2), circle((0, 0.5, -0.2), 0.7, 2000)))
    return room


@nasty
def cone_of_slivers():
    """a cone of 600 slivers that share the tip"""
    room = Room()
    room.add("Cone", room.grey, fan((0, 1.2, -0.2), circle((0, 0, -0.2), 0.7, 600)))
    return room


@nasty
def needle_floor():
    """a floor of 2000 strips, 1 mm wide and 2 m long, in two triangles each"""
    room = Room(without=("floor",))
    room.add("Floor", room.grey, grid(*FLOOR, 1, 2000))
    return room


@nasty
def floating_strips():
    """200 strips in the air, 1.8 m long and 2 mm wide"""
    room = Room()
    strips = []
    for i in range(200):
        at = (-0.9, 0.3 + 0.005 * (i % 20), -0.9 + 0.008 * i)
        strips += triangles_of(quad(at, (1.8, 0, 0), (0, 0.001, -0.0018)))
    room.add("Strips", room.grey, strips)
    return room


@nasty
def t_junctions():
    """a floor of four rectangles, cut into grids that do not meet"""
    room = Room(without=("floor",))
    for i, (x, z, n) in enumerate(((-1, 1, 3), (0.1, 1, 5), (-1, 0.3, 7), (0.1, 0.3, 11))):
        wide, deep = (1.1 if x < 0 else 0.9), (0.7 if z == 1 else 1.3)
        room.add(f"Part{i}", room.grey, grid((x, 0, z), (wide, 0, 0), (0, 0, -deep), n, n + 2))
    return room


@nasty
def faces_without_area():
    """500 triangles whose corners are one point or lie on one line, on floor and edges"""
    room = Room()
    source = random.Random(1)
    flat = []
    for _ in range(250):
        x, z = source.uniform(-1, 1), source.uniform(-1, 1)
        flat += [((x, 0, z),) * 3, ((x, 0, z), (x + 0.25, 0, z), (x + 0.5, 0, z))]
    room.add("Flat", room.grey, flat)
    return room


@nasty
def faces_hardly_there():
    """a floor cut along its middle, the cut filled by faces 1e-7 m wide"""
    room = Room(without=("floor",))
    thin = 1e-7
    room.add("Floor", room.grey, grid((-1, 0, 1), (2, 0, 0), (0, 0, -1), 20, 1) +
             grid((-1, 0, 0), (2, 0, 0), (0, 0, -thin), 20, 1) +
             grid((-1, 0, -thin), (2, 0, 0), (0, 0, thin - 1), 20, 1))
    return room


@nasty
def wall_of_steps():
    """a floor of 300 steps, 1 mm high"""
    room = Room(without=("floor",))
    steps = []
    for i in range(300):
        z, deep, y = 1 - i / 150, 1 / 150, 0.001 * (i % 2)
        steps += triangles_of(quad((-1, y, z), (2, 0, 0), (0, 0, -deep)))
        rise = 0.001 - 2 * y
        steps += triangles_of(quad((-1, y, z - deep), (2, 0, 0), (0, rise, 0)))
    room.add("Floor", room.grey, steps)
    return room


@nasty
def wrinkled_floor():
    """a floor whose 5000 vertices are off by up to 1e-5 m"""
    room = Room(without=("floor",))
    source = random.Random(3)
    moved = {}
    faces = []
    for corners in grid(*FLOOR, 70, 70):
        faces.append(tuple(moved.setdefault(c, (c[0], c[1] + source.uniform(-1e-5, 1e-5), c[2]))
                           for c in corners))
    room.add("Floor", room.grey, faces)
    return room


# Meshes that are no surfaces

@nasty
def fins():
    """five sheets that stand on the floor and share one edge"""
    room = Room()
    sheets = []
    for i in range(5):
        turn = math.pi * i / 4
        out = (0.7 * math.cos(turn), 0.0, -0.7 * math.sin(turn))
        sheets += triangles_of(quad((0, 0, -0.1), out, (0, 0.9, 0)))
    room.add("Fins", room.grey, sheets)
    return room


@nasty
def crossing_sheets():
    """ten sheets that cut through each other and the floor without a common vertex"""
    room = Room()
    source = random.Random(5)
    sheets = []
    for _ in range(10):
        x, z, turn = source.uniform(-0.5, 0.5), source.uniform(-0.7, 0.3), source.uniform(0, 6.28)
        along = (math.cos(turn), 0.1, math.sin(turn))
        sheets += triangles_of(quad((x - along[0] / 2, -0.1, z - along[2] / 2), along,
                                    (0.1, 0.8, 0.05)))
    room.add("Sheets", room.grey, sheets)
    return room


@nasty
def wedge():
    """two sheets that meet at one degree, open towards the light"""
    room = Room()
    angle = math.radians(0.5)
    up = (1.2 * math.sin(angle), 1.2 * math.cos(angle), 0)
    sheets = triangles_of(quad((0.2, 0.2, 0.3), (0, 0, -0.9), up))
    sheets += triangles_of(quad((0.2, 0.2, -0.6), (0, 0, 0.9), (-up[0], up[1], 0)))
    room.add("Wedge", room.grey, sheets)
    return room


@nasty
def acute_room():
    """a floor and a slope over it that meet at one degree"""
    room = Room()
    slope = (0, 1.9 * math.sin(math.radians(1)), -1.9 * math.cos(math.radians(1)))
    room.add("Slope", room.grey, triangles_of(quad((-0.9, 0, 0.95), (1.8, 0, 0), slope)))
    return room


@nasty
def tiny_objects():
    """10,000 tetrahedra, 4 mm wide, strewn through the room"""
    room = Room()
    source = random.Random(2)
    faces = []
    for _ in range(10_000):
        c = (source.uniform(-0.9, 0.9), source.uniform(0.1, 1.5), source.uniform(-0.9, 0.3))
        p = [tuple(x + source.uniform(-0.002, 0.002) for x in c) for _ in range(4)]
        faces += [(p[a], p[b], p[d]) for a, b, d in ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0))]
    room.add("Dust", room.grey, faces)
    return room


@nasty
def small_curved_things():
    """40 balls, 3 cm wide, which few photons meet"""
    room = Room()
    source = random.Random(4)
    for _ in range(40):
        centre = (source.uniform(-0.8, 0.8), source.uniform(0.2, 1.4), source.uniform(-0.8, 0.3))
        room.add_ball(room.grey, centre, 0.015, 12, 6)
    return room


@nasty
def hill():
    """a floor that is one large cap of a sphere in 4000 faces"""
    room = Room()
    cap = [corners for corners in triangles_of(sphere((0, -1.2, -0.2), 2, 96, 48))
           if all(c[1] > -0.1 for c in corners)]
    room.add("Hill", room.grey, cap)
    return room
