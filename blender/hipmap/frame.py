# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture that Blender asks for: its size and the part of the camera's view that it shows."""

from dataclasses import dataclass

import numpy


@dataclass(frozen=True)
class Picture:
    """Pixels of the whole picture and of the part to render, from the bottom left."""

    width: int
    height: int
    left: int
    bottom: int
    part_width: int
    part_height: int
    pixel_aspect: float  # width of a pixel over its height

    @property
    def is_whole(self):
        """Whether the part is the whole picture."""
        return (self.part_width, self.part_height) == (self.width, self.height)


def _edge(share, pixels):
    """The pixel at a share of the picture, rounded as Blender does it in 32 bits."""
    return int(numpy.float32(share) * numpy.float32(pixels))


def picture_of(render):
    """Returns the Picture of a scene's render settings."""
    width = max(render.resolution_x * render.resolution_percentage // 100, 1)
    height = max(render.resolution_y * render.resolution_percentage // 100, 1)
    aspect = render.pixel_aspect_x / render.pixel_aspect_y
    if not render.use_border:
        return Picture(width, height, 0, 0, width, height, aspect)
    left, bottom = _edge(render.border_min_x, width), _edge(render.border_min_y, height)
    right, top = _edge(render.border_max_x, width), _edge(render.border_max_y, height)
    return Picture(width, height, left, bottom, max(right - left, 1), max(top - bottom, 1), aspect)


def middle_of_part(picture):
    """Returns how far the middle of the part is right of and above the middle of the picture, in
    pixels."""
    return (picture.left + 0.5 * (picture.part_width - picture.width),
            picture.bottom + 0.5 * (picture.part_height - picture.height))
