# SPDX-License-Identifier: GPL-3.0-or-later
"""Motion blur: what moves while the shutter is open, as an animation of glTF.

In the file a second is the time that the shutter is open, and its middle is at 1 s.  So
`render --frames 1 --fps 1 --shutter 1` blurs it, whatever the scene's shutter and frame rate.
"""

import math
from dataclasses import dataclass, field

import numpy
from mathutils import Matrix

from .geometry import MeshArrays, in_gltf_axes

# Times at which things are looked at, in lengths of the shutter from its middle.
_MOMENTS = (-0.5, -0.25, 0.0, 0.25, 0.5)
_OTHERS = tuple(moment for moment in _MOMENTS if moment != 0)
_TIMES = numpy.array([1 + moment for moment in _MOMENTS], numpy.float32)
_LEAST_SHEAR = 1e-4

# What `preprocess` and `render` need to be told of a file with motion.
FRAME_OPTIONS = ("--frames", "1", "--fps", "1")
SHUTTER_OPTIONS = ("--shutter", "1")
FRAME_SUFFIX = ".0001"


class Shutter:
    """When the shutter of a scene's frame is open.  set_frame: takes a frame and a part of one, and
    evaluates the scene there, as RenderEngine.frame_set does."""

    def __init__(self, scene, set_frame):
        self._frame = (scene.frame_current, scene.frame_subframe)
        self._set_frame = set_frame
        self._length = scene.render.motion_blur_shutter
        position = getattr(position_owner(scene), "motion_blur_position", "CENTER")
        begins = {"START": 0.0, "CENTER": -0.5, "END": -1.0}[position]
        self._middle = sum(self._frame) + (begins + 0.5) * self._length

    def set_moment(self, moment):
        """Evaluates the scene at a moment, in lengths of the shutter from its middle."""
        whole = math.floor(self._middle + moment * self._length)
        self._set_frame(whole, self._middle + moment * self._length - whole)

    def set_back(self):
        """Evaluates the scene at its frame."""
        self._set_frame(*self._frame)


def position_owner(scene):
    """Returns whose motion_blur_position says when the shutter is open; None: nobody's."""
    owners = scene.render, getattr(scene, "cycles", None)  # Blender 4.2 and later; before
    return next((x for x in owners if hasattr(x, "motion_blur_position")), None)


def motion_losses(scene):
    """Yields what hipmap does not render of a scene's motion blur, one line each."""
    curve = scene.render.motion_blur_shutter_curve
    if any(point.location[1] < 1 for point in curve.curves[0].points):
        yield "the shutter curve is not rendered: the shutter opens and closes at once"
    if getattr(getattr(scene, "cycles", None), "rolling_shutter_type", "NONE") != "NONE":
        yield "a rolling shutter is not rendered: all rows have the same time"


def _wants(item, name):
    """Whether a switch of an object's motion blur in Cycles is on."""
    return getattr(getattr(item, "cycles", None), name, True)


@dataclass
class _Track:
    """A node of the file and its matrices to glTF's world."""

    index: int
    mesh: int  # its number in the file; None: it has none
    name: str
    matrices: dict  # by moment


@dataclass
class _Shape:
    """A mesh of the file that modifiers or shape keys deform."""

    mesh: dict
    counts: tuple  # of vertices and corners
    parts: list  # of Part
    moved: dict = field(default_factory=dict)  # moment: for each part positions, normals


