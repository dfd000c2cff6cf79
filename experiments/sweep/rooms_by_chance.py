"""Random rooms: a number seeds the choice of objects, materials, lights and media."""

import math
import random

from room import LIGHT, RADIANCE, WALLS, Room, box, quad, sphere, triangles_of, turned


def color(draw, low=0.05, high=0.95):
    return tuple(draw.uniform(low, high) for _ in range(3))


def skewed(draw):
    """A number from 0 to 1, which is 0 or 1 with a probability of a quarter each."""
    return draw.choice((0, 1, draw.random(), draw.random() ** 3))


# Materials

def matte(room, draw):
    return room.material("Matte", color(draw, 0, 1))


def plastic(room, draw):
    return room.material("Plastic", color(draw), base={"roughnessFactor": skewed(draw)},
                         extensions={"KHR_materials_ior": {"ior": draw.uniform(1, 2.5)},
                                     "KHR_materials_specular": {"specularFactor": draw.random(),
                                                                "specularColorFactor": color(draw)}})


def metal(room, draw):
    extensions = {}
    if draw.random() < 0.3:
        extensions["KHR_materials_anisotropy"] = {"anisotropyStrength": draw.random(),
                                                  "anisotropyRotation": draw.uniform(0, 7)}
    return room.material("Metal", color(draw, 0.3, 1), extensions=extensions,
                         base={"metallicFactor": 1, "roughnessFactor": skewed(draw)})


def half_metal(room, draw):
    return room.material("Half metal", color(draw),
                         base={"metallicFactor": draw.random(), "roughnessFactor": skewed(draw)},
                         extensions={"KHR_materials_ior": {"ior": 1.5}})


def glass(room, draw):
    extensions = {"KHR_materials_transmission": {"transmissionFactor": draw.choice((1, 1, draw.random()))},
                  "KHR_materials_ior": {"ior": draw.choice((1.0, 1.33, 1.5, draw.uniform(1.001, 3)))}}
    if draw.random() < 0.3:
        extensions["KHR_materials_volume"] = {"attenuationColor": list(color(draw)), "thicknessFactor": 1,
                                              "attenuationDistance": draw.uniform(0.05, 2)}
    if draw.random() < 0.2:
        extensions["KHR_materials_dispersion"] = {"dispersion": draw.uniform(0, 2)}
    return room.material("Glass", color(draw, 0.6, 1), extensions=extensions,
                         base={"roughnessFactor": draw.choice((0, 0, skewed(draw)))})


def coated(room, draw):
    return room.material("Coated", color(draw), base={"metallicFactor": draw.choice((0, 1)),
                                                      "roughnessFactor": skewed(draw)},
                         extensions={"KHR_materials_clearcoat": {"clearcoatFactor": draw.random(),
                                                                 "clearcoatRoughnessFactor": skewed(draw)}})


def velvet(room, draw):
    return room.material("Velvet", color(draw), extensions={
        "KHR_materials_sheen": {"sheenColorFactor": list(color(draw)),
                                "sheenRoughnessFactor": skewed(draw)}})


def leaf(room, draw):
    return room.material("Leaf", color(draw), extensions={"KHR_materials_diffuse_transmission": {
        "diffuseTransmissionFactor": draw.random(), "diffuseTransmissionColorFactor": list(color(draw))}})


def see_through(room, draw):
    return room.material("See-through", color(draw), alphaMode="BLEND",
                         base={"baseColorFactor": [*color(draw), draw.random()],
                               "metallicFactor": draw.choice((0, 0, 1)), "roughnessFactor": skewed(draw)})


def emissive(room, draw):
    return room.glowing(draw.uniform(0.1, 3), doubleSided=draw.random() < 0.5)


def fog(room, draw):
    thick = draw.uniform(0.1, 4)
    return room.material("Fog", (1, 1, 1), extras={"hipmap": {"boundary": False, "medium": {
        "scattering": [thick * x for x in color(draw)], "absorption": [draw.random()] * 3,
        "phase": "henyey-greenstein", "g": draw.uniform(-0.8, 0.8)}}})


MATERIALS = (matte, plastic, metal, half_metal, glass, glass, glass, coated, velvet, leaf, see_through, emissive)


# Shapes

def place(draw):
    return (draw.uniform(-0.7, 0.7), draw.uniform(0.2, 1.4), draw.uniform(-0.8, 0.4))


