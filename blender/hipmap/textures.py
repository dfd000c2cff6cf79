# SPDX-License-Identifier: GPL-3.0-or-later
"""Images of glTF: the file as it is where glTF takes it, else a PNG of its pixels."""

import math
import os
import struct
import zlib

import bpy
import numpy

_REPEAT, _CLAMP, _MIRROR = 10497, 33071, 33648
_WRAPS = {"REPEAT": _REPEAT, "EXTEND": _CLAMP, "MIRROR": _MIRROR}
_NEAREST, _LINEAR = 9728, 9729
_MIME = {b"\x89PNG": "image/png", b"\xff\xd8\xff": "image/jpeg"}
_CHANNELS = {"R": 0, "G": 1, "B": 2, "A": 3}
_FAST = 1


def encode_png(pixels):
    """Returns a PNG of 8-bit pixels [height, width, 3 or 4], first row on top."""
    height, width, channels = pixels.shape
    rows = numpy.zeros((height, 1 + width * channels), numpy.uint8)
    rows[:, 1:] = pixels.reshape(height, -1)

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    head = struct.pack(">IIBBBBB", width, height, 8, 2 if channels == 3 else 6, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
            chunk(b"IDAT", zlib.compress(rows.tobytes(), _FAST)) + chunk(b"IEND", b""))


def _to_srgb(linear):
    linear = numpy.clip(linear, 0, 1)
    return numpy.where(linear <= 0.0031308, 12.92 * linear,
                       1.055 * numpy.power(linear, 1 / 2.4) - 0.055)


def _to_linear(encoded):
    return numpy.where(encoded <= 0.04045, encoded / 12.92,
                       numpy.power((encoded + 0.055) / 1.055, 2.4))


def _is_encoded(image):
    """Whether the pixels that Blender hands out are sRGB: of 8-bit images they are as stored."""
    return image.colorspace_settings.name == "sRGB" and not image.is_float


def _pixels(texture, as_srgb):
    """[height, width, 4] of a texture, first row on top, sRGB or linear."""
    image = texture.image
    width, height = image.size
    flat = numpy.empty(width * height * 4, numpy.float32)
    image.pixels.foreach_get(flat)
    pixels = flat.reshape(height, width, 4)[::-1].copy()
    encoded = _is_encoded(image)
    if texture.changes and encoded:
        pixels[:, :, :3], encoded = _to_linear(pixels[:, :, :3]), False
    for change in texture.changes:
        pixels[:, :, :3] = change(pixels[:, :, :3].reshape(-1, 3)).reshape(height, width, 3)
    if encoded != as_srgb:
        pixels[:, :, :3] = (_to_srgb if as_srgb else _to_linear)(pixels[:, :, :3])
    return pixels


def _stored_file(image):
    """The bytes of an image's PNG or JPEG; None: it has none, or was painted on."""
    if image.is_dirty or image.source != "FILE":
        return None
    if image.packed_file:
        return bytes(image.packed_file.data)
    path = bpy.path.abspath(image.filepath, library=image.library)
    if not os.path.isfile(path):
        return None
    with open(path, "rb") as file:
        return file.read()


def _identity(texture):
    """What tells one set of pixels from another."""
    return texture.image.name_full, texture.changes


def _raw(texture, as_srgb):
    """(bytes, MIME type) of an image that glTF takes as it is; None: it does not."""
    image = texture.image
    if texture.changes or (image.colorspace_settings.name == "sRGB") != as_srgb:
        return None
    data = _stored_file(image)
    kind = next((mime for magic, mime in _MIME.items() if data and data.startswith(magic)), None)
    return (data, kind) if kind else None


class TextureWriter:
    """Adds textures to a GlbBuilder; each image once."""

    def __init__(self, glb):
        self._glb = glb
        self._images = {}
        self._textures = {}
        self._samplers = {}

    def whole(self, texture, as_srgb):
        """Returns the texture info of an image as it is, alpha included."""
        return self._info(texture, ("whole", _identity(texture), as_srgb),
                          lambda: _raw(texture, as_srgb) or
                          (encode_png(_bytes(_pixels(texture, as_srgb))), "image/png"))

    def opaque(self, texture, as_srgb):
        """Returns the texture info of an image without its alpha."""
        return self._info(texture, ("opaque", _identity(texture), as_srgb),
                          lambda: (encode_png(_bytes(_pixels(texture, as_srgb)[:, :, :3])),
                                   "image/png"))

    def packed(self, channels, as_srgb=False):
        """Returns the texture info of an image whose channels come from textures.  channels: four
        textures or None, which is 1; red, green and blue of the first where it is a colour.  All
        have the place of the first that is there.  Throws ValueError if their sizes differ."""
        present = [texture for texture in channels if texture is not None]
        if len({tuple(texture.image.size) for texture in present}) > 1:
            raise ValueError("images of two sizes in one texture")
        key = tuple((_identity(x), x.channel) if x else None for x in channels)
        return self._info(present[0], (key, as_srgb),
                          lambda: (encode_png(_pack(channels, as_srgb)), "image/png"))

    def _info(self, texture, key, make):
        if key not in self._images:
            data, mime = make()
            self._images[key] = self._glb.add("images", {
                "name": texture.image.name, "mimeType": mime,
                "bufferView": self._glb.add_bytes(data)})
        sampler = self._sampler(texture)
        pair = (self._images[key], sampler)
        if pair not in self._textures:
            self._textures[pair] = self._glb.add("textures",
                                                 {"source": pair[0], "sampler": sampler})
        info = {"index": self._textures[pair]}
        if texture.transform is not None:
            self._glb.use_extension("KHR_texture_transform")
            info["extensions"] = {"KHR_texture_transform": _gltf_transform(texture.transform)}
        return info

    def _sampler(self, texture):
        wrap, filtering = _WRAPS[texture.wrap], _NEAREST if texture.nearest else _LINEAR
        if (wrap, filtering) not in self._samplers:
            self._samplers[wrap, filtering] = self._glb.add("samplers", {
                "wrapS": wrap, "wrapT": wrap, "magFilter": filtering, "minFilter": filtering})
        return self._samplers[wrap, filtering]


def _bytes(pixels):
    return (numpy.clip(pixels, 0, 1) * 255 + 0.5).astype(numpy.uint8)


def _pack(channels, as_srgb):
    size = next(x.image.size for x in channels if x is not None)
    out = numpy.ones((size[1], size[0], 4), numpy.float32)
    for at, texture in enumerate(channels):
        if texture is None:
            continue
        pixels = _pixels(texture, as_srgb and texture.channel == "COLOR")
        if texture.channel == "COLOR" and at == 0:
            out[:, :, :3] = pixels[:, :, :3]
        elif texture.channel == "COLOR":  # Blender turns a colour into a number by its luminance
            out[:, :, at] = pixels[:, :, :3] @ numpy.array([0.2126, 0.7152, 0.0722], "f4")
        else:
            out[:, :, at] = pixels[:, :, _CHANNELS[texture.channel]]
    return _bytes(out)


def _gltf_transform(transform):
    """KHR_texture_transform of a Mapping node: Blender turns about the origin with v upwards, glTF
    with v downwards, u' = offset + turned (scale uv)."""
    x, y, angle, scale_u, scale_v = transform
    # In Blender (u', v') = R(angle) (su u, sv v) + (x, y); v = 1 - w with w downwards.
    offset_u = x - math.sin(angle) * scale_v
    offset_w = 1 - y - math.cos(angle) * scale_v
    return {"offset": [offset_u, offset_w], "rotation": angle, "scale": [scale_u, scale_v]}
