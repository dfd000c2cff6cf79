# SPDX-License-Identifier: GPL-3.0-or-later
"""Materials of glTF from Surfaces."""

from dataclasses import dataclass, field

from .surfaces import TERMS, Surface, material_output, surface_of
from .textures import TextureWriter
from .volumes import medium_of

_NO_MATERIAL = "no material"
_CURE = "Bake Nodes renders it"


@dataclass
class WrittenMaterial:
    """Where a material is in the file, and what it needs of a mesh."""

    index: int
    uv_names: list = field(default_factory=list)  # of TEXCOORD_0 and on
    colour_layer: str = None


class _Entry:
    """One material under way."""

    def __init__(self, glb, textures, surface):
        self.glb, self.textures, self.surface = glb, textures, surface
        self.json, self.uv_names, self.colour_layer = {}, [], None

    def place(self, info, texture):
        """Adds the texture coordinate of a texture to its info."""
        if texture.uv_name not in self.uv_names:
            self.uv_names.append(texture.uv_name)
        index = self.uv_names.index(texture.uv_name)
        return {**info, "texCoord": index} if index else info

    def whole(self, texture, as_srgb=False):
        """Texture info of an image as it is."""
        return self.place(self.textures.whole(texture, as_srgb), texture)

    def extend(self, name, values):
        """Adds an extension to the material."""
        self.glb.use_extension(name)
        self.json.setdefault("extensions", {})[name] = values

    def lose(self, what):
        """Names what is not rendered."""
        self.surface.losses.append(what)


def _clamped(numbers):
    return [min(max(c, 0.0), 1.0) for c in numbers]


def _base_texture(entry, base, alpha):
    """Colour and opacity share an image; an alpha that nothing uses must not be in it."""
    if alpha.texture is None and alpha.value[0] < 1:
        return entry.place(entry.textures.opaque(base.texture, True), base.texture)
    if alpha.texture is None:  # glTF ignores the alpha of an opaque material
        return entry.whole(base.texture, True)
    if base.texture is not None and alpha.texture.image == base.texture.image \
            and not base.texture.changes and not alpha.texture.changes \
            and alpha.texture.channel == "A":
        return entry.whole(base.texture, True)
    texture = base.texture or alpha.texture
    try:
        info = entry.textures.packed([base.texture, None, None, alpha.texture], True)
    except ValueError:
        entry.lose("colour and alpha are images of two sizes: rendered without the image of alpha")
        return entry.place(entry.textures.opaque(base.texture, True), base.texture)
    return entry.place(info, texture)


def _write_base(entry, pbr):
    base, alpha = entry.surface.base, entry.surface.alpha
    opacity = alpha.value[0]
    pbr["baseColorFactor"] = [*_clamped(base.numbers()), *_clamped([opacity])]
    if base.texture is not None or alpha.texture is not None:
        pbr["baseColorTexture"] = _base_texture(entry, base, alpha)
    if opacity < 1 or alpha.texture is not None:
        entry.json["alphaMode"] = "BLEND"
    if base.colour_layer is not None:
        entry.colour_layer = base.colour_layer


def _fits_as_it_is(metallic, roughness):
    """Whether an image holds roughness in green and metal in blue already."""
    both = [t for t in (metallic, roughness) if t is not None]
    return len({(t.image.name_full, t.changes) for t in both}) == 1 and all(
        t is None or t.channel == wanted for t, wanted in ((metallic, "B"), (roughness, "G")))


def _write_roughness(entry, pbr):
    metallic, roughness = entry.surface.metallic, entry.surface.roughness
    pbr["metallicFactor"], = _clamped(metallic.value[:1])
    pbr["roughnessFactor"], = _clamped(roughness.value[:1])
    if metallic.texture is None and roughness.texture is None:
        return
    try:
        if _fits_as_it_is(metallic.texture, roughness.texture):
            info = entry.textures.whole(roughness.texture or metallic.texture, False)
        else:
            info = entry.textures.packed([None, roughness.texture, metallic.texture, None])
    except ValueError:
        entry.lose("roughness and metal are images of two sizes: rendered without that of metal")
        info = entry.textures.packed([None, roughness.texture, None, None])
    pbr["metallicRoughnessTexture"] = entry.place(info, roughness.texture or metallic.texture)


def _channel(entry, source, at):
    """Texture info of a number in channel `at` of a texture; None: it has no texture."""
    if source.texture is None:
        return None
    channels = [None] * 4
    channels[at] = source.texture
    return entry.place(entry.textures.packed(channels), source.texture)


def _write_emission(entry):
    emission = entry.surface.emission
    colour = [max(c, 0.0) for c in emission.value[:3]]
    strength = max(colour, default=0)
    if strength <= 0:
        return
    entry.json["emissiveFactor"] = [c / max(strength, 1) for c in colour]
    if strength > 1:
        entry.extend("KHR_materials_emissive_strength", {"emissiveStrength": strength})
    if emission.texture is not None:
        entry.json["emissiveTexture"] = entry.whole(emission.texture, True)