def some_box(draw):
    centre, half = place(draw), [draw.uniform(0.02, 0.4) for _ in range(3)]
    return triangles_of(box([c - h for c, h in zip(centre, half)], [c + h for c, h in zip(centre, half)]))


def box_on_floor(draw):
    x, z = draw.uniform(-0.8, 0.5), draw.uniform(-0.9, 0.2)
    return triangles_of(box((x, 0, z), (x + draw.uniform(0.1, 0.6), draw.uniform(0.05, 0.9),
                                        z + draw.uniform(0.1, 0.6))))


def ball(draw):
    return triangles_of(sphere(place(draw), draw.uniform(0.05, 0.4), 20, 10))


def sheet(draw):
    turn, tilt = draw.uniform(0, 2 * math.pi), draw.uniform(0, math.pi)
    right = (math.cos(turn), 0, math.sin(turn))
    up = (-math.sin(turn) * math.cos(tilt), math.sin(tilt), math.cos(turn) * math.cos(tilt))
    wide, high = draw.uniform(0.1, 1), draw.uniform(0.1, 1)
    middle = place(draw)
    corner = tuple(m - wide / 2 * r - high / 2 * u for m, r, u in zip(middle, right, up))
    return triangles_of(quad(corner, tuple(wide * r for r in right), tuple(high * u for u in up)))


def shell(draw):
    """Two balls about one centre, the inner one turned inside out."""
    centre, radius = place(draw), draw.uniform(0.1, 0.4)
    return (triangles_of(sphere(centre, radius, 20, 10)) +
            turned(triangles_of(sphere(centre, draw.uniform(0.3, 0.95) * radius, 20, 10))))


SHAPES = (some_box, box_on_floor, ball, ball, sheet, shell)


# Lights

def add_light(room, draw):
    """Adds a light that has a size: path tracing cannot find one without a size in mirrors or through glass."""
    lamp = {"type": draw.choice(("point", "point", "spot", "directional")), "color": list(color(draw)),
            "intensity": draw.uniform(0.2, 3)}
    size = {"angle_deg": draw.uniform(1, 10)} if lamp["type"] == "directional" else {"radius": draw.uniform(0.01, 0.1)}
    lamp["extras"] = {"hipmap": size}
    if lamp["type"] == "spot":
        outer = draw.uniform(0.2, 1.5)
        lamp["spot"] = {"innerConeAngle": draw.random() * outer, "outerConeAngle": outer}
    lamps = room.root.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"]
    lamps.append(lamp)
    used = room.root.setdefault("extensionsUsed", [])
    if "KHR_lights_punctual" not in used:
        used.append("KHR_lights_punctual")
    # Along -z: down, turned a little.
    half = -math.pi / 4 + draw.uniform(-0.4, 0.4)
    room.node("Lamp", translation=[draw.uniform(-0.8, 0.8), draw.uniform(1.4, 1.85), draw.uniform(-0.8, 0.6)],
              rotation=[math.sin(half), 0, 0, math.cos(half)],
              extensions={"KHR_lights_punctual": {"light": len(lamps) - 1}})


def room_by_chance(number):
    """A room of two to five objects; some have analytic lights, open walls or fog.  Depends on the number alone."""
    draw = random.Random(f"room {number}")
    without = draw.sample(sorted(set(WALLS) - {"floor"}), draw.choice((0, 0, 0, 1, 2)))
    room = Room(without=without, light=None, albedo=color(draw, 0.2, 0.85), expect=("lit", "black"))
    has_area_light = draw.random() < 0.7
    if has_area_light:
        room.add("Light", room.glowing(RADIANCE), triangles_of(quad(*LIGHT)))
    for _ in range(draw.choice((0, 0, 1, 2)) or (0 if has_area_light else 1)):
        add_light(room, draw)
    for _ in range(draw.randint(2, 5)):
        material = draw.choice(MATERIALS)
        shape = draw.choice(SHAPES)
        room.add(f"{shape.__name__} of {material.__name__}", material(room, draw), shape(draw))
    if draw.random() < 0.15:
        room.add("Fog", fog(room, draw), some_box(draw))
    return room


def by_chance(numbers):
    """{name: function that builds it}"""
    def build_of(number):
        def build():
            return room_by_chance(number)
        names = [node["name"] for node in room_by_chance(number).root["nodes"]]
        build.__doc__ = ", ".join(name for name in names if name not in (*WALLS, "Light"))
        return build
    return {f"chance_{number}": build_of(number) for number in numbers}
