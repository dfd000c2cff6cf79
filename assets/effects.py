"""Builds the smallest scenes that show an effect each (docs/effects.md), by Python alone.

    python3 assets/effects.py FOLDER

Metres; glTF's axes (y up).  Each is a stage of floor, wall, lamp and camera with something on it.
"""

import math
import os
import sys

import effect_insides
import smoke_density
from glb_writer import Glb, byte, png, quad, sphere

WHITE = (0.74, 0.74, 0.72)


def stage(radiance=20):
    glb = Glb()
    white = glb.material("White", WHITE)
    glb.mesh("Floor", white, quad((-1.5, 0, 1.5), (3, 0, 0), (0, 0, -3)))
    glb.mesh("Wall", white, quad((-1.5, 0, -1), (3, 0, 0), (0, 2.5, 0)))
    if radiance > 0:
        lamp = glb.material(
            "Lamp", (0, 0, 0), emissiveFactor=[1, 1, 1],
            extensions={"KHR_materials_emissive_strength": {"emissiveStrength": radiance}})
        glb.mesh("Lamp", lamp, quad((-0.9, 2, 0.6), (0.5, 0, 0), (0, 0, 0.5)))
    glb.root["cameras"] = [{"type": "perspective", "name": "Camera", "perspective": {
        "yfov": 0.68, "aspectRatio": 1, "znear": 0.01}}]
    tilt = math.radians(-9)
    glb.node("Camera", camera=0, translation=[0, 0.95, 3],
             rotation=[math.sin(tilt / 2), 0, 0, math.cos(tilt / 2)])
    return glb


def add_alpha(glb):
    """A lattice with holes, and a red pane that lets half of the light pass."""
    def lattice(x, y):
        bar = x % 16 < 5 or y % 16 < 5
        return (200, 160, 90, 255 if bar else 0)

    picture = glb.texture(png(64, 64, lattice))
    lattice = glb.material("Lattice", (1, 1, 1), alphaMode="MASK", doubleSided=True,
                           base={"baseColorTexture": picture})
    pane = glb.material("Pane", (0.8, 0.1, 0.08), alphaMode="BLEND", doubleSided=True,
                        base={"baseColorFactor": [0.8, 0.1, 0.08, 0.5]})
    glb.mesh("Lattice", lattice, quad((-0.75, 0.02, 0.2), (0.7, 0, 0), (0, 0.9, 0)))
    glb.mesh("Pane", pane, quad((0.1, 0.02, 0.2), (0.6, 0, -0.3), (0, 0.9, 0)))


def domes(glb):
    """A normal map of them."""
    def dome(x, y):
        u, v = ((x + 0.5) % 16) / 8 - 1, ((y + 0.5) % 16) / 8 - 1
        inside = u * u + v * v < 0.8
        nx, ny = (0.8 * u, -0.8 * v) if inside else (0, 0)
        nz = math.sqrt(1 - nx * nx - ny * ny)
        return (byte((nx + 1) / 2), byte((ny + 1) / 2), byte((nz + 1) / 2), 255)

    return glb.texture(png(64, 64, dome))


def add_normal_maps(glb):
    """Domes on a panel and on a ball."""
    picture = domes(glb)
    bumpy = glb.material("Bumpy", (0.7, 0.6, 0.45), normalTexture=picture)
    glb.mesh("Panel", bumpy, quad((-0.85, 0.02, -0.1), (0.8, 0, -0.2), (0, 0.9, 0)))
    shiny = glb.material("Shiny bumps", (0.9, 0.75, 0.4), normalTexture=picture,
                         base={"metallicFactor": 1, "roughnessFactor": 0.25})
    glb.mesh("Ball", shiny, sphere((0.5, 0.4, 0.1), 0.38))


