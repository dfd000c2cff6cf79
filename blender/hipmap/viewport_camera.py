# SPDX-License-Identifier: GPL-3.0-or-later
"""What a 3D viewport shows: a camera of glTF, and the pixels to render."""

import math
from dataclasses import dataclass

from mathutils import Matrix, Vector

from .cameras import camera_extras
from .scene_export import matrix_numbers

_WHOLE = (0.0, 0.0, 1.0, 1.0)
_FACTORS = (1, 2, 4, 8, 16)
# Few enough pixels that the first pass of a simple scene is there within about a second.
_PIXELS_AT_ONCE = 250_000


@dataclass(frozen=True)
class View:
    """A camera and its picture.  Equal views have equal pictures of the same scene."""

    entry: tuple  # of the glTF camera: type, and pairs of its values
    extras: tuple  # pairs
    matrix: tuple  # 16 numbers, to the world of glTF
    size: tuple  # pixels to render
    part: tuple  # left, bottom, right, top as shares of the region

    def camera(self):
        """The entry of the glTF camera."""
        kind, values = self.entry
        return {"name": "Viewport", "type": kind, kind: dict(values)}


def _frustum(window, part):
    """Half the width and height, and the centre, of a part of what a projection matrix shows: at
    distance 1, or in metres for an orthographic one."""
    perspective = window[3][3] == 0
    half = (1 / window[0][0], 1 / window[1][1])
    sign = 1 if perspective else -1
    column = 2 if perspective else 3
    left, bottom, right, top = part
    sides = []
    for axis, (low, high) in enumerate(((left, right), (bottom, top))):
        middle = sign * window[axis][column] + low + high - 1
        sides.append((half[axis] * (high - low), half[axis] * middle))
    return perspective, sides


def _extras(sides):
    (_, right), (half_height, up) = sides
    return {"shift_right": right / (2 * half_height), "shift_up": up / (2 * half_height)}


def make_view(window, view, clip, size, part=_WHOLE, lens=None):
    """Returns the View of a region.  window, view: its projection and view matrix; clip: nearest
    and greatest distance, m; size: pixels of the part; lens: more custom properties of the
    camera."""
    perspective, sides = _frustum(window, part)
    (half_width, _), (half_height, _) = sides
    matrix = view.inverted()
    near, far = clip
    if perspective:
        entry = ("perspective", (("yfov", 2 * math.atan(half_height)),
                                 ("aspectRatio", half_width / half_height),
                                 ("znear", near), ("zfar", far)))
    else:
        if near < 0:  # it also shows what is behind its place, which glTF has no number for
            matrix = matrix @ Matrix.Translation((0, 0, -near))
            near, far = 0.0, far - near
        entry = ("orthographic", (("xmag", half_width), ("ymag", half_height),
                                  ("znear", near), ("zfar", far)))
    extras = {**_extras(sides), **(lens or {})}
    return View(entry, tuple(extras.items()), tuple(matrix_numbers(matrix)), size, part)


def _camera_part(scene, camera, region_3d):
    """The render region within the camera's frame, as shares of the region."""
    corners = [region_3d.perspective_matrix @ (camera.matrix_world @ corner).to_4d()
               for corner in camera.data.view_frame(scene=scene)]
    shares = [(0.5 + 0.5 * c.x / c.w, 0.5 + 0.5 * c.y / c.w) for c in corners]
    low = Vector(map(min, zip(*shares)))
    side = Vector(map(max, zip(*shares))) - low
    render = scene.render
    return (low.x + side.x * render.border_min_x, low.y + side.y * render.border_min_y,
            low.x + side.x * render.border_max_x, low.y + side.y * render.border_max_y)


def _part(scene, space, region_3d, camera):
    if camera is not None:
        part = _camera_part(scene, camera, region_3d) if scene.render.use_border else _WHOLE
    elif space.use_render_border:
        part = (space.render_border_min_x, space.render_border_min_y,
                space.render_border_max_x, space.render_border_max_y)
    else:
        part = _WHOLE
    return tuple(min(max(share, 0.0), 1.0) for share in part)


def _factor(render, pixels):
    """How many pixels of the screen a rendered one covers in each direction."""
    if render.preview_pixel_size != "AUTO":
        return int(render.preview_pixel_size)
    return next((f for f in _FACTORS if pixels / (f * f) <= _PIXELS_AT_ONCE), _FACTORS[-1])


def _clip(space, region_3d, camera):
    if camera is not None:
        return camera.data.clip_start, camera.data.clip_end
    if region_3d.view_perspective == "ORTHO":  # Blender's own rule
        return -space.clip_end / 2, space.clip_end / 2
    return space.clip_start, space.clip_end


def view_of(context, depsgraph):
    """Returns the View of the region that is drawn; None: nothing of it is to be rendered, or its
    camera is panoramic."""
    scene, region, region_3d = depsgraph.scene, context.region, context.region_data
    space = context.space_data
    camera = None
    if region_3d.view_perspective == "CAMERA" and space.camera is not None:
        camera = space.camera.evaluated_get(depsgraph)
    lens = {}
    if camera is not None and camera.type == "CAMERA":
        if camera.data.type == "PANO":
            return None
        lens = camera_extras(camera, camera.matrix_world)
    elif camera is not None:  # any object may be looked through
        return None
    part = _part(scene, space, region_3d, camera)
    width, height = (part[2] - part[0]) * region.width, (part[3] - part[1]) * region.height
    if width < 1 or height < 1:
        return None
    factor = _factor(scene.render, width * height)
    size = (max(round(width / factor), 1), max(round(height / factor), 1))
    return make_view(region_3d.window_matrix, region_3d.view_matrix,
                     _clip(space, region_3d, camera), size, part, lens)
