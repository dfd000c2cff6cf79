# SPDX-License-Identifier: GPL-3.0-or-later
"""The preview in a 3D viewport whose shading is Rendered."""

import os
import time
import weakref

import bpy

from .preview import Preview, Wish
from .properties import programs_folder
from .run import ToolError, find_tool
from .scene_export import SceneError
from .viewport_camera import view_of
from .viewport_export import export_viewport
from .world import WorldError

_SECONDS_BETWEEN_LOOKS = 0.04
# A scene that changes all the time, as when an object is moved, is exported when it rests so long,
# or as long as the last export took, because Blender waits for an export.
_REST = 0.2
_live = weakref.WeakSet()
_ending = []  # folders and previews that are closed, until their programs have ended


def _forget_ended():
    _ending[:] = [(folder, preview) for folder, preview in _ending if not preview.has_ended()]


def _new_folder():
    """A folder in Blender's temporary one that no other viewport uses; its partition may be there
    from an earlier preview."""
    _forget_ended()
    taken = {viewport.folder for viewport in _live} | {folder for folder, _ in _ending}
    base = os.path.join(bpy.app.tempdir, "hipmap")
    number = next(n for n in range(len(taken) + 1)
                  if os.path.join(base, f"viewport_{n}") not in taken)
    folder = os.path.join(base, f"viewport_{number}")
    os.makedirs(folder, exist_ok=True)
    return folder


class Viewport:
    """The preview of one engine: in one region, until its shading changes."""

    def __init__(self, engine):
        self._engine = weakref.ref(engine)
        self.folder = _new_folder()
        self._preview = None
        self._scene = self._view = self._wish = None
        self._rest = _REST
        self._changed = None  # when the scene has last changed, while that is not yet exported
        self._drawn = self._told = None
        self._texture = None
        self._error = ""
        _live.add(self)

    def update(self, context, depsgraph):
        """Exports the scene: at first, and when changes are over."""
        if self._scene is not None and not self._rested():
            self._changed = time.monotonic()
            return
        self._changed = None
        try:
            self._export(context, depsgraph)
            self._error = ""
        except (SceneError, WorldError, ToolError, OSError) as error:
            self._error = str(error)

    def _rested(self):
        return self._changed is not None and time.monotonic() - self._changed >= self._rest

    def _export(self, context, depsgraph):
        began = time.monotonic()
        scene = export_viewport(depsgraph, self.folder, context.space_data)
        self._rest = max(_REST, time.monotonic() - began)
        if self._preview is None:
            programs = programs_folder(context)
            self._preview = Preview(self.folder, {name: find_tool(name, programs)
                                                  for name in ("preprocess", "render")})
        if not scene.same_picture(self._scene):
            self._scene = scene
            self._ask()

    def draw(self, context, depsgraph):
        """Draws the latest picture."""
        view = view_of(context, depsgraph)
        if view != self._view:
            self._view = view
            self._ask()
        if self._preview is not None and self._preview.shown is not None and view is not None:
            self._draw_picture(self._preview.shown, context.region, depsgraph.scene)

    def _ask(self):
        if self._preview is not None and self._scene is not None and self._view is not None:
            self._wish = Wish(self._scene, self._view)
            self._preview.show(self._wish)

    def _draw_picture(self, shown, region, scene):
        import gpu  # not there in a Blender without a window
        from gpu_extras.presets import draw_texture_2d
        if shown is not self._drawn:
            data = gpu.types.Buffer("FLOAT", shown.pixels.size, shown.pixels.ravel())
            self._texture = gpu.types.GPUTexture((shown.width, shown.height), format="RGBA16F",
                                                 data=data)
            self._drawn = shown
        left, bottom, right, top = shown.wish.view.part
        engine = self._engine()
        # Blender applies the view transform to what is drawn, which is scene linear.
        engine.bind_display_space_shader(scene)
        draw_texture_2d(self._texture, (left * region.width, bottom * region.height),
                        (right - left) * region.width, (top - bottom) * region.height)
        engine.unbind_display_space_shader()

    def look(self):
        """Tells Blender what is new.  Called on the main thread, again and again."""
        engine = self._engine()
        if engine is None:
            return
        if self._rested():
            engine.tag_update()
            engine.tag_redraw()  # Blender updates before it draws
        told = self._state()
        if told != self._told:
            self._told = told
            engine.update_stats("hipmap", told)
            engine.tag_redraw()
        if self._preview is not None and self._preview.shown is not self._drawn:
            engine.tag_redraw()

    def _state(self):
        if self._error:
            return self._error
        if self._view is None:
            return "this camera is not rendered"
        return self._preview.told if self._preview is not None else ""

    def close(self):
        """Ends the preview.  Returns at once."""
        _live.discard(self)
        if self._preview is not None:
            self._preview.close()
            _ending.append((self.folder, self._preview))
            self._preview = None


class ViewportEngine:
    """The part of a render engine that draws 3D viewports."""

    viewport = None

    def view_update(self, context, depsgraph):
        """Called by Blender at first, and after changes of the scene."""
        if self.viewport is None:
            self.viewport = Viewport(self)
            if not bpy.app.timers.is_registered(_look_at_all):
                bpy.app.timers.register(_look_at_all)
        self.viewport.update(context, depsgraph)

    def view_draw(self, context, depsgraph):
        """Called by Blender to draw a region."""
        if self.viewport is not None:
            self.viewport.draw(context, depsgraph)

    def __del__(self):
        """Called when the viewport's shading changes, or Blender ends."""
        if self.viewport is not None:
            self.viewport.close()


def _look_at_all():
    """A timer of Blender.  Returns when to call again; None: no more."""
    for viewport in list(_live):
        try:
            viewport.look()
        except ReferenceError:  # Blender has removed the engine
            viewport.close()
    _forget_ended()
    return _SECONDS_BETWEEN_LOOKS if _live or _ending else None


def register():
    """Nothing to add: the engine has it all."""


def unregister():
    """Ends all previews."""
    for viewport in list(_live):
        viewport.close()
