# SPDX-License-Identifier: GPL-3.0-or-later
"""Triangles of a Blender mesh as arrays of glTF, by numpy."""

from dataclasses import dataclass, field

import numpy
from mathutils import Matrix

# glTF has +Y up.
_TO_Y_UP = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))

# The UV map of baked images, which is in no mesh of Blender.
BAKED_UV = "hipmap baked"

# The layer with the colours of shared photon maps, which no render shows.
MAP_COLOURS = "hipmap Maps"


def in_gltf_axes(to_world):
    """Returns the matrix to glTF's world for one to Blender's."""
    return _TO_Y_UP @ to_world


@dataclass
class Part:
    """The triangles of one material slot, with vertices of their own."""

    slot: int
    corners: numpy.ndarray  # [vertices] a corner of the mesh where each vertex is
    indices: numpy.ndarray  # [3 triangles] uint32
    positions: numpy.ndarray  # [vertices, 3], the object's space
    normals: numpy.ndarray  # [vertices, 3]
    uvs: list = field(default_factory=list)  # [vertices, 2] each, v downwards as in glTF
    colours: numpy.ndarray = None  # [vertices, 4] linear


def read_array(things, name, kind, width=1):
    """Returns an attribute of all things of a collection, [n] or [n, width]."""
    out = numpy.empty(len(things) * width, kind)
    things.foreach_get(name, out)
    return out if width == 1 else out.reshape(-1, width)


def _corner_normals(mesh):
    if hasattr(mesh, "corner_normals"):  # Blender 4.1 and later
        return read_array(mesh.corner_normals, "vector", numpy.float32, 3)
    mesh.calc_normals_split()
    return read_array(mesh.loops, "normal", numpy.float32, 3)


def _uv_map(mesh, name):
    """[corners, 2]; name: None for the map that renders use; None: the mesh has no such map."""
    layers = mesh.uv_layers
    layer = layers.get(name) if name else next((x for x in layers if x.active_render), None)
    if layer is None:
        return None
    uv = read_array(layer.data, "uv", numpy.float32, 2)
    uv[:, 1] = 1 - uv[:, 1]
    return uv


def _default_colours(mesh):
    """The colour layer of a material that names none: the one that renders use; None: there is
    none."""
    if not hasattr(mesh, "color_attributes"):  # before Blender 3.2
        return mesh.vertex_colors.active
    layers = mesh.color_attributes
    index = getattr(layers, "render_color_index", -1)
    layer = layers[index] if 0 <= index < len(layers) else layers.active_color
    return None if layer is None or layer.name == MAP_COLOURS else layer


def _colours(mesh, name, corner_vertices):
    """[corners, 4]; name: "" for the layer that renders use; None: the mesh has no such layer."""
    layers = getattr(mesh, "color_attributes", mesh.vertex_colors)
    layer = layers.get(name) if name else _default_colours(mesh)
    if layer is None:
        return None
    values = read_array(layer.data, "color", numpy.float32, 4)
    return values[corner_vertices] if getattr(layer, "domain", "CORNER") == "POINT" else values


def _hash_rows(rows):
    """[n] 64-bit hashes of rows of 32-bit words."""
    hashes = numpy.zeros(len(rows), numpy.uint64)
    for column in rows.T:
        hashes = (hashes ^ column) * numpy.uint64(0x9E3779B97F4A7C15)
        hashes ^= hashes >> numpy.uint64(29)
    return hashes


def _distinct(rows):
    """The index of one of each kind of row, and for each row which kind it is.  The first column is
    a vertex.  Rows whose hashes collide all stay, which costs memory and no correctness."""
    first, kind, alike = _by_vertex(rows)
    if alike:  # as in a mesh that is smooth all over: nothing to sort
        return first, kind
    _, first, kind = numpy.unique(_hash_rows(rows), return_index=True, return_inverse=True)
    kind = kind.reshape(-1)
    if not numpy.array_equal(rows[first[kind]], rows):
        return numpy.arange(len(rows)), numpy.arange(len(rows))
    return first, kind


def _by_vertex(rows):
    """The index of a row of each vertex, for each row which of them is of its vertex, and whether
    all rows of each vertex are the same."""
    vertex = rows[:, 0]
    of_vertex = numpy.full(int(vertex.max()) + 1, -1)
    of_vertex[vertex] = numpy.arange(len(rows))
    used = of_vertex >= 0
    kind = (numpy.cumsum(used) - 1)[vertex]
    first = of_vertex[used]
    return first, kind, all(numpy.array_equal(column[first][kind], column) for column in rows.T)


def _words(array):
    return numpy.ascontiguousarray(array, numpy.float32).view(numpy.uint32)


class MeshArrays:
    """The arrays of a mesh from which parts are taken."""

    def __init__(self, mesh, baked=None):
        """baked: the BakedMesh of the mesh; None: nothing was baked of it."""
        mesh.calc_loop_triangles()
        self.mesh = mesh
        self.baked = baked
        self.corners = read_array(mesh.loop_triangles, "loops", numpy.int32, 3)
        self.slots = read_array(mesh.loop_triangles, "material_index", numpy.int32)
        self.corner_vertices = read_array(mesh.loops, "vertex_index", numpy.int32)
        self.positions = read_array(mesh.vertices, "co", numpy.float32, 3)
        self.normals = _corner_normals(mesh) if len(self.corners) else None
        self.counts = len(self.positions), len(self.corner_vertices)

    def used_slots(self):
        """Material slots with a triangle, ascending."""
        return numpy.unique(self.slots).tolist()

    def part(self, slot, uv_names, colour_name=None):
        """Returns the triangles of a slot.  uv_names: of the UV maps to write, None for the one
        that renders use; maps that the mesh lacks are left out, with those after them.
        colour_name: of a colour layer; None: none."""
        corners = self.corners[self.slots == slot].reshape(-1)
        attributes = []
        for name in uv_names:
            uv = self.baked.uvs if self.baked and name == BAKED_UV else _uv_map(self.mesh, name)
            if uv is None:
                break
            attributes.append(uv[corners])
        colours = None
        if colour_name is not None:
            colours = _colours(self.mesh, colour_name, self.corner_vertices)
            colours = colours if colours is None else colours[corners]
        vertices, normals = self.corner_vertices[corners], self.normals[corners]
        words = [vertices.view(numpy.uint32)[:, None], _words(normals), *map(_words, attributes)]
        if colours is not None:
            words.append(_words(colours))
        first, kind = _distinct(numpy.concatenate(words, axis=1))
        return Part(slot, corners[first], kind.astype(numpy.uint32),
                    self.positions[vertices[first]], normals[first],
                    [uv[first] for uv in attributes], None if colours is None else colours[first])

    def again(self, part):
        """Returns positions and normals of the vertices of a Part of a mesh of the same counts."""
        return self.positions[self.corner_vertices[part.corners]], self.normals[part.corners]
