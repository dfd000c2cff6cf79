"""The room that every scene of the sweep is built on: closed, diffuse, with one area light.

Metres, glTF's axes (y up).  The room fills -1 to 1, 0 to 2, -1 to 1 (x, y, z); the camera stands
inside and looks along -z.  Every face has the front towards the inside.
"""

import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "assets"))
from glb_writer import Glb, box, quad, sphere

GREY = (0.6, 0.5, 0.4)
RADIANCE = 5.0
WALLS = {
    "floor": ((-1, 0, 1), (2, 0, 0), (0, 0, -2)),
    "ceiling": ((-1, 2, -1), (2, 0, 0), (0, 0, 2)),
    "back": ((-1, 0, -1), (2, 0, 0), (0, 2, 0)),
    "front": ((1, 0, 1), (-2, 0, 0), (0, 2, 0)),
    "left": ((-1, 0, 1), (0, 0, -2), (0, 2, 0)),
    "right": ((1, 0, -1), (0, 0, 2), (0, 2, 0)),
}
LIGHT = ((-0.5, 1.9, -0.5), (1, 0, 0), (0, 0, 1))


def triangles_of(shape):
    """[(three corners)] of a shape of glb_writer."""
    positions, _, _, faces = shape
    return [tuple(positions[i] for i in face) for face in faces]


def turned(triangles):
    """The same triangles seen from the other side."""
    return [corners[::-1] for corners in triangles]


class Room(Glb):
    """A scene in the making.  scale: metres for each unit of the coordinates that are added.
    expect: `lit`, `black`, or `refused` where an error is as good as an image."""

    def __init__(self, without=(), light=RADIANCE, albedo=GREY, scale=1.0, expect=("lit",)):
        super().__init__()
        self.scale, self.expect = scale, expect
        self.render_options = ()
        self.grey = self.material("Grey", albedo)
        for name, corners in WALLS.items():
            if name not in without:
                self.add(name, self.grey, triangles_of(quad(*corners)))
        if light is not None:
            self.add("Light", self.glowing(light), triangles_of(quad(*LIGHT)))
        self.root["cameras"] = [{"type": "perspective", "perspective": {
            "yfov": 1.3, "aspectRatio": 1, "znear": 0.001 * scale}}]
        self.camera = (0, 1, 0.95)

    def widen_lights(self):
        """Makes lights so wide that paths find them in mirrors and behind glass.  Returns whether there are any."""
        found = self.root.get("extensions", {}).get("KHR_lights_punctual", {"lights": []})["lights"]
        for light in found:
            wide = {"angle_deg": 40} if light["type"] == "directional" else {"radius": 0.25 * self.scale}
            light.setdefault("extras", {})["hipmap"] = wide
        return bool(found)

    def glowing(self, radiance, **parts):
        """radiance: W/(m2 sr), of fronts alone unless `doubleSided`."""
        return self.material(
            "Glowing", (0, 0, 0), emissiveFactor=[1, 1, 1],
            extensions={"KHR_materials_emissive_strength": {"emissiveStrength": radiance}}, **parts)

    def glass(self, ior=1.5, **base):
        return self.material(
            "Glass", (1, 1, 1), base={"roughnessFactor": 0, **base},
            extensions={"KHR_materials_transmission": {"transmissionFactor": 1},
                        "KHR_materials_ior": {"ior": ior}})

    def metal(self, roughness, color=(0.9, 0.9, 0.9)):
        return self.material("Metal", color,
                             base={"metallicFactor": 1, "roughnessFactor": roughness})

    def add(self, name, material, triangles):
        """triangles: [(three corners)]; flat, no vertex is shared but by its place."""
        rows = [tuple(self.scale * x for x in corner) for corners in triangles
                for corner in corners]
        self.root["meshes"].append({"name": name, "primitives": [
            {"attributes": {"POSITION": self.accessor(rows, "VEC3")}, "material": material}]})
        self.node(name, mesh=len(self.root["meshes"]) - 1)

    def add_box(self, material, low, high, name="Box"):
        self.add(name, material, triangles_of(box(low, high)))

    def add_ball(self, material, centre, radius, segments=24, rings=12):
        self.add("Ball", material, triangles_of(sphere(centre, radius, segments, rings)))

    def write(self, path):
        self.node("Camera", camera=0, translation=[self.scale * x for x in self.camera])
        super().write(path)


def grid(corner, right, up, columns, rows):
    """A rectangle of columns x rows quads, each of two triangles."""
    def at(i, j):
        return tuple(c + i / columns * r + j / rows * u for c, r, u in zip(corner, right, up))
    out = []
    for j in range(rows):
        for i in range(columns):
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            out += [(a, b, c), (a, c, d)]
    return out


def fan(apex, outline):
    """Triangles between a point and each stretch of a line."""
    return [(apex, a, b) for a, b in zip(outline, outline[1:])]


def line(a, b, count):
    """count + 1 points from a to b."""
    return [tuple(x + i / count * (y - x) for x, y in zip(a, b)) for i in range(count + 1)]


def circle(centre, radius, count):
    """count + 1 points around the y axis, counter-clockwise as seen from above."""
    return [(centre[0] + radius * math.cos(2 * math.pi * (i % count) / count), centre[1],
             centre[2] - radius * math.sin(2 * math.pi * (i % count) / count))
            for i in range(count + 1)]
