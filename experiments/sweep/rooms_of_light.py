"""Rooms with nasty lights, sizes and albedos; adds them to rooms.ROOMS."""

import math

from room import GREY, LIGHT, RADIANCE, WALLS, Room, quad, triangles_of, turned
from rooms import family, nasty

REFUSED = ("lit", "refused")


def light_of(watts):
    """Of the common light's area, 1 m2."""
    return Room(light=watts / math.pi, expect=REFUSED if not 1e-37 < watts < 1e30 else ("lit",))


family("light_of_watts", light_of, (1e-45, 1e-30, 1e38), "a light of W")


def size_of(metres):
    return Room(scale=metres / 2, expect=REFUSED if not 1e-9 < metres < 1e9 else ("lit",))


family("room_of_metres", size_of, (1e-20, 1e-12, 1e-3, 1e6, 1e12), "a room of metres")




def albedo_of(value):
    return Room(albedo=(value,) * 3, light=RADIANCE if value < 0.9 else 0.1)


family("albedo_of", albedo_of, (0, 0.999, 1), "walls of albedo")


@nasty
def light_on_wall():
    """a light exactly in the plane of the ceiling"""
    room = Room(light=None)
    room.add("Light", room.glowing(5), triangles_of(quad((-0.5, 2, -0.5), (1, 0, 0), (0, 0, 1))))
    return room


@nasty
def light_before_wall():
    """the same, the light's faces before the ceiling's in the file"""
    room = Room(without=("ceiling",), light=None)
    room.add("Light", room.glowing(5), triangles_of(quad((-0.5, 2, -0.5), (1, 0, 0), (0, 0, 1))))
    room.add("Ceiling", room.grey, triangles_of(quad(*WALLS["ceiling"])))
    return room


@nasty
def light_in_wall():
    """a light box sunk half into the ceiling"""
    room = Room(light=None)
    room.add_box(room.glowing(3), (-0.4, 1.9, -0.4), (0.4, 2.1, 0.4), "Light")
    return room


@nasty
def light_facing_wall():
    """a light 2 cm below the ceiling that faces it"""
    room = Room(light=None)
    room.add("Light", room.glowing(50),
             turned(triangles_of(quad((-0.5, 1.98, -0.5), (1, 0, 0), (0, 0, 1)))))
    return room


@nasty
def light_touching_box():
    """a light on which a diffuse box stands"""
    room = Room(light=None)
    room.add("Light", room.glowing(5), turned(triangles_of(quad((-0.6, 0.5, -0.7), (1.2, 0, 0),
                                                                (0, 0, 1)))))
    room.add_box(room.grey, (-0.3, 0.5, -0.5), (0.3, 1, 0))
    return room


@nasty
def tiny_light():
    """a light of one triangle, 0.1 mm wide"""
    room = Room(light=None)
    room.add("Light", room.glowing(1e8), [((0, 1.9, 0), (1e-4, 1.9, 0), (0, 1.9, 1e-4))])
    return room


@nasty
def light_of_slivers():
    """a light of 500 strips, 1 m long and 0.1 mm wide, with gaps as wide"""
    room = Room(light=None)
    strips = []
    for i in range(500):
        strips += triangles_of(quad((-0.5, 1.9, -0.5 + 0.0002 * i), (1, 0, 0), (0, 0, 0.0001)))
    room.add("Light", room.glowing(50), strips)
    return room


@nasty
def huge_lights():
    """all walls but the floor emit, and reflect too"""
    room = Room(without=[name for name in WALLS if name != "floor"], light=None)
    glow = room.material("Wall", GREY, emissiveFactor=[1, 1, 1])
    for name, corners in WALLS.items():
        if name != "floor":
            room.add(name, glow, triangles_of(quad(*corners)))
    return room


@nasty
def light_behind_hole():
    """a light in a chamber behind a wall with one hole, 10 cm wide"""
    room = Room(light=None)
    low, high, y = -0.05, 0.05, 1.6
    wall = []
    for x0, x1, z0, z1 in ((-1, low, -1, 1), (high, 1, -1, 1), (low, high, -1, low),
                           (low, high, high, 1)):
        wall += triangles_of(quad((x0, y, z0), (x1 - x0, 0, 0), (0, 0, z1 - z0)))
    room.add("Lid", room.grey, wall)
    room.add("Light", room.glowing(500), triangles_of(quad(*LIGHT)))
    return room


@nasty
def light_of_two_sides():
    """a light that emits to both sides, standing on the floor"""
    room = Room(light=None)
    room.add("Light", room.glowing(5, doubleSided=True),
             triangles_of(quad((-0.5, 0, -0.3), (1, 0, 0), (0, 0.8, 0))))
    return room


@nasty
def unlit():
    """a light that no light leaves: it faces the ceiling it lies on"""
    room = Room(light=None)
    room.expect = ("black",)
    room.add("Light", room.glowing(5),
             turned(triangles_of(quad((-0.5, 2, -0.5), (1, 0, 0), (0, 0, 1)))))
    return room


@nasty
def light_outside():
    """a light outside of the closed room"""
    room = Room(light=None)
    room.expect = ("black",)
    room.add("Light", room.glowing(5), triangles_of(quad((-0.5, 3, -0.5), (1, 0, 0), (0, 0, 1))))
    return room
