# SPDX-License-Identifier: MIT
"""Renders one frame of a scene folder of `freshet film` (docs/film.md) with Cycles:

blender -b --factory-startup --python-exit-code 3 -P render_film.py -- FOLDER FRAME.json PICTURE.png

Lengths are in metres. The scene has y up, Blender z: (x, y, z) becomes (x, -z, y).
"""
import array
import json
import math
import os
import struct
import sys

import bpy
import mathutils

WATER = "#86cdea"  # a liquid without a colour
ABSORPTION = 2.8  # of water over the longest side of the domain
COLORED_ABSORPTION = 6.0  # of a liquid with a colour
IOR = 1.333
TANK = "#95a1ab"  # the sides of the domain
INSET = 0.4  # of the floor and the sides, in particle spacings
Y_UP = mathutils.Quaternion((1, 0, 0), math.radians(90))  # turns y up to z up


def up(p):
    return mathutils.Vector((p[0], -p[2], p[1]))


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
        """Shows `second` where the factor is 1."""
        node = self.add("ShaderNodeMixShader")
        self.link(factor, node.inputs[0], factor_socket)
        self.link(first, node.inputs[1])
        self.link(second, node.inputs[2])
        return node


def matte(name, color, see_through_outside=False):
    """A matte surface. `see_through_outside`: only its inner side is shown."""
    nodes = Nodes(name)
    surface = nodes.add("ShaderNodeBsdfDiffuse", Color=linear(color))
    if see_through_outside:
        side = nodes.add("ShaderNodeNewGeometry")
        surface = nodes.mix(side, "Backfacing", nodes.add("ShaderNodeBsdfTransparent"), surface)
    nodes.link(surface, nodes.output.inputs["Surface"])
    return nodes.material


def liquid(name, color, length):
    """A clear liquid that absorbs light. Shadow rays and diffuse rays pass its surface straight, so
    that light of sun and sky reaches floor and bodies without the noise of caustics."""
    nodes = Nodes(name)
    tint = linear(color or WATER)
    glass = nodes.add("ShaderNodeBsdfGlass", Roughness=0.0, IOR=IOR)
    clear = nodes.add("ShaderNodeBsdfTransparent", Color=(0.97, 0.97, 0.97, 1))
    path, either = nodes.add("ShaderNodeLightPath"), nodes.add("ShaderNodeMath")
    either.operation = "MAXIMUM"
    nodes.link(path, either.inputs[0], "Is Shadow Ray")
    nodes.link(path, either.inputs[1], "Is Diffuse Ray")
    nodes.link(nodes.mix(either, 0, glass, clear), nodes.output.inputs["Surface"])
    density = (COLORED_ABSORPTION if color else ABSORPTION) / length
    volume = nodes.add("ShaderNodeVolumeAbsorption", Color=tint, Density=density)
    nodes.link(volume, nodes.output.inputs["Volume"])
    return nodes.material


def arrays_of(file):
    """Positions and corners of the triangles of a *.glb file that Freshet wrote, or None if it has
    no mesh. Blender's own reader needs numpy, which Debian does not install with Blender."""
    with open(file, "rb") as stream:
        data = stream.read()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20 : 20 + length])
    if "meshes" not in document:
        return None
    buffer = memoryview(data)[28 + length :]

    def numbers(accessor, kind):
        view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
        values = array.array(kind)
        values.frombytes(buffer[view["byteOffset"] : view["byteOffset"] + view["byteLength"]])
        return values

    primitive = document["meshes"][0]["primitives"][0]
    return numbers(primitive["attributes"]["POSITION"], "f"), numbers(primitive["indices"], "I")


