# SPDX-License-Identifier: GPL-3.0-or-later
"""What one render of Blender asks of hipmap's programs: files and command lines."""

import json
import math
import os
from dataclasses import dataclass, field

import bpy

from .frame import picture_of
from .motion import FRAME_OPTIONS, FRAME_SUFFIX, SHUTTER_OPTIONS
from .passes import asked_passes
from .properties import programs_folder
from .run import find_tool
from .scene_export import SceneError, export_depsgraph


@dataclass
class Job:
    """One render, with everything that it needs of Blender's data."""

    folder: str
    preprocess: str  # the programs
    render: str
    picture: object
    options: list  # of `render`
    partition_options: list
    partition_key: str  # of the faces and the options: what the partition must be of
    keep_passes: bool
    proceed: bool
    passes: int  # to add; 0: another rule ends the render
    state: str = "scene.state"  # name of the file of its passes
    moves: bool = False  # whether the file has motion, which is rendered as one frame
    losses: list = field(default_factory=list)
    scene: str = ""  # names
    view_layer: str = ""
    passes_asked: list = field(default_factory=list)  # render passes besides Combined
    numbers: dict = field(default_factory=dict)  # pass indices, by pass: in the order of the file

    def path(self, name):
        """The path of one of the job's files."""
        return os.path.join(self.folder, name)

    def made(self, name):
        """The path of the file that a program writes where it is given this name: with motion it adds
        the number of the frame."""
        stem, suffix = os.path.splitext(name)
        return self.path(stem + FRAME_SUFFIX + suffix if self.moves else name)


def folder_of(scene, view_layer):
    """Returns the folder of a view layer's files, which it makes.  Throws SceneError if it cannot be made."""
    chosen = bpy.path.abspath(scene.hipmap.folder)
    base = chosen or os.path.join(bpy.app.tempdir, "hipmap")
    folder = os.path.join(base, bpy.path.clean_name(f"{scene.name}_{view_layer.name}"))
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise SceneError(f"{folder}: {error.strerror}: set another folder in Render Properties > "
                         "Running") from error
    return folder


def _render_options(settings, picture):
    options = ["--size", f"{picture.part_width}x{picture.part_height}",
               "--integrator", settings.integrator, "--samples", str(settings.samples),
               "--seed", str(settings.seed), "--threads", str(settings.threads)]
    if settings.photons > 0:
        options += ["--photons", str(settings.photons)]
    if not settings.remove_fireflies:
        options += ["--fireflies", "keep"]
    return options


def _stop_options(settings, quote):
    options = ["--quote"] if quote else []
    if settings.stop_at == "ERROR":
        options += ["--error", f"{settings.error:g}%"]
    if settings.stop_at == "TIME" and not quote:
        options += ["--time", f"{settings.seconds:g}"]
    return options


def _state_name(scene, engine):
    """Frames of an animation keep their passes each if they are to be continued."""
    if engine.is_animation and scene.hipmap.proceed:
        return f"scene_{scene.frame_current:04}.state"
    return "scene.state"


def make_job(context, depsgraph, engine, quote=False):
    """Exports the evaluated scene, and returns the Job of rendering it.  engine: the RenderEngine.
    quote: renders a few passes, adds them to those that are kept, and lists costs.  To be called
    where Blender's data may be read.  Throws SceneError, WorldError, ToolError or Cancelled."""
    scene = depsgraph.scene
    settings = scene.hipmap
    programs = programs_folder(context)
    tools = {name: find_tool(name, programs) for name in ("preprocess", "render")}
    picture = picture_of(scene.render)
    folder = folder_of(scene, depsgraph.view_layer)
    exported = export_depsgraph(depsgraph, os.path.join(folder, "scene.glb"), picture, engine)
    partition_options = ["--angle", f"{round(math.degrees(settings.angle), 4):g}"]
    passes_asked = asked_passes(depsgraph.view_layer)
    names = [one.name for one in passes_asked]
    numbers = {name: found for name, found in exported.numbers.items() if name in names}
    return Job(folder, tools["preprocess"], tools["render"], picture,
               _render_options(settings, picture) + _stop_options(settings, quote),
               partition_options,
               exported.geometry + " ".join(partition_options), settings.keep_passes,
               settings.keep_passes and (settings.proceed or quote),
               settings.passes if settings.stop_at == "PASSES" and not quote else 0,
               _state_name(scene, engine), exported.moves, exported.losses,
               scene.name, depsgraph.view_layer.name, passes_asked, numbers)


def remove_leftovers(job):
    """Removes what programs left that were killed while they wrote."""
    for name in os.listdir(job.folder):
        if name.startswith(".hipmap-") and name.endswith(".tmp"):
            os.remove(job.path(name))


def read_notes(folder):
    """What is known of the files of earlier renders in a job's folder."""
    try:
        with open(os.path.join(folder, "notes.json"), encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return {}


def write_notes(job, **values):
    """Adds to what is known of the files."""
    notes = {**read_notes(job.folder), **values}
    with open(job.path("notes.json"), "w", encoding="utf-8") as file:
        json.dump(notes, file)


def note_passes(job, passes):
    """Notes how many passes the job's state has."""
    write_notes(job, passes={**_noted_passes(job), job.state: passes})


def _noted_passes(job):
    """Passes by the names of states."""
    noted = read_notes(job.folder).get("passes")
    return noted if isinstance(noted, dict) else {}


def forget_passes(job):
    """Removes the job's passes; also those of all frames, unless renders are to be continued."""
    note_passes(job, 0)
    paths = {job.path(job.state), job.made(job.state)}
    if not job.proceed:
        paths.update(job.path(name) for name in os.listdir(job.folder)
                     if name.startswith("scene_") and name.endswith(".state"))
    for path in filter(os.path.exists, paths):
        os.remove(path)


def has_partition(job):
    """Whether the partition of an earlier render is of these faces and options."""
    return (read_notes(job.folder).get("partition") == job.partition_key and
            os.path.isfile(job.made("scene.hpm")))


def preprocess_command(job):
    """The command line that makes the partition."""
    return [job.preprocess, job.path("scene.glb"), "-o", job.path("scene.hpm"),
            *job.partition_options, *_thread_options(job),
            *(FRAME_OPTIONS if job.moves else ())]


def render_frame_options(moves):
    """Options with which `render` blurs a file that moves."""
    return (*FRAME_OPTIONS, *SHUTTER_OPTIONS) if moves else ()


def _thread_options(job):
    at = job.options.index("--threads")
    return job.options[at:at + 2]


def render_command(job):
    """The command line that renders."""
    has_passes = job.proceed and os.path.isfile(job.made(job.state))
    before = _noted_passes(job).get(job.state, 0) if has_passes else 0
    ending = ["--passes", str(before + job.passes)] if job.passes else []
    keeping = ["--state", job.path(job.state)] if job.keep_passes else []
    return [job.render, job.path("scene.glb"), job.path("scene.hpm"), "-o", job.path("scene.pfm"),
            "--progress", "json", *keeping, *_layer_options(job), *job.options, *ending,
            *render_frame_options(job.moves)]


def _layer_options(job):
    if not job.passes_asked:
        return []
    names = ["combined", *(one.layer for one in job.passes_asked)]
    return ["--layers", job.path("layers.exr"), "--layer-names", ",".join(names),
            "--view-layer", job.view_layer]
