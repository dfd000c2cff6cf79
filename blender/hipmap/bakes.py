# SPDX-License-Identifier: GPL-3.0-or-later
"""Nodes that glTF cannot express, as images that a Blender of its own bakes.

The user's scene stays as it is: meshes go to the other Blender as arrays, and images come back as
arrays.  A mesh gets a UV map of its own for them, on which no two faces overlap.
"""

import hashlib
import json
import os
from dataclasses import dataclass, replace

import bpy
import numpy

from .geometry import BAKED_UV, read_array
from .node_digest import all_nodes, tree_digest
from .run import Child, ToolError, wait_for
from .sockets import Texture
from .surfaces import TERMS, surface_of

_SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bake_nodes.py")
_LEAST_PEAK = 1.0

_OF_THE_WORLD = {"ShaderNode" + kind for kind in (
    "NewGeometry", "ObjectInfo", "VectorTransform", "CameraData", "Bevel", "AmbientOcclusion",
    "Fresnel", "LayerWeight", "LightPath")}

# Terms that share an image of glTF, and so a place on it.
_TOGETHER = (("base", "alpha"), ("metallic", "roughness"))


@dataclass(frozen=True)
class BakedImage:
    """An image of Blender as far as textures need it, linear."""

    name: str
    name_full: str  # tells it from others
    values: numpy.ndarray  # [height, width, 4] float32, 0 to 1, first row at the bottom
    peak: float = 1.0  # what they were divided by

    is_float = is_dirty = True
    source = "BAKED"

    @property
    def size(self):
        """Width and height."""
        return self.values.shape[1], self.values.shape[0]

    @property
    def colorspace_settings(self):
        """Its name says that the values are linear."""
        return _Linear

    @property
    def pixels(self):
        """What has foreach_get."""
        return self

    def foreach_get(self, out):
        """Copies the values."""
        out[:] = self.values.ravel()


class _Linear:
    name = "Non-Color"


@dataclass(frozen=True)
class BakedMesh:
    """What was baked of one mesh."""

    uvs: numpy.ndarray  # [corners, 2], v downwards as in glTF
    images: dict  # BakedImages by the full name of a material and the name of a term

    def has(self, name):
        """Whether there is an image of the material with this full name."""
        return any(material == name for material, _ in self.images)

    def fill(self, material, surface):
        """Puts the images into the Surface of a material, None: a face without one."""
        for (name, term), image in self.images.items():
            if material is None or name != material.name_full:
                continue
            texture = Texture(image, uv_name=BAKED_UV, wrap="EXTEND")
            if term == "normal":
                surface.normal, surface.normal_scale, surface.normal_loss = texture, 1.0, None
                continue
            source = getattr(surface, term)
            factor = image.peak * source.place.factor
            value = (factor,) if len(source.value) == 1 else (factor, factor, factor, 1.0)
            setattr(surface, term, replace(source, value=value, texture=texture, colour_layer=None,
                                           loss=None))


def _terms_to_bake(surface):
    """Names of the terms of a Surface for which nodes must be baked."""
    terms = {term for term in TERMS if getattr(surface, term).loss}
    for pair in _TOGETHER:
        if terms.intersection(pair):  # one UV map for both
            terms |= {term for term in pair if getattr(surface, term).texture is not None}
    return sorted(terms) + (["normal"] if surface.normal_loss else [])


def _requests(materials, slots):
    """What to bake of a mesh with these materials in these slots: a dictionary for each image."""
    found = []
    for slot in slots:
        material = materials[min(slot, len(materials) - 1)] if materials else None
        surface = surface_of(material) if material else None
        for term in _terms_to_bake(surface) if surface else ():
            place = None if term == "normal" else getattr(surface, term).place
            found.append({"slot": slot, "material": material.name_full, "term": term,
                          "groups": list(place.groups) if place else [],
                          "node": place.node if place else "",
                          "socket": place.socket if place else ""})
    return found


def _read(things, name, kind, width=1):
    return read_array(things, name, kind, width).reshape(-1)


def _layers(mesh):
    """The UV maps and colour layers of a mesh: what tells them, and their values."""
    for layer in mesh.uv_layers:
        yield ("uv", layer.name, layer.active_render), _read(layer.data, "uv", "f4", 2)
    for layer in getattr(mesh, "color_attributes", ()):
        yield ("colour", layer.name, layer.domain), _read(layer.data, "color", "f4", 4)