def load(file, material, smooth_angle=None):
    """Adds a mesh, smooth up to an angle between its triangles; None if the file has none."""
    arrays = arrays_of(file)
    if arrays is None:
        return None
    points, corners = arrays
    mesh = bpy.data.meshes.new(os.path.basename(file))
    triangles = len(corners) // 3
    mesh.vertices.add(len(points) // 3)
    mesh.loops.add(len(corners))
    mesh.polygons.add(triangles)
    mesh.vertices.foreach_set("co", points)
    mesh.loops.foreach_set("vertex_index", array.array("i", corners))
    mesh.polygons.foreach_set("loop_start", array.array("i", range(0, len(corners), 3)))
    mesh.polygons.foreach_set("loop_total", array.array("i", [3]) * triangles)
    mesh.polygons.foreach_set("use_smooth", [True] * triangles)
    mesh.update(calc_edges=True)
    mesh.materials.append(material)
    if smooth_angle and hasattr(mesh, "use_auto_smooth"):
        mesh.use_auto_smooth = True
        mesh.auto_smooth_angle = math.radians(smooth_angle)
    item = bpy.data.objects.new(mesh.name, mesh)
    item.rotation_mode = "QUATERNION"
    item.rotation_quaternion = Y_UP
    bpy.context.scene.collection.objects.link(item)
    return item


def add_solids(folder, scene, frame):
    for solid in scene["walls"]:
        material = matte(solid["name"], solid["color"], solid["around"])
        load(os.path.join(folder, solid["mesh"]), material, 35)
    for solid, pose in zip(scene["bodies"], frame["bodies"]):
        material = matte(solid["name"], solid["color"], solid["around"])
        item = load(os.path.join(folder, solid["mesh"]), material, 35)
        if item is None:
            continue
        x, y, z, w = pose["orientation"]
        item.rotation_quaternion = mathutils.Quaternion((w, x, -z, y)) @ Y_UP
        item.location = up(pose["position"])


def add_mesh(name, points, faces, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.materials.append(material)
    item = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(item)
    return item


def add_floor(scene):
    """A floor of large tiles. It is a little inside the liquid: light then passes from the liquid
    to the floor, not through a gap that would mirror it."""
    low, high = scene["domain"]["min"], scene["domain"]["max"]
    length = max(b - a for a, b in zip(low, high))
    height = low[1] + INSET * scene["spacing"]
    far = 30 * length
    nodes = Nodes("floor")
    place = nodes.add("ShaderNodeNewGeometry")
    tiles = nodes.add("ShaderNodeTexChecker", Scale=10 / length)
    tiles.inputs["Color1"].default_value = (0.30, 0.29, 0.28, 1)
    tiles.inputs["Color2"].default_value = (0.22, 0.22, 0.225, 1)
    nodes.link(place, tiles.inputs["Vector"], "Position")
    surface = nodes.add("ShaderNodeBsdfDiffuse")
    nodes.link(tiles, surface.inputs["Color"])
    nodes.link(surface, nodes.output.inputs["Surface"])
    x, z = (low[0] + high[0]) / 2, (low[2] + high[2]) / 2
    corners = [(x - far, z - far), (x - far, z + far), (x + far, z + far), (x + far, z - far)]
    add_mesh("floor", [up((a, height, b)) for a, b in corners], [(0, 1, 2, 3)], nodes.material)


def add_walls_of_domain(scene):
    """The sides of the tank. They are shown only from inside, so those in front of the liquid are
    not, and are as much inside the liquid as the floor."""
    inset = INSET * scene["spacing"]
    low = [a + inset for a in scene["domain"]["min"]]
    high = [b - inset for b in scene["domain"]["max"]]
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    faces = [(0, 4, 6, 2), (1, 3, 7, 5), None, None, (0, 2, 3, 1), (4, 5, 7, 6)]
    sides = [f for f, wall in zip(faces, scene["walls_of_domain"]) if f and wall]
    tank = add_mesh("tank", [up(p) for p in corners], sides, matte("tank", TANK, True))
    tank.visible_shadow = tank.visible_diffuse = False  # light passes them


def add_light():
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes = world.node_tree.nodes
    sky = nodes.new("ShaderNodeTexSky")
    sky.sky_type = "NISHITA"
    sky.sun_disc = False
    sky.sun_elevation = math.radians(35)
    sky.sun_rotation = math.radians(140)
    world.node_tree.links.new(sky.outputs[0], nodes["Background"].inputs[0])
    nodes["Background"].inputs[1].default_value = 0.13
    data = bpy.data.lights.new("sun", "SUN")
    data.energy = 3.2
    data.angle = 0.05
    sun = bpy.data.objects.new("sun", data)
    sun.rotation_euler = (math.radians(50), 0, math.radians(-40))
    bpy.context.scene.collection.objects.link(sun)


def add_camera(view):
    data = bpy.data.cameras.new("camera")
    camera = bpy.data.objects.new("camera", data)
    bpy.context.scene.collection.objects.link(camera)
    eye, target = up(view["position"]), up(view["target"])
    distance = (target - eye).length
    camera.location = eye
    camera.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(view["field_of_view"])
    data.clip_start, data.clip_end = 1e-3 * distance, 1e4 * distance
    bpy.context.scene.camera = camera


def set_renderer(scene, picture):
    settings = bpy.context.scene
    render, cycles = settings.render, settings.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = scene["width"], scene["height"]
    render.resolution_percentage = 100
    render.filepath = picture
    render.use_file_extension = False
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGB"
    cycles.device = "CPU"
    cycles.seed = 0
    cycles.samples = scene["samples"]
    cycles.use_adaptive_sampling = True
    cycles.adaptive_threshold = 0.02
    cycles.max_bounces, cycles.transmission_bounces = 12, 10
    cycles.transparent_max_bounces = 16
    cycles.caustics_refractive = cycles.caustics_reflective = False
    cycles.sample_clamp_indirect = 4
    cycles.use_denoising = False
    settings.view_settings.view_transform = "Filmic"
    settings.view_settings.look = "Medium High Contrast"


def main(folder, frame_file, picture):
    with open(os.path.join(folder, "scene.json")) as file:
        scene = json.load(file)
    with open(os.path.join(folder, frame_file)) as file:
        frame = json.load(file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    size = [b - a for a, b in zip(scene["domain"]["min"], scene["domain"]["max"])]
    for k, (about, surface) in enumerate(zip(scene["liquids"], frame["surfaces"])):
        load(os.path.join(folder, surface), liquid("liquid%d" % k, about["color"], max(size)))
    add_solids(folder, scene, frame)
    add_floor(scene)
    add_walls_of_domain(scene)
    add_light()
    add_camera(frame["camera"])
    set_renderer(scene, picture)
    bpy.ops.render.render(write_still=True)


main(*sys.argv[sys.argv.index("--") + 1 :])