def add_vertex_colours(glb):
    plain = glb.material("Plain", (0.9, 0.9, 0.9))
    panel = quad((-0.85, 0.02, -0.1), (0.8, 0, -0.2), (0, 0.9, 0))
    glb.mesh("Panel", plain, panel,
             COLOR_0=[(1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1), (1, 1, 0, 1)])
    ball = sphere((0.5, 0.4, 0.1), 0.38)
    glb.mesh("Ball", plain, ball,
             COLOR_0=[tuple(0.5 + 0.5 * c for c in n) + (1,) for n in ball[1]])


def add_reflection_models(glb):
    """Phong's model, wide and narrow, and Schlick's, with grooves on the last ball."""
    for i, (name, color, roughness, own) in enumerate((
            ("Phong 8", (0.75, 0.3, 0.15), 0.5,
             {"reflection": "phong", "exponent": 8, "specular": [0.3, 0.3, 0.3]}),
            ("Phong 200", (0.15, 0.35, 0.75), 0.22,
             {"reflection": "phong", "exponent": 200, "specular": [0.3, 0.3, 0.3]}),
            ("Schlick 0.15", (0.9, 0.65, 0.3), 0.15, {"reflection": "schlick"}),
            ("Schlick 0.5", (0.8, 0.8, 0.82), 0.5, {"reflection": "schlick", "isotropy": 0.1}))):
        material = glb.material(name, color, base={"roughnessFactor": roughness},
                                extensions={"KHR_materials_ior": {"ior": 1.5}},
                                extras={"hipmap": own})
        glb.mesh(f"Ball {i}", material, sphere((0.46 * i - 0.69, 0.22, 0.3), 0.22, 40, 20))


def add_ward_lafortune(glb):
    """Ward's model, even and brushed, and Lafortune's, leaning and back to the light."""
    def lafortune(exponent, coefficients):
        return {"reflection": "lafortune", "exponent": exponent, "coefficients": coefficients}

    def ward(along, across):
        return {"reflection": "ward", "slopes": [along, across]}

    for i, (name, color, own) in enumerate((
            ("Ward even", (0.75, 0.3, 0.15), ward(0.15, 0.15)),
            ("Ward brushed", (0.3, 0.3, 0.32), ward(0.5, 0.07)),
            ("Lafortune leaning", (0.15, 0.35, 0.75), lafortune(40, [-1, -1, 0.95])),
            ("Lafortune back", (0.15, 0.5, 0.25), lafortune(4, [1, 1, 1])))):
        material = glb.material(name, color, base={"roughnessFactor": 0.5},
                                extras={"hipmap": {**own, "specular": [0.5, 0.5, 0.5]}})
        glb.mesh(f"Ball {i}", material, sphere((0.46 * i - 0.69, 0.22, 0.3), 0.22, 40, 20))


def add_rough_metal(glb):
    """White metal of more and more roughness."""
    for i, roughness in enumerate((0.1, 0.4, 0.7, 1)):
        metal = glb.material(f"Metal {roughness}", (1, 1, 1), base={
            "metallicFactor": 1, "roughnessFactor": roughness})
        glb.mesh(f"Ball {i}", metal, sphere((0.46 * i - 0.69, 0.22, 0.3), 0.22, 40, 20))


def add_emissive_picture(glb):
    """A sign of four colours is the only light."""
    def sign(x, y):
        if (x % 8 < 2) or (y % 8 < 2):
            return (0, 0, 0, 255)
        return ((255, 60, 30, 255), (40, 255, 80, 255), (50, 90, 255, 255),
                (255, 230, 120, 255))[(x // 8 + y // 8) % 4]

    picture = glb.texture(png(32, 16, sign), magFilter=9728)
    glowing = glb.material(
        "Sign", (0.02, 0.02, 0.02), emissiveFactor=[1, 1, 1], emissiveTexture=picture,
        extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 6}})
    glb.mesh("Sign", glowing, quad((-0.8, 0.15, -0.5), (1.6, 0, 0), (0, 0.8, 0)))
    glb.mesh("Ball", 0, sphere((0.1, 0.2, 0.2), 0.2))