class MotionWriter:
    """Collects what moves of an export under way, and adds it to the file as an animation.
    losses: lines on what is not rendered."""

    def __init__(self, scene):
        self._scene = scene
        self._tracks = {}  # by instance
        self._shapes = {}  # by the mesh's number in the file
        self.losses = []

    def follow(self, key, item, matrix, index, mesh=None):
        """Follows an object from the middle moment on.  key: as instance_key; index, mesh: the
        numbers of its node and its mesh in the file."""
        if _wants(item, "use_motion_blur"):
            self._tracks[key] = _Track(index, mesh, item.name, {0.0: in_gltf_axes(matrix)})

    def follow_shape(self, number, item, mesh, counts, parts):
        """Follows the shape of an object's mesh, which has this number and entry in the file.
        counts: of MeshArrays."""
        if item.is_deform_modified(self._scene, "RENDER") and _wants(item, "use_motion_blur") \
                and _wants(item, "use_deform_motion"):
            self._shapes[number] = _Shape(mesh, counts, parts)

    def note(self, key, item, matrix, moment):
        """Notes where a followed object is at another moment, and its shape."""
        track = self._tracks.get(key)
        if track is None:
            return
        track.matrices[moment] = in_gltf_axes(matrix)
        shape = self._shapes.get(track.mesh)
        if shape is not None and moment not in shape.moved:
            self._note_shape(shape, item, moment)

    def _note_shape(self, shape, item, moment):
        shape.moved[moment] = None  # another shape altogether
        mesh = item.to_mesh()
        if mesh is None:
            return
        try:
            arrays = MeshArrays(mesh)
            if arrays.counts == shape.counts:
                shape.moved[moment] = [arrays.again(part) for part in shape.parts]
        finally:
            item.to_mesh_clear()

    def write(self, glb):
        """Adds the animation to a GlbBuilder.  Returns what tells the motion of its meshes from
        another one; None: nothing moves, and the file stays as it is."""
        self._times = None
        self._animation = {"channels": [], "samplers": []}
        weights = {number: self._write_shape(glb, shape) for number, shape in self._shapes.items()}
        told = []
        for track in self._tracks.values():
            keys = self._write_track(glb, track)
            if track.mesh is not None:  # cameras and lights have no faces
                told.append(keys)
            sampler = weights.get(track.mesh)
            if sampler is not None:
                self._add_channel(track.index, "weights", sampler)
        if not self._animation["channels"]:
            return None
        glb.add("animations", self._animation)
        shapes = [(number, [[array.tobytes() for pair in moved for array in pair]
                            for moved in shape.moved.values()])
                  for number, shape in self._shapes.items() if weights[number] is not None]
        return repr((told, shapes))

    def _write_track(self, glb, track):
        if len(track.matrices) < len(_MOMENTS):  # it comes or goes, as a particle does
            return None
        matrices = [track.matrices[moment] for moment in _MOMENTS]
        if all(matrix == matrices[0] for matrix in matrices):
            return None
        parts = [matrix.decompose() for matrix in matrices]
        if any(_shear(matrix, part) > _LEAST_SHEAR for matrix, part in zip(matrices, parts)):
            self.losses.append(f"object '{track.name}': it is sheared, so its motion is not "
                               "rendered; apply the scale of its parents")
            return None
        values = [numpy.array([_numbers(part[i]) for part in parts], numpy.float32)
                  for i in range(3)]
        node = glb.json["nodes"][track.index]
        del node["matrix"]
        for path, keys in zip(("translation", "rotation", "scale"), values):
            node[path] = keys[_MOMENTS.index(0.0)].tolist()
            if not _stay(path, keys):
                self._add_channel(track.index, path, self._add_sampler(glb, keys))
        return [keys.tolist() for keys in values]

    def _write_shape(self, glb, shape):
        """Adds a morph target for each moment, whose weight is 1 then.  Returns the sampler of the
        weights; None: the shape stays as it is."""
        if None in shape.moved.values():
            self.losses.append(f"mesh '{shape.mesh['name']}': its faces change while the shutter "
                               "is open: its change of shape is not blurred")
        if len(shape.moved) < len(_OTHERS) or None in shape.moved.values() or \
                not any(_differs(shape, moment) for moment in _OTHERS):
            return None
        for at, (part, primitive) in enumerate(zip(shape.parts, shape.mesh["primitives"])):
            primitive["targets"] = [_target(glb, part, *shape.moved[moment][at])
                                    for moment in _OTHERS]
        weights = numpy.array([[moment == other for other in _OTHERS] for moment in _MOMENTS])
        return self._add_sampler(glb, weights.astype(numpy.float32).reshape(-1))

    def _add_sampler(self, glb, keys):
        if self._times is None:
            self._times = glb.add_array(_TIMES[:, None], bounds=True)
        self._animation["samplers"].append({"input": self._times, "output": glb.add_array(keys)})
        return len(self._animation["samplers"]) - 1

    def _add_channel(self, node, path, sampler):
        self._animation["channels"].append({"sampler": sampler,
                                            "target": {"node": node, "path": path}})


def _numbers(part):
    """Three numbers of a vector, or x, y, z, w of a rotation."""
    return (part.x, part.y, part.z, part.w) if len(part) == 4 else tuple(part)


def _shear(matrix, parts):
    """How far a matrix is from its translation, rotation and scale, as a share of itself."""
    translation, rotation, scale = parts
    again = Matrix.Translation(translation) @ rotation.to_matrix().to_4x4() @ \
        Matrix.Diagonal((*scale, 1))
    size = max(abs(x) for row in matrix.to_3x3() for x in row)
    return max(abs(a - b) for rows in zip(matrix.to_3x3(), again.to_3x3())
               for a, b in zip(*rows)) / (size or 1)


def _stay(path, keys):
    """Whether keys are all the same; a turn leaves a scale that differs in its last bits."""
    return numpy.allclose(keys, keys[0], rtol=1e-6 if path == "scale" else 0, atol=0)


def _target(glb, part, positions, normals):
    """A morph target that moves a Part there."""
    return {"POSITION": glb.add_array(positions - part.positions, bounds=True),
            "NORMAL": glb.add_array(normals - part.normals)}


def _differs(shape, moment):
    return any((positions != part.positions).any()
               for part, (positions, _) in zip(shape.parts, shape.moved[moment]))


def instance_key(instance):
    """What tells an instance of the evaluated scene from others, at any moment."""
    parent = instance.parent.name_full if instance.is_instance and instance.parent else ""
    return instance.object.name_full, parent, tuple(instance.persistent_id)


def collect_motion(shutter, depsgraph, motion, camera):
    """Looks at everything that `motion` follows at all moments but the middle one.  Evaluates the
    scene at each.  camera: its object, followed under the key None."""
    for moment in _OTHERS:
        shutter.set_moment(moment)
        seen = camera.evaluated_get(depsgraph)
        motion.note(None, seen, seen.matrix_world, moment)
        for instance in depsgraph.object_instances:
            if instance.show_self:
                motion.note(instance_key(instance), instance.object, instance.matrix_world, moment)
