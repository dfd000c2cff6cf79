"""Writes furnished scenes as glTF, as a Blender user's export looks; extends assets/glb_writer.py."""

import argparse
import os
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "..", "assets")]

# pylint: disable=wrong-import-position
import glb_writer
import vectors as v3
from shading import shade

FLOAT, SHORT, LONG = 5126, 5123, 5125
WATT = 683 / (4 * 3.141592653589793)  # candela of a point light of 1 W, as Blender's Standard mode


class Room(glb_writer.Glb):
    """A scene in the making: solids with materials, lights, a camera and what is around them."""

    def __init__(self, detail=1.0):
        super().__init__()
        self.root["asset"]["generator"] = "hipmap bench/scenes"
        self.binary = bytearray()
        self.detail = detail
        self.faces = 0
        self.mesh_faces = []
        self.lights = []

    def steps(self, count, least=3):
        """A number of segments at this detail."""
        return max(least, round(count * self.detail))

    def use(self, *names):
        used = self.root.setdefault("extensionsUsed", [])
        used.extend(name for name in names if name not in used)

    # Materials

    def image(self, data, repeats=1.0):
        """A texture that repeats every 1 / repeats metres."""
        slot = self.texture(data, wrapS=10497, wrapT=10497)
        if repeats != 1.0:
            self.use("KHR_texture_transform")
            slot["extensions"] = {"KHR_texture_transform": {"scale": [repeats, repeats]}}
        return slot

    def paint(self, name, color, roughness=0.5, metallic=0.0, texture=None, extensions=None, **parts):
        """A Principled BSDF with specular 0.5, as Blender writes it."""
        base = {"baseColorFactor": [*color, 1], "metallicFactor": metallic,
                "roughnessFactor": roughness}
        if texture is not None:
            base["baseColorTexture"] = texture
        if "rough_texture" in parts:
            base["metallicRoughnessTexture"] = parts.pop("rough_texture")
        entry = {"name": name, "doubleSided": True, "pbrMetallicRoughness": base, **parts}
        if extensions:
            self.use(*sorted(extensions))
            entry["extensions"] = extensions
        self.root["materials"].append(entry)
        return len(self.root["materials"]) - 1

    def matte(self, name, color, texture=None, **parts):
        """A Principled BSDF with specular 0: Lambert."""
        extensions = {"KHR_materials_specular": {"specularFactor": 0}}
        extensions.update(parts.pop("extensions", {}))
        return self.paint(name, color, 1.0, 0.0, texture, extensions, **parts)

    def metal(self, name, color, roughness, **parts):
        return self.paint(name, color, roughness, 1.0, **parts)

    def glass(self, name, ior=1.45, color=(1, 1, 1), roughness=0.0, absorb=None, priority=None):
        """A material that transmits; absorb is a colour and the depth in metres that leaves it."""
        extensions = {"KHR_materials_transmission": {"transmissionFactor": 1},
                      "KHR_materials_ior": {"ior": ior}}
        if absorb:
            extensions["KHR_materials_volume"] = {
                "thicknessFactor": 1, "attenuationColor": list(absorb[0]),
                "attenuationDistance": absorb[1]}
        extras = {"extras": {"hipmap": {"priority": priority}}} if priority is not None else {}
        return self.paint(name, color, roughness, extensions=extensions, **extras)

    def paper(self, name, color, share, through=None):
        """A thin diffuse material that transmits a share of the light diffusely."""
        return self.matte(name, color, extensions={"KHR_materials_diffuse_transmission": {
            "diffuseTransmissionFactor": share,
            "diffuseTransmissionColorFactor": list(through or color)}})

    def emitter(self, name, color, radiance, texture=None):
        """An emissive material of a radiance in W/(m2 sr)."""
        parts = {"emissiveTexture": texture} if texture else {}
        return self.paint(name, (0, 0, 0), 1.0, extensions={
            "KHR_materials_emissive_strength": {"emissiveStrength": radiance}},
            emissiveFactor=list(color), **parts)

    # Meshes

    def block(self, rows, kind, component):
        """An accessor of an array; positions also get their bounds."""
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[kind]
        entry = {"bufferView": self.view(rows.tobytes()), "componentType": component,
                 "count": len(rows) // width, "type": kind}
        if kind == "VEC3":
            entry["min"] = [min(rows[k::3]) for k in range(3)]
            entry["max"] = [max(rows[k::3]) for k in range(3)]
        self.root["accessors"].append(entry)
        return len(self.root["accessors"]) - 1

    def mesh_of(self, name, parts, smooth_deg=30.0):
        """A mesh of pairs (material, solid), one primitive each; returns its number."""
        primitives, faces = [], 0
        for material, solid in parts:
            vertices = shade(solid, smooth_deg)
            small = vertices.count() <= 65535
            indices = vertices.indices if not small else type(vertices.indices)(
                "H", vertices.indices)
            primitives.append({"material": material, "attributes": {
                "POSITION": self.block(vertices.positions, "VEC3", FLOAT),
                "NORMAL": self.block(vertices.normals, "VEC3", FLOAT),
                "TEXCOORD_0": self.block(vertices.uvs, "VEC2", FLOAT)},
                "indices": self.block(indices, "SCALAR", SHORT if small else LONG)})
            faces += len(vertices.indices) // 3
        self.root["meshes"].append({"name": name, "primitives": primitives})
        self.mesh_faces.append(faces)
        return len(self.root["meshes"]) - 1

    def place(self, name, mesh, at=(0, 0, 0), turn=0.0, rotation=None, scale=None):
        """An object that shows a mesh, turned about the Y axis by degrees or by a quaternion."""
        parts = {"translation": list(at)} if tuple(at) != (0, 0, 0) else {}
        if rotation is None and turn:
            rotation = v3.axis_turn((0, 1, 0), turn)
        if rotation is not None:
            parts["rotation"] = list(rotation)
        if scale is not None:
            parts["scale"] = [scale] * 3 if isinstance(scale, (int, float)) else list(scale)
        self.node(name, mesh=mesh, **parts)
        self.faces += self.mesh_faces[mesh]

    def add(self, name, material, solid, **where):
        """An object of one solid and one material; returns its mesh."""
        mesh = self.mesh_of(name, [(material, solid)])
        self.place(name, mesh, **where)
        return mesh

    # Lights and camera

    def _light(self, name, light, place, direction):
        self.use("KHR_lights_punctual")
        self.root["extensionsRequired"] = ["KHR_lights_punctual"]
        self.lights.append({"name": name, **light})
        self.root["extensions"] = {"KHR_lights_punctual": {"lights": self.lights}}
        self.node(name, translation=list(place), rotation=list(v3.turn_onto(direction)),
                  extensions={"KHR_lights_punctual": {"light": len(self.lights) - 1}})

    def point(self, name, place, watts, color=(1, 1, 1), radius=0.03):
        self._light(name, {"type": "point", "color": list(color), "intensity": watts * WATT,
                           "extras": {"hipmap": {"radius": radius}}}, place, (0, 0, -1))

    def spot_at(self, name, place, target, watts, angle, color=(1, 1, 1), radius=0.03):
        """A spot light towards a point; angle is half of its cone, in radians."""
        self._light(name, {"type": "spot", "color": list(color), "intensity": watts * WATT,
                           "spot": {"innerConeAngle": 0.7 * angle, "outerConeAngle": angle},
                           "extras": {"hipmap": {"radius": radius}}}, place, v3.sub(target, place))

    def sun(self, name, direction, irradiance, color=(1, 1, 1), angle_deg=0.5):
        """A sun of an irradiance in W/m2."""
        self._light(name, {"type": "directional", "color": list(color),
                           "intensity": irradiance * 683,
                           "extras": {"hipmap": {"angle_deg": angle_deg}}}, (0, 5, 0), direction)

    def world(self, color, strength):
        """A sky of even radiance."""
        self.root["scenes"][0]["extras"] = {"hipmap": {"world_color": list(color),
                                                       "world_strength": strength}}

    def camera(self, place, target, yfov):
        self.root["cameras"] = [{"type": "perspective", "name": "Camera", "perspective": {
            "yfov": yfov, "aspectRatio": 1.5, "znear": 0.05, "zfar": 100}}]
        self.node("Camera", camera=0, translation=list(place),
                  rotation=list(v3.turn_onto(v3.sub(target, place))))


def run(build):
    """The command line of a scene: build(room) fills it."""
    parser = argparse.ArgumentParser(description=sys.modules["__main__"].__doc__)
    parser.add_argument("output", metavar="OUT.glb")
    parser.add_argument("--detail", type=float, default=1.0, metavar="N",
                        help="tessellation relative to the default, the shapes stay [1]")
    options = parser.parse_args()
    print(write_scene(build, options.output, options.detail))


def write_scene(build, path, detail=1.0):
    """Builds a scene and writes it; returns a line about it."""
    begin = time.time()
    room = Room(detail)
    build(room)
    room.write(path)
    return (f"{path}: {room.faces} triangles, {len(room.root['nodes'])} objects, "
            f"{len(room.root['materials'])} materials, {os.path.getsize(path) / 1e6:.1f} MB, "
            f"{time.time() - begin:.1f} s")