def _write_transmission(entry):
    surface = entry.surface
    if surface.transmission.value[0] > 0:
        values = {"transmissionFactor": min(surface.transmission.value[0], 1.0)}
        texture = _channel(entry, surface.transmission, 0)
        if texture:
            values["transmissionTexture"] = texture
        entry.extend("KHR_materials_transmission", values)
    if surface.ior != 1.5:
        entry.extend("KHR_materials_ior", {"ior": surface.ior})
    if surface.specular != (1.0, 1.0, 1.0):
        entry.extend("KHR_materials_specular", {"specularColorFactor": list(surface.specular)})
    if surface.diffuse_transmission > 0:
        values = {"diffuseTransmissionFactor": surface.diffuse_transmission,
                  "diffuseTransmissionColorFactor": _clamped(surface.transmitted.numbers())}
        if surface.transmitted.texture is not None:
            values["diffuseTransmissionColorTexture"] = entry.whole(surface.transmitted.texture,
                                                                    True)
        entry.extend("KHR_materials_diffuse_transmission", values)


def _write_layers(entry):
    surface = entry.surface
    if surface.coat.value[0] > 0:
        values = {"clearcoatFactor": min(surface.coat.value[0], 1.0),
                  "clearcoatRoughnessFactor": _clamped(surface.coat_roughness.value[:1])[0]}
        for key, source, at in (("clearcoatTexture", surface.coat, 0),
                                ("clearcoatRoughnessTexture", surface.coat_roughness, 1)):
            texture = _channel(entry, source, at)
            if texture:
                values[key] = texture
        entry.extend("KHR_materials_clearcoat", values)
    if any(surface.sheen):
        entry.extend("KHR_materials_sheen", {"sheenColorFactor": _clamped(surface.sheen),
                                             "sheenRoughnessFactor": surface.sheen_roughness})
    if surface.normal is not None:
        info = {**entry.whole(surface.normal), "scale": surface.normal_scale}
        entry.json["normalTexture"] = info


def _write_volume(entry, material, extras):
    """A closed mesh whose surface transmits, or that has none, holds a medium."""
    output = material_output(material) if material else None
    if output is None:
        return
    medium, losses = medium_of(output.inputs["Volume"])
    entry.surface.losses += losses
    if medium:
        extras["medium"] = medium
    if not output.inputs["Surface"].is_linked and output.inputs["Volume"].is_linked:
        extras["boundary"] = False


def _write_extras(entry, material):
    extras = {}
    if entry.surface.is_lambert:  # Phong's model without its lobe
        extras.update(reflection="phong", exponent=1.0, specular=[0.0, 0.0, 0.0])
    _write_volume(entry, material, extras)
    if extras:
        entry.json["extras"] = {"hipmap": extras}


def _all_losses(surface):
    pending = [getattr(surface, term).loss for term in TERMS] + [surface.normal_loss]
    return [f"{loss} ({_CURE})" for loss in pending if loss] + surface.losses


class MaterialWriter:
    """Adds materials to a GlbBuilder, each once.  losses: lines on what is not rendered."""

    def __init__(self, glb):
        self._glb = glb
        self._textures = TextureWriter(glb)
        self._written = {}
        self.losses = []
        self.numbers = []  # pass indices, by their place in the file

    def write(self, material, baked=None):
        """Returns the WrittenMaterial of a material of Blender; None: a face without one, diffuse
        as in Cycles.  baked: the BakedMesh of the mesh; None: nothing was baked of it."""
        key = material.name_full if material else None
        if baked is not None and baked.has(key):
            key = key, id(baked)
        if key not in self._written:
            self._written[key] = self._write(material, baked)
        return self._written[key]

    def _write(self, material, baked):
        surface = surface_of(material) if material else Surface(is_lambert=True)
        if baked is not None and surface is not None:
            baked.fill(material, surface)
        entry = _Entry(self._glb, self._textures, surface or Surface())
        pbr = {}
        entry.json.update(name=material.name if material else _NO_MATERIAL, doubleSided=True,
                          pbrMetallicRoughness=pbr)
        _write_base(entry, pbr)
        _write_roughness(entry, pbr)
        _write_emission(entry)
        _write_transmission(entry)
        _write_layers(entry)
        _write_extras(entry, material)
        if material:
            self.losses += [f"material '{material.name}': {loss}" for loss in
                            _all_losses(entry.surface)]
        self.numbers.append(material.pass_index if material else 0)
        return WrittenMaterial(self._glb.add("materials", entry.json), entry.uv_names,
                               entry.colour_layer)
