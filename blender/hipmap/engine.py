# SPDX-License-Identifier: GPL-3.0-or-later
"""The render engine: F12."""

import os
import time

import bpy

from .job import (forget_passes, has_partition, make_job, note_passes, preprocess_command,
                  remove_leftovers, render_command, write_notes)
from .losses import keep_losses
from .passes import Rects, register_passes, renumber
from .quote import is_asked, keep_costs
from .run import Cancelled, Child, ToolError, read_pfm, warnings_of
from .scene_export import SceneError
from .server import end_server, request
from .viewport import ViewportEngine
from .world import WorldError

_SECONDS_BETWEEN_LOOKS = 0.05
_STOPPED_BY_SIGNAL = 3
_BAD_INPUT = 2


_errors = []  # of the frames of the animation under way
_reported = set()  # what is lost of these frames, each told once


def _percent(error):
    return f"{100 * error:.2g} %"


class HipmapEngine(ViewportEngine, bpy.types.RenderEngine):
    """Renders by hipmap's programs, as child processes"""

    bl_idname = "HIPMAP"
    bl_label = "hipmap"
    bl_use_preview = False
    bl_use_eevee_viewport = True
    bl_use_shading_nodes_custom = False

    job = None
    frame = 0
    told = ""
    shown = None  # the Rects of the last file of layers

    def update(self, data=None, depsgraph=None):
        """Exports the scene: the only place where Blender's data may be read."""
        self.job = None
        self.frame = depsgraph.scene.frame_current
        bakes = depsgraph.scene.hipmap.bake
        self._tell_state("baking nodes and exporting the scene" if bakes else
                         "exporting the scene")
        try:
            self.job = make_job(bpy.context, depsgraph, self, is_asked())
        except (SceneError, WorldError, ToolError) as error:
            self._fail(str(error))
            return
        except Cancelled:
            return
        keep_losses(self.job.scene, self.job.losses)
        for line in self.job.losses:
            if line not in _reported:
                self.report({"WARNING"}, line)
        if self.is_animation:
            _reported.update(self.job.losses)

    def update_render_passes(self, scene=None, renderlayer=None):
        """Names the passes of a view layer."""
        register_passes(self, scene, renderlayer)

    def render(self, depsgraph):
        """Runs the programs and shows every pass."""
        if self.job is None:
            return
        layer = depsgraph.view_layer.name
        self.shown = None
        for one in self.job.passes_asked:
            self.add_pass(one.name, len(one.channels), one.channels, layer=layer)
        remove_leftovers(self.job)
        try:
            self._make_partition()
            self._render_passes(layer)
        except ToolError as error:
            self._fail(str(error))
        except Cancelled:
            pass
        self.shown = None

    def _fail(self, line):
        self.report({"ERROR"}, line)
        self.error_set(line)

    def _watch(self, child, on_event):
        """Waits for the end of a Child or a Request.  Returns it, and its exit code.  Throws
        Cancelled."""
        while child.running():
            if self.test_break():
                child.stop()
                remove_leftovers(self.job)
                for event in child.events():
                    on_event(event)
                raise Cancelled
            for event in child.events():
                on_event(event)
            time.sleep(_SECONDS_BETWEEN_LOOKS)
        code = child.finish()
        for event in child.events():
            on_event(event)
        return child, code

    def _make_partition(self, again=False):
        job = self.job
        if has_partition(job) and not again:
            return
        self._tell_state("finding faces that share photons")
        write_notes(job, partition="")
        child, code = self._watch(Child(preprocess_command(job)), lambda event: None)
        if code != 0:
            raise ToolError(child.last_error())
        write_notes(job, partition=job.partition_key, moves=job.moves)

    def _render_passes(self, layer):
        job = self.job
        if not job.proceed:
            forget_passes(job)
        self._tell_state("starting")
        child, code = self._watch(self._start_render(), lambda event: self._show(event, layer))
        if code == _BAD_INPUT and os.path.basename(job.made(job.state)) in child.last_error():
            self.report({"INFO"}, "the scene or its settings have changed: rendering from the "
                                  "first pass")
            forget_passes(job)
            child, code = self._watch(self._start_render(),
                                      lambda event: self._show(event, layer))
        if code not in (0, _STOPPED_BY_SIGNAL):
            raise ToolError(child.last_error())
        self._tell(child.messages)
        if is_asked():
            keep_costs(self.job.scene, child.messages)

    def _start_render(self):
        """Frames of an animation share a program, and the photon maps while only the camera moves."""
        command = render_command(self.job)
        return request(command) if self.is_animation else Child(command)

    def _tell(self, messages):
        for line in warnings_of(messages):
            self.report({"WARNING"}, line)
        for line in messages:
            if line.startswith("cost: ") and not self.is_animation:
                self.report({"INFO"}, line)

    def _show(self, event, layer):
        """Shows what an event tells: progress, a pass, the end."""
        passes = event["passes"]
        parts = [f"{passes} passes" if passes > 1 else "1 pass" if passes else "first pass"]
        if event["error"] is not None:
            parts.append("error " + _percent(event["error"]))
        left = [f"{event['left']:.0f} s left"] if event.get("left") is not None else []
        self._tell_state(", ".join(parts + left))
        if event.get("done") is not None:
            self.update_progress(event["done"])
        images = event.get("images", ())
        if self.job.made("scene.pfm") in images:
            self._show_image(layer)
        if self.job.made("layers.exr") in images:
            self._show_layers(layer)
        if event["event"] == "end":
            note_passes(self.job, event["passes"])
            self._report_end(f"{', '.join(parts)}, {event['seconds']:.1f} s", event["error"])

    def _report_end(self, text, error):
        if self.is_animation:
            text = f"frame {self.frame}: {text}"
            _errors.extend([error] if error is not None else [])
            if len(_errors) > 1:
                text += f"; errors so far {_percent(min(_errors))} to {_percent(max(_errors))}"
        self.report({"INFO"}, text)

    def _tell_state(self, text):
        if text != self.told:
            self.told = text
            self.update_stats("", "hipmap: " + text)

    def _show_image(self, layer):
        pixels, width, height = read_pfm(self.job.made("scene.pfm"))
        result = self.begin_result(0, 0, width, height, layer=layer)
        try:
            rects = self.shown.again(result.layers[0].passes) if self.shown else \
                Rects(result.layers[0].passes, width * height)
            rects.of("Combined")[:] = pixels.ravel()
            rects.write()
        finally:  # a result that is left open crashes Blender
            self.end_result(result)

    def _show_layers(self, layer):
        picture = self.job.picture
        width, height = picture.part_width, picture.part_height
        result = self.begin_result(0, 0, width, height, layer=layer)
        try:
            result.load_from_file(self.job.made("layers.exr"))
            rects = Rects(result.layers[0].passes, width * height)
            rects.read()
            renumber(rects, self.job.numbers)
            rects.write()
            self.shown = rects
        finally:
            self.end_result(result)


@bpy.app.handlers.persistent
def _end_animation(*_arguments):
    end_server()
    _errors.clear()
    _reported.clear()


_ENDS = (bpy.app.handlers.render_complete, bpy.app.handlers.render_cancel)


def register():
    """Adds the engine to Blender's list."""
    bpy.utils.register_class(HipmapEngine)
    for handlers in _ENDS:
        handlers.append(_end_animation)


def unregister():
    """Removes the engine."""
    _end_animation()
    for handlers in _ENDS:
        handlers.remove(_end_animation)
    bpy.utils.unregister_class(HipmapEngine)