def _arrays_of(item, mesh):
    """A mesh and its object as arrays, and what else is to be known as a dictionary."""
    layers = list(_layers(mesh))
    arrays = {"positions": _read(mesh.vertices, "co", "f4", 3),
              "corners": _read(mesh.loops, "vertex_index", "i4"),
              "starts": _read(mesh.polygons, "loop_start", "i4"),
              "counts": _read(mesh.polygons, "loop_total", "i4"),
              "slots": _read(mesh.polygons, "material_index", "i4"),
              "smooth": _read(mesh.polygons, "use_smooth", bool),
              **{f"layer_{index}": values for index, (_, values) in enumerate(layers)}}
    known = {"layers": [told for told, _ in layers], "name": item.name, "pass": item.pass_index,
             "colour": list(item.color), "matrix": [list(row) for row in item.matrix_world]}
    original = item.original.data
    if item.type == "MESH" and original:  # modifiers do not move generated coordinates
        known["space"] = [list(original.texspace_location), list(original.texspace_size)]
    return arrays, known


def _sees_world(node):
    """Whether what a node gives changes when its object is moved or turned."""
    if node.bl_idname == "ShaderNodeTexCoord":
        return node.object is not None or any(
            node.outputs[name].is_linked for name in ("Camera", "Window", "Reflection"))
    return node.bl_idname in _OF_THE_WORLD


def _digest(arrays, known, item, materials):
    moved = any(_sees_world(node) for material in materials for node in
                all_nodes(material.node_tree))
    # A bump has the height of the world, so that scale counts.
    place = known["matrix"] if moved else [round(c, 5) for c in item.matrix_world.to_scale()]
    found = hashlib.sha256(json.dumps({**known, "matrix": place}, sort_keys=True).encode())
    for name in sorted(arrays):
        found.update(arrays[name].tobytes())
    for material in materials:
        found.update(tree_digest(material.node_tree).encode())
    return found.hexdigest()[:16]


class NodeBaker:
    """Finds out what to bake, and has it baked."""

    def __init__(self, folder, size, is_cancelled):
        """folder: where images are kept; size: of the images, pixels; is_cancelled: called while
        another Blender bakes."""
        self._folder, self._size, self._is_cancelled = folder, size, is_cancelled
        self._paths = {}  # by the key of a mesh
        self._missing = []  # paths of what is to be baked
        self._materials = {}  # to send along, by their full names

    def add(self, key, item, materials):
        """Adds a mesh, if a material on it has nodes to bake.  key: what tells it from others."""
        if key in self._paths or not any(_terms_to_bake(surface) for surface in
                                         map(surface_of, filter(None, materials)) if surface):
            return
        mesh = item.to_mesh()
        if mesh is None:
            return
        try:
            arrays, known = _arrays_of(item, mesh)
        finally:
            item.to_mesh_clear()
        known["requests"] = _requests(materials, numpy.unique(arrays["slots"]).tolist())
        known["size"] = self._size
        if not known["requests"]:
            return
        used = {material.name_full: material.original for material in materials
                if material and material.node_tree}
        path = os.path.join(self._folder,
                            f"baked_{_digest(arrays, known, item, used.values())}.npz")
        self._paths[key] = path
        if not os.path.isfile(path) and path not in self._missing:
            self._missing.append(path)
            self._materials.update(used)
            known["names"] = {name: material.name for name, material in used.items()}
            with open(path + ".in", "wb") as file:
                numpy.savez(file, known=numpy.frombuffer(json.dumps(known).encode(), "u1"),
                            **arrays)

    def finish(self):
        """Bakes what is missing, and removes what is used no more.  Returns BakedMeshes by the keys
        of meshes.  Throws ToolError or Cancelled."""
        if self._missing:
            self._bake()
        used = {os.path.basename(path) for path in self._paths.values()}
        for name in os.listdir(self._folder):
            if name.startswith("baked_") and name not in used:
                os.remove(os.path.join(self._folder, name))
        return {key: _load(path) for key, path in self._paths.items()}

    def _bake(self):
        blend = os.path.join(self._folder, "baked.blend")
        bpy.data.libraries.write(blend, set(self._materials.values()), path_remap="ABSOLUTE")
        command = [bpy.app.binary_path, "--background", "--factory-startup",
                   "--python-exit-code", "1", "--python", _SCRIPT, "--", blend, *self._missing]
        try:
            child = Child(command)
            if wait_for(child, self._is_cancelled) != 0:
                raise ToolError(f"Blender could not bake nodes: {child.last_error()}")
        finally:
            for path in (blend, *(path + ".in" for path in self._missing)):
                os.remove(path)


def _load(path):
    """The BakedMesh of a file."""
    with numpy.load(path) as file:
        requests = json.loads(file["requests"].tobytes())
        uvs = file["uvs"].reshape(-1, 2).astype("f4")
        images = {}
        for index, request in enumerate(requests):
            values = file[f"image_{index}"].astype("f4")
            peak = max(_LEAST_PEAK, float(values[:, :, :3].max()))
            values[:, :, :3] /= peak
            name = f"{request['material']} {request['term']}"
            images[request["material"], request["term"]] = BakedImage(
                name, f"{os.path.basename(path)} {name}", values, peak)
    uvs[:, 1] = 1 - uvs[:, 1]
    return BakedMesh(uvs, images)
