# SPDX-License-Identifier: GPL-3.0-or-later
"""A button that says what smaller errors would cost: a render of a few passes, which are kept."""

import re

import bpy

_ROW = re.compile(r"([\d.]+ %) error (?:would take about ([\d,]+ pass(?:es)?), (.+?)"
                  r"(?:, [\d,]+ light paths)?|is (not practical.*))$")
_SECONDS_BETWEEN_LOOKS = 0.2

_costs = {}  # by the name of a scene


class _Asked:
    """Whether the render that begins is to end with the costs."""

    now = False


def is_asked():
    """Whether the render under way is one of the button."""
    return _Asked.now


def read_costs(messages):
    """Returns rows (error, passes, time) of what `render --quote` printed.  Of errors that take the
    same passes only the smallest is there."""
    rows = []
    for line in messages:
        found = _ROW.match(line)
        if not found:
            continue
        error, passes, time, never = found.groups()
        row = (error, "", never) if never else (error, passes, time)
        if rows and row[1] and rows[-1][1] == row[1]:
            rows.pop()
        rows.append(row)
    return rows


def keep_costs(scene, messages):
    """Keeps the costs for the panel.  scene: its name."""
    _costs[scene] = read_costs(messages)


def draw_costs(layout, scene):
    """Shows the costs of a scene in a panel."""
    if not _costs.get(scene.name):
        return
    box = layout.box().column(align=True)
    for error, passes, time in [("Error", "", "Time"), *_costs[scene.name]]:
        line = box.split(factor=0.3)
        line.label(text=error)
        line.label(text=f"{time}, {passes}" if passes else time)


def _set_render_display(context, value):
    """Chooses where Blender shows a render.  Returns what was chosen."""
    view = context.preferences.view
    before, view.render_display_type = view.render_display_type, value
    return before


class RENDER_OT_hipmap_quote(bpy.types.Operator):
    """Renders a few passes and lists costs."""

    bl_idname = "render.hipmap_quote"
    bl_label = "How Long for 1 %?"
    bl_description = ("Render a few passes in the background and list what smaller errors would "
                      "take. Esc cancels it. The passes are kept: Continue adds to them")

    _timer = None
    _display = ""
    _over = False

    def execute(self, context):
        """Renders while Blender waits."""
        _Asked.now = True
        try:
            bpy.ops.render.render()
        finally:
            _Asked.now = False
        return {"FINISHED"}

    def invoke(self, context, _event):
        """Starts the render, as F12 does but without a window of its own."""
        if _Asked.now:
            self.report({"WARNING"}, "a render is under way")
            return {"CANCELLED"}
        _Asked.now = True
        self._display = _set_render_display(context, "NONE")
        for handlers in self._handlers():
            handlers.append(self._note_end)
        if "RUNNING_MODAL" not in bpy.ops.render.render("INVOKE_DEFAULT"):
            self._finish(context)
            return {"CANCELLED"}
        manager = context.window_manager
        self._timer = manager.event_timer_add(_SECONDS_BETWEEN_LOOKS, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, _event):
        """Waits for the end of the render."""
        if not self._over:
            return {"PASS_THROUGH"}
        self._finish(context)
        return {"FINISHED"}

    @staticmethod
    def _handlers():
        return bpy.app.handlers.render_complete, bpy.app.handlers.render_cancel

    def _note_end(self, *_):
        self._over = True

    def _finish(self, context):
        _Asked.now = False
        _set_render_display(context, self._display)
        for handlers in self._handlers():
            handlers.remove(self._note_end)
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
        for window in context.window_manager.windows:
            for area in window.screen.areas:
                if area.type == "PROPERTIES":
                    area.tag_redraw()


def register():
    """Adds the operator."""
    bpy.utils.register_class(RENDER_OT_hipmap_quote)


def unregister():
    """Removes the operator."""
    bpy.utils.unregister_class(RENDER_OT_hipmap_quote)