def add_clearcoat(glb):
    """The same rough red metal, bare and with a smooth clear coat."""
    paint = {"metallicFactor": 1, "roughnessFactor": 0.5}
    bare = glb.material("Bare paint", (0.6, 0.06, 0.05), base=paint)
    coated = glb.material("Coated paint", (0.6, 0.06, 0.05), base=paint, extensions={
        "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0}})
    glb.mesh("Bare ball", bare, sphere((-0.45, 0.38, 0), 0.38, 40, 20))
    glb.mesh("Coated ball", coated, sphere((0.45, 0.38, 0), 0.38, 40, 20))


def add_clearcoat_normal(glb):
    """A clear coat with domes over even paint, and an even one over paint with domes."""
    picture = domes(glb)
    paint = {"metallicFactor": 1, "roughnessFactor": 0.5}
    for name, x, below, coat in (
            ("Coat with domes", -0.45, {}, {"clearcoatNormalTexture": picture}),
            ("Paint with domes", 0.45, {"normalTexture": picture}, {})):
        lacquer = glb.material(name, (0.6, 0.06, 0.05), base=paint, extensions={
            "KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0,
                                        **coat}}, **below)
        glb.mesh(name, lacquer, sphere((x, 0.38, 0), 0.38, 40, 20))


def add_anisotropy(glb):
    """Brushed metal, round a ball and down another, and a disc that was turned."""
    for name, x, turn in (("Round", -0.65, 0), ("Down", 0.65, math.pi / 2)):
        brushed = glb.material(name, (0.9, 0.6, 0.35),
                               base={"metallicFactor": 1, "roughnessFactor": 0.25},
                               extensions={"KHR_materials_anisotropy": {
                                   "anisotropyStrength": 0.9, "anisotropyRotation": turn}})
        ball = sphere((x, 0.34, 0.1), 0.34, 40, 20)
        round_it = [(math.cos(2 * math.pi * u), 0, -math.sin(2 * math.pi * u), 1)
                    for u, _ in ball[2]]
        glb.mesh(name, brushed, ball, TANGENT=round_it)
    turned = glb.material("Turned", (0.8, 0.8, 0.82),
                          base={"metallicFactor": 1, "roughnessFactor": 0.2},
                          extensions={"KHR_materials_anisotropy": {"anisotropyStrength": 0.9}})
    rim = [2 * math.pi * i / 64 for i in range(64)]
    slope = (0, math.cos(0.3), math.sin(0.3))  # leans back
    points, normals, uvs, tangents, faces = [], [], [], [], []
    for angle, after in zip(rim, rim[1:] + rim[:1]):
        for a, r in ((angle, 0.02), (after, 0.02), (after, 0.34), (angle, 0.34)):
            points.append((r * math.cos(a), 0.36 + r * math.sin(a) * slope[1],
                           -0.3 - r * math.sin(a) * slope[2]))
            normals.append((0, slope[2], slope[1]))
            tangents.append((-math.sin(a), math.cos(a) * slope[1], -math.cos(a) * slope[2], 1))
            uvs.append((r, a))
        first = len(points) - 4
        faces += [(first, first + 3, first + 2), (first, first + 2, first + 1)]
    glb.mesh("Disc", turned, (points, normals, uvs, faces), TANGENT=tangents)


def add_diffuse_transmission(glb):
    """A lantern of paper, and a leaf between the lamp and who looks."""
    def paper(name, color, factor, **parts):
        return glb.material(name, color, doubleSided=True, extensions={
            "KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": factor, **parts}})

    def veins(x, y):
        vein = abs(x - 16) < 1 or (y + abs(x - 16)) % 8 < 1
        return (200, 210, 120, 255) if vein else (90, 190, 40, 255)

    shade = paper("Paper", (0.8, 0.75, 0.65), 0.6, diffuseTransmissionColorFactor=[1, 0.85, 0.6])
    glb.mesh("Lantern", shade, sphere((-0.5, 0.42, -0.1), 0.34, 40, 20))
    bulb = glb.material("Bulb", (0, 0, 0), emissiveFactor=[1, 0.9, 0.75], extensions={
        "KHR_materials_emissive_strength": {"emissiveStrength": 60}})
    glb.mesh("Bulb", bulb, sphere((-0.5, 0.42, -0.1), 0.07, 16, 8))
    leaf = paper("Leaf", (0.1, 0.25, 0.05), 0.5,
                 diffuseTransmissionColorTexture=glb.texture(png(32, 32, veins)))
    glb.mesh("Leaf", leaf, quad((0.05, 0.25, 0.35), (0.8, 0, -0.15), (0, 0.7, 0)))
    glb.mesh("Ball", 0, sphere((0.5, 0.18, -0.2), 0.18))
    behind = glb.material("Lamp behind", (0, 0, 0), emissiveFactor=[1, 1, 1], extensions={
        "KHR_materials_emissive_strength": {"emissiveStrength": 40}})
    glb.mesh("Lamp behind", behind, quad((0.7, 1.7, -0.8), (0.3, 0, 0), (0, 0, 0.3)))


