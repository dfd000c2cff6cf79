# SPDX-License-Identifier: GPL-3.0-or-later
"""The evaluated scene of a 3D viewport, which is exported once and written for any camera."""

import math
from dataclasses import dataclass

from .glb_file import write_glb
from .scene_export import SceneWriter
from .world import prepare_bake


@dataclass(frozen=True)
class ViewportScene:
    """An exported scene without a camera.  Uses nothing of Blender."""

    gltf: dict
    buffer: bytes
    geometry: str  # as in ExportedScene
    bakes: list  # of environment maps that are yet to be made
    options: tuple  # of the programs
    partition_options: tuple
    passes: int

    def same_picture(self, other):
        """Whether another scene has the same pictures."""
        return (other is not None and self.gltf == other.gltf and self.buffer == other.buffer and
                (self.options, self.partition_options, self.passes) ==
                (other.options, other.partition_options, other.passes))

    def write(self, path, view):
        """Writes the .glb with the camera of a View."""
        root = len(self.gltf["nodes"])
        node = {"name": "Viewport", "camera": 0, "matrix": list(view.matrix),
                "extras": {"hipmap": dict(view.extras)}}
        scene = self.gltf["scenes"][0]
        write_glb(path, {**self.gltf, "cameras": [view.camera()],
                         "nodes": [*self.gltf["nodes"], node],
                         "scenes": [{**scene, "nodes": [*scene["nodes"], root]}]}, self.buffer)


def _is_shown(instance, space):
    """Whether the viewport shows an instance, for instance in its local view."""
    owner = instance.parent if instance.is_instance else instance.object
    return instance.show_self and (space is None or owner is None or
                                   owner.visible_in_viewport_get(space))


def export_viewport(depsgraph, folder, space=None):
    """Returns the ViewportScene of an evaluated scene.  To be called where Blender's data may be
    read.  folder: of files beside the scene; space: the 3D viewport, None: what all of them show.
    Cost and errors as for export_depsgraph."""
    scene = depsgraph.scene
    writer = SceneWriter(folder)
    for instance in depsgraph.object_instances:
        if _is_shown(instance, space):
            writer.add(instance)
    bakes = []
    writer.add_world(scene.world,
                     lambda world, path: bakes.append(prepare_bake(world, path)))
    settings = scene.hipmap
    options = ("--seed", str(settings.seed), "--threads", str(settings.threads))
    angle = ("--angle", f"{round(math.degrees(settings.angle), 4):g}")
    writer.glb.json.setdefault("nodes", [])
    gltf, buffer = writer.glb.finish()
    return ViewportScene(gltf, buffer, writer.hash.hexdigest(), bakes, options, angle,
                         settings.preview_passes)
