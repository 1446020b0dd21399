# SPDX-License-Identifier: MIT
"""Materials of liquids, bodies, walls and foam."""
import bpy


def linear(color):
    """The linear RGBA of "#rrggbb", which is sRGB."""

    def channel(k):
        s = int(color[1 + 2 * k : 3 + 2 * k], 16) / 255
        return s / 12.92 if s <= 0.04045 else ((s + 0.055) / 1.055) ** 2.4

    return (channel(0), channel(1), channel(2), 1.0)


class Nodes:
    """The nodes of a new material."""

    def __init__(self, name):
        self.material = bpy.data.materials.new(name)
        self.material.use_nodes = True
        self.tree = self.material.node_tree
        self.tree.nodes.clear()
        self.output = self.add("ShaderNodeOutputMaterial")

    def add(self, kind, **inputs):
        node = self.tree.nodes.new(kind)
        for name, value in inputs.items():
            node.inputs[name.replace("_", " ")].default_value = value
        return node

    def link(self, source, target, source_socket=0):
        self.tree.links.new(source.outputs[source_socket], target)

    def mix(self, factor, factor_socket, first, second):
        """Shows `second` where the factor is 1. The factor is a node or a number."""
        node = self.add("ShaderNodeMixShader")
        if isinstance(factor, float):
            node.inputs[0].default_value = factor
        else:
            self.link(factor, node.inputs[0], factor_socket)
        self.link(first, node.inputs[1])
        self.link(second, node.inputs[2])
        return node

    def shows(self, surface, volume=None):
        self.link(surface, self.output.inputs["Surface"])
        if volume:
            self.link(volume, self.output.inputs["Volume"])
        return self.material

    def principled(self, color, **inputs):
        """A Principled BSDF. Inputs that a version of Blender does not have are skipped."""
        node = self.add("ShaderNodeBsdfPrincipled")
        node.inputs["Base Color"].default_value = color
        for name, value in inputs.items():
            socket = node.inputs.get(name.replace("_", " "))
            if socket:
                socket.default_value = value
        return node


def wood(nodes, color, roughness, length):
    """Planed wood with dark rings."""
    place = nodes.add("ShaderNodeTexCoord")
    rings = nodes.add("ShaderNodeTexWave", Scale=4 / length, Distortion=5.0, Detail=2.0)
    rings.wave_type = "RINGS"
    shades = nodes.add("ShaderNodeValToRGB")
    dark = tuple(0.45 * c for c in color[:3]) + (1,)
    shades.color_ramp.elements[0].color, shades.color_ramp.elements[1].color = dark, color
    nodes.link(place, rings.inputs["Vector"], "Object")
    nodes.link(rings, shades.inputs[0])
    surface = nodes.principled(color, Roughness=roughness)
    nodes.link(shades, surface.inputs["Base Color"])
    return surface


def solid(name, about, see_through_outside=False, length=1.0):
    """The surface of a body or a wall: `about` is its entry in scene.json. `see_through_outside`:
    only its inner side is shown. `length` [m] is its size."""
    nodes = Nodes(name)
    color, material = linear(about["color"]), about.get("material", {})
    kind, roughness = material.get("kind", "matte"), material.get("roughness", 1.0)
    if kind == "matte":
        surface = nodes.add("ShaderNodeBsdfDiffuse", Color=color)
    elif kind == "glass":
        surface = nodes.add("ShaderNodeBsdfGlass", Color=color, Roughness=roughness, IOR=material["ior"])
        surface = lit_through(nodes, surface, color)
    elif kind == "wood":
        surface = wood(nodes, color, roughness, length)
    else:
        surface = nodes.principled(color, Roughness=roughness, Metallic=1.0 if kind == "metal" else 0.0)
    if see_through_outside:
        side = nodes.add("ShaderNodeNewGeometry")
        surface = nodes.mix(side, "Backfacing", nodes.add("ShaderNodeBsdfTransparent"), surface)
    return nodes.shows(surface)


def lit_through(nodes, surface, tint):
    """Shadow rays and diffuse rays pass a surface straight: light of sun and sky reaches what is
    behind it, without the noise of caustics."""
    clear = nodes.add("ShaderNodeBsdfTransparent", Color=tint)
    path, either = nodes.add("ShaderNodeLightPath"), nodes.add("ShaderNodeMath")
    either.operation = "MAXIMUM"
    nodes.link(path, either.inputs[0], "Is Shadow Ray")
    nodes.link(path, either.inputs[1], "Is Diffuse Ray")
    return nodes.mix(either, 0, surface, clear)


def liquid(name, about, length):
    """A liquid: `about` is its entry in scene.json. It refracts, absorbs light over `length` [m],
    and scatters a share of the light at its surface."""
    nodes = Nodes(name)
    color, share = linear(about["color"]), float(about["scattering"])
    body = nodes.principled(color, Roughness=about["roughness"], IOR=about["ior"])
    if share >= 1:
        return nodes.shows(body)
    glass = nodes.add("ShaderNodeBsdfGlass", Roughness=about["roughness"], IOR=about["ior"])
    surface = lit_through(nodes, glass, (0.97, 0.97, 0.97, 1))
    if share > 0:
        surface = nodes.mix(share, None, surface, body)
    volume = nodes.add("ShaderNodeVolumeAbsorption", Color=color, Density=about["absorption"] / length)
    return nodes.shows(surface, volume)


def foam():
    """White, lit from behind too, and never black: bubbles scatter light many times."""
    nodes = Nodes("foam")
    white = (0.9, 0.93, 0.95, 1)
    front, back = nodes.add("ShaderNodeBsdfDiffuse", Color=white), nodes.add("ShaderNodeBsdfTranslucent", Color=white)
    return nodes.shows(nodes.mix(0.4, None, front, back))


def tiles(length, center):
    """A floor of grey tiles around `center`, which become one grey far away."""
    nodes = Nodes("floor")
    place = nodes.add("ShaderNodeNewGeometry")
    checker = nodes.add("ShaderNodeTexChecker", Scale=10 / length)
    checker.inputs["Color1"].default_value = (0.30, 0.29, 0.28, 1)
    checker.inputs["Color2"].default_value = (0.22, 0.22, 0.225, 1)
    nodes.link(place, checker.inputs["Vector"], "Position")
    distance, far = nodes.add("ShaderNodeVectorMath"), nodes.add("ShaderNodeMapRange")
    distance.operation = "DISTANCE"
    distance.inputs[1].default_value = center
    far.inputs["From Min"].default_value, far.inputs["From Max"].default_value = length, 4 * length
    color = nodes.add("ShaderNodeMixRGB", Color2=(0.26, 0.255, 0.25, 1))
    surface = nodes.add("ShaderNodeBsdfDiffuse")
    nodes.link(place, distance.inputs[0], "Position")
    nodes.link(distance, far.inputs["Value"], "Value")
    nodes.link(far, color.inputs["Fac"])
    nodes.link(checker, color.inputs["Color1"])
    nodes.link(color, surface.inputs["Color"])
    return nodes.shows(surface)