def add_depth_of_field(glb):
    """Balls at different distances; the middle one is sharp."""
    colors = ((0.7, 0.15, 0.1), (0.75, 0.6, 0.2), (0.2, 0.55, 0.25), (0.15, 0.3, 0.7))
    for i, color in enumerate(colors):
        material = glb.material(f"Ball {i}", color)
        glb.mesh(f"Ball {i}", material, sphere((0.42 * i - 0.63, 0.17, 0.9 - 0.55 * i), 0.17))
    glb.root["nodes"][-5]["extras"] = {"hipmap": {"aperture_radius": 0.06, "focus_distance": 2.2}}


def add_soft_shadows(glb):
    """A sphere lamp over a ball, a mirror and a pole."""
    glb.root["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "point", "intensity": 683 * 4, "extras": {"hipmap": {"radius": 0.2}}}]}}
    glb.root["extensionsUsed"].append("KHR_lights_punctual")
    glb.node("Lamp", translation=[-0.6, 1.7, 0.6],
             extensions={"KHR_lights_punctual": {"light": 0}})
    glb.mesh("Ball", 0, sphere((-0.35, 0.3, 0.1), 0.3))
    mirror = glb.material("Mirror", (0.9, 0.9, 0.9),
                          base={"metallicFactor": 1, "roughnessFactor": 0})
    glb.mesh("Mirror ball", mirror, sphere((0.45, 0.35, 0.2), 0.35, 64, 32))


def add_motion(glb):
    """A ball that jumps past a mirror ball in a second, in two parabolas."""
    red = glb.material("Red", (0.75, 0.12, 0.08))
    mirror = glb.material("Mirror", (0.9, 0.9, 0.9),
                          base={"metallicFactor": 1, "roughnessFactor": 0})
    glb.mesh("Mirror ball", mirror, sphere((0, 0.3, -0.2), 0.3, 64, 32))
    glb.mesh("Ball", red, sphere((0, 0, 0), 0.2))
    rows = []
    for x, fall, jump in ((-0.825, 0, 4), (0.20625, -4, 2.4), (0.825, -2.4, 0)):
        rows += [(1.65, fall, 0), (x, 0.2, 0.5), (1.65, jump, 0)]
    glb.animate("Ball", translation=("CUBICSPLINE", (0, 0.625, 1), rows))


def add_environment(glb):
    """A blue sky beside the lamp."""
    glb.mesh("Ball", 0, sphere((0.1, 0.4, 0), 0.4, 40, 20))
    glb.root["scenes"][0]["extras"] = {"hipmap": {"world_color": [0.35, 0.55, 1],
                                                  "world_strength": 0.3}}


def add_reflections(glb):
    """A mirror, a glossy reflection that is followed, one that is gathered, and glass."""
    glb.mesh("Red panel", glb.material("Red", (0.7, 0.1, 0.08)),
             quad((-1.2, 0, 0.4), (0, 0, -1.2), (0, 1, 0)))
    for i, roughness in enumerate((0, 0.2, 0.45)):
        metal = glb.material(f"Metal {roughness}", (0.9, 0.85, 0.75), base={
            "metallicFactor": 1, "roughnessFactor": roughness})
        glb.mesh(f"Ball {i}", metal, sphere((0.62 * i - 0.8, 0.28, -0.2), 0.28))
    glass = glb.material("Glass", (1, 1, 1), base={"roughnessFactor": 0}, extensions={
        "KHR_materials_ior": {"ior": 1.5}, "KHR_materials_transmission": {"transmissionFactor": 1}})
    glb.mesh("Glass ball", glass, sphere((0, 0.21, 0.5), 0.2))


def add_sheen(glb):
    """Velvet: dark red with a pale sheen, narrow and wide, on balls and a hanging cloth."""
    def velvet(name, color, sheen, roughness):
        return glb.material(name, color, doubleSided=True, extensions={
            "KHR_materials_sheen": {"sheenColorFactor": sheen, "sheenRoughnessFactor": roughness}})

    glb.mesh("Left ball", velvet("Narrow sheen", (0.25, 0.02, 0.03), [1, 0.75, 0.7], 0.15),
             sphere((-0.5, 0.36, 0.1), 0.36, 40, 20))
    glb.mesh("Right ball", velvet("Wide sheen", (0.03, 0.05, 0.2), [0.6, 0.8, 1], 0.6),
             sphere((0.45, 0.36, 0.1), 0.36, 40, 20))


def add_textures(glb):
    """Squares of two colours."""
    def squares(x, y):
        return (200, 70, 40, 255) if (x // 8 + y // 8) % 2 else (235, 225, 190, 255)

    picture = glb.texture(png(64, 64, squares), magFilter=9728)
    chequered = glb.material("Chequered", (1, 1, 1), base={"baseColorTexture": picture})
    glb.mesh("Panel", chequered, quad((-0.85, 0.02, -0.1), (0.8, 0, -0.2), (0, 0.9, 0)))
    glb.mesh("Ball", chequered, sphere((0.5, 0.4, 0.1), 0.38, 40, 20))


SCENES = {
    "absorption": (effect_insides.add_absorption, 20),
    "alpha": (add_alpha, 20),
    "anisotropy": (add_anisotropy, 20),
    "clearcoat": (add_clearcoat, 20),
    "clearcoat_normal": (add_clearcoat_normal, 20),
    "depth_of_field": (add_depth_of_field, 20),
    "diffuse_transmission": (add_diffuse_transmission, 3),
    "dispersion": (effect_insides.add_dispersion, 8),
    "emissive_picture": (add_emissive_picture, 0),
    "environment": (add_environment, 12),
    "fog": (effect_insides.add_fog, 1.5),
    "milk": (effect_insides.add_milk, 20),
    "motion": (add_motion, 20),
    "nested_dielectrics": (effect_insides.add_nested_dielectrics, 20),
    "normal_maps": (add_normal_maps, 20),
    "reflection_models": (add_reflection_models, 20),
    "reflections": (add_reflections, 20),
    "rough_metal": (add_rough_metal, 20),
    "sheen": (add_sheen, 20),
    "smoke": (effect_insides.add_smoke, 20),
    "soft_shadows": (add_soft_shadows, 0),
    "subsurface": (effect_insides.add_subsurface, 20),
    "textures": (add_textures, 20),
    "vertex_colours": (add_vertex_colours, 20),
    "ward_lafortune": (add_ward_lafortune, 20),
}


def build_all(folder):
    """Writes NAME.glb of every scene, and smoke.vol; returns the names."""
    smoke_density.write(os.path.join(folder, "smoke.vol"))
    for name, (add, radiance) in SCENES.items():
        glb = stage(radiance)
        add(glb)
        glb.write(os.path.join(folder, name + ".glb"))
    return sorted(SCENES)


if __name__ == "__main__":
    build_all(sys.argv[1])
