"""What light meets inside closed meshes: the scenes of effects.py about glass and media."""

import math

from glb_writer import box, quad, sphere


def add_absorption(glb):
    """The same glass, thin and thick."""
    glass = glb.material("Bottle glass", (1, 1, 1), base={"roughnessFactor": 0}, extensions={
        "KHR_materials_ior": {"ior": 1.5}, "KHR_materials_transmission": {"transmissionFactor": 1},
        "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 0.3,
                                 "attenuationColor": [0.15, 0.6, 0.3]}})
    glb.mesh("Large ball", glass, sphere((0.35, 0.41, 0), 0.4, 40, 20))
    glb.mesh("Small ball", glass, sphere((-0.4, 0.16, 0.2), 0.15, 40, 20))


def prism(centre, side, length, turn):
    """An equilateral one along z; `turn` (radians) from its apex being on top."""
    corners = [(centre[0] + side / math.sqrt(3) * math.cos(angle),
                centre[1] + side / math.sqrt(3) * math.sin(angle))
               for angle in (turn + math.pi / 2 + 2 * math.pi * i / 3 for i in range(3))]
    back, front = centre[2] - length / 2, centre[2] + length / 2
    positions, normals, uvs, faces = [], [], [], []

    def add(points, normal):
        first = len(positions)
        positions.extend(points)
        normals.extend([normal] * len(points))
        uvs.extend([(0, 0)] * len(points))
        faces.extend((first, first + i, first + i + 1) for i in range(1, len(points) - 1))

    add([(*corner, front) for corner in corners], (0, 0, 1))
    add([(*corner, back) for corner in reversed(corners)], (0, 0, -1))
    for i, a in enumerate(corners):
        b = corners[(i + 1) % 3]
        normal = ((b[1] - a[1]) / side, (a[0] - b[0]) / side, 0)
        add([(*a, front), (*a, back), (*b, back), (*b, front)], normal)
    return positions, normals, uvs, faces


def add_dispersion(glb):
    """A prism of a glass that parts colours more than any real one, in the light of a spot."""
    glass = glb.material("Prism", (1, 1, 1), base={"roughnessFactor": 0}, extensions={
        "KHR_materials_ior": {"ior": 1.6}, "KHR_materials_transmission": {"transmissionFactor": 1},
        "KHR_materials_dispersion": {"dispersion": 3}})
    glb.mesh("Prism", glass, prism((-0.6, 0.9, -0.1), 0.22, 0.4, math.radians(-23)))
    glb.spot("Spot", (-1.4, 0.9, -0.1), (0, -math.sqrt(0.5), 0, math.sqrt(0.5)), 40000,
             math.radians(1.6))


def lathe(centre, profile, sides=48):
    """Turns (radius, height) points about the y axis; its outside is on the right of the way they
    go, upwards."""
    positions, normals, uvs, faces = [], [], [], []
    turns = [2 * math.pi * i / sides for i in range(sides)]
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        length = math.hypot(r1 - r0, y1 - y0)
        across, up = (y1 - y0) / length, (r0 - r1) / length
        first = len(positions)
        for angle in turns:
            for r, y in ((r0, y0), (r1, y1)):
                positions.append((centre[0] + r * math.cos(angle), centre[1] + y,
                                  centre[2] - r * math.sin(angle)))
                normals.append((across * math.cos(angle), up, -across * math.sin(angle)))
                uvs.append((angle / (2 * math.pi), y))
        for i in range(sides):
            a, b = first + 2 * i, first + 2 * ((i + 1) % sides)
            if r0 > 0:
                faces.append((a, b, b + 1))
            if r1 > 0:
                faces.append((a, b + 1, a + 1))
    return positions, normals, uvs, faces


def add_nested_dielectrics(glb):
    """Tea in a glass, with a straw: the tea reaches into the wall of the glass, which wins there."""
    def clear(name, ior, **parts):
        return glb.material(name, (1, 1, 1), base={"roughnessFactor": 0}, extensions={
            "KHR_materials_ior": {"ior": ior},
            "KHR_materials_transmission": {"transmissionFactor": 1},
            **parts.pop("extensions", {})}, **parts)

    centre = (0, 0.01, 0)
    glass = clear("Glass", 1.5, extras={"hipmap": {"priority": 1}})
    glb.mesh("Glass", glass, lathe(centre, (
        (0, 0), (0.34, 0), (0.38, 1), (0.34, 1), (0.3, 0.08), (0, 0.08))))
    tea = clear("Tea", 1.33, extensions={"KHR_materials_volume": {
        "thicknessFactor": 1, "attenuationDistance": 0.35, "attenuationColor": [0.8, 0.4, 0.1]}})
    glb.mesh("Tea", tea, lathe(centre, (
        (0, 0.04), (0.32, 0.04), (0.348, 0.7), (0, 0.7))))
    straw = glb.material("Straw", (0.75, 0.12, 0.08))
    leaning = [[(x + 0.3 * (y - 0.5), y, z) if part == 0 else (x, y, z) for x, y, z in rows]
               if part < 2 else rows for part, rows in enumerate(
                   lathe((0.02, 0.1, 0.05), ((0, 0), (0.03, 0), (0.03, 1.2), (0, 1.2)), 16))]
    glb.mesh("Straw", straw, leaning)


def add_subsurface(glb):
    """A ball and a leaf of wax, lit from behind."""
    wax = glb.material("Wax", (1, 1, 1), extensions={
        "KHR_materials_ior": {"ior": 1.4},
        "KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 1},
        "KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 0.1,
                                 "attenuationColor": [0.3, 0.2, 0.1]},
        "KHR_materials_volume_scatter": {"multiscatterColor": [0.92, 0.7, 0.4]}})
    glb.mesh("Ball", wax, sphere((-0.45, 0.36, 0.1), 0.35, 40, 20))
    glb.mesh("Leaf", wax, box((0.15, 0.01, 0), (0.8, 0.75, 0.05)))
    behind = glb.material("Lamp behind", (0, 0, 0), emissiveFactor=[1, 1, 1], extensions={
        "KHR_materials_emissive_strength": {"emissiveStrength": 12}})
    glb.mesh("Lamp behind", behind, quad((0.3, 0.2, -0.4), (0.35, 0, 0), (0, 0.35, 0)))


def add_fog(glb):
    """A spot shines through fog, and a ball stands in its way."""
    glb.root["scenes"][0]["extras"] = {"hipmap": {"medium": {
        "scattering": [0.22, 0.22, 0.22], "absorption": [0.02, 0.02, 0.02], "g": 0.3}}}
    used = glb.root.setdefault("extensionsUsed", [])
    used.append("KHR_lights_punctual")
    spot = {"type": "spot", "name": "Spot", "intensity": 683 * 30,
            "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.24}}
    glb.root["extensions"] = {"KHR_lights_punctual": {"lights": [spot]}}
    down = math.atan2(1.4, 1.5)  # turned from -z to +x, then downwards
    half_turn, half_down = -math.pi / 4, -down / 2
    glb.node("Spot", translation=[-1.0, 1.75, 0.1],
             rotation=[math.cos(half_turn) * math.sin(half_down),
                       math.sin(half_turn) * math.cos(half_down),
                       -math.sin(half_turn) * math.sin(half_down),
                       math.cos(half_turn) * math.cos(half_down)],
             extensions={"KHR_lights_punctual": {"light": 0}})
    red = glb.material("Red", (0.7, 0.15, 0.1))
    glb.mesh("Ball", red, sphere((-0.14, 0.95, 0.1), 0.12))


def add_milk(glb):
    """A ball of milky glass, and a ball of smoke that has no surface."""
    milk = {"scattering": [9, 10, 11], "absorption": [0.02, 0.1, 0.3], "g": 0.5}
    glass = glb.material(
        "Milky glass", (1, 1, 1), base={"roughnessFactor": 0},
        extensions={"KHR_materials_transmission": {"transmissionFactor": 1},
                    "KHR_materials_ior": {"ior": 1.4}}, extras={"hipmap": {"medium": milk}})
    smoke = {"scattering": [3, 3, 3], "absorption": [1.5, 0.8, 0.4], "phase": "schlick", "g": 0.6}
    cloud = glb.material("Smoke", (1, 1, 1),
                         extras={"hipmap": {"boundary": False, "medium": smoke}})
    glb.mesh("Ball of glass", glass, sphere((-0.45, 0.39, 0), 0.38, 40, 20))
    glb.mesh("Ball of smoke", cloud, sphere((0.45, 0.39, 0), 0.38, 40, 20))


def add_smoke(glb):
    """Smoke of a density that differs from place to place, in a box that has no surface."""
    smoke = {"scattering": [16, 16, 15], "absorption": [2, 3, 4], "phase": "schlick", "g": 0.3,
             "density": "smoke.vol"}
    cloud = glb.material("Smoke", (1, 1, 1),
                         extras={"hipmap": {"boundary": False, "medium": smoke}})
    glb.mesh("Box of smoke", cloud, box((-0.55, 0.01, -0.6), (0.65, 1.7, 0.6)))
    red = glb.material("Red", (0.7, 0.15, 0.1))
    glb.mesh("Ball", red, sphere((-0.75, 0.2, 0.3), 0.2, 40, 20))
