# SPDX-License-Identifier: MIT
"""What stays the same in all frames: floor, sides of the tank, light, camera and renderer."""
import math

import bpy
import mathutils

from . import materials

TANK = {"color": "#b4bec6"}  # the sides of the domain
INSET = 0.4  # of the floor and the sides, in particle spacings
Y_UP = mathutils.Quaternion((1, 0, 0), math.radians(90))  # turns y up to z up


def up(p):
    """Freshet has y up, Blender z: (x, y, z) becomes (x, -z, y)."""
    return mathutils.Vector((p[0], -p[2], p[1]))


def turned(orientation):
    """The quaternion in Blender of a body whose mesh has y up."""
    x, y, z, w = orientation
    return mathutils.Quaternion((w, x, -z, y)) @ Y_UP


def length_of(scene):
    """The longest side of what the film shows [m]."""
    return max(b - a for a, b in zip(scene["seen"]["min"], scene["seen"]["max"]))


def add_mesh(collection, name, points, faces, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.materials.append(material)
    item = bpy.data.objects.new(name, mesh)
    collection.objects.link(item)
    return item


def add_floor(scene, collection):
    """A floor of large tiles. It is a little inside the liquid: light then passes from the liquid
    to the floor, not through a gap that would mirror it."""
    low, high = scene["seen"]["min"], scene["seen"]["max"]
    length = length_of(scene)
    height = scene["domain"]["min"][1] + INSET * scene["spacing"]
    far = 30 * length
    x, z = (low[0] + high[0]) / 2, (low[2] + high[2]) / 2
    corners = [(x - far, z - far), (x - far, z + far), (x + far, z + far), (x + far, z - far)]
    points = [up((a, height, b)) for a, b in corners]
    material = materials.tiles(length, up((x, height, z)))
    add_mesh(collection, "floor", points, [(0, 1, 2, 3)], material)


def add_tank(scene, collection):
    """The sides of the domain that the liquid touches. They are shown only from inside, so those in
    front of the liquid are not, and are as much inside the liquid as the floor."""
    inset = INSET * scene["spacing"]
    low = [a + inset for a in scene["domain"]["min"]]
    high = [b - inset for b in scene["domain"]["max"]]
    high[1] = min(high[1], scene["tank_top"])
    corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
    faces = [(0, 4, 6, 2), (1, 3, 7, 5), None, None, (0, 2, 3, 1), (4, 5, 7, 6)]
    sides = [f for f, wall in zip(faces, scene["walls_of_domain"]) if f and wall]
    if not sides:
        return
    material = materials.solid("tank", TANK, see_through_outside=True)
    tank = add_mesh(collection, "tank", [up(p) for p in corners], sides, material)
    tank.visible_shadow = tank.visible_diffuse = False  # light passes them


def add_light(collection):
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
    collection.objects.link(sun)


def add_camera(collection):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    camera = bpy.data.objects.new("camera", data)
    camera.rotation_mode = "QUATERNION"
    collection.objects.link(camera)
    bpy.context.scene.camera = camera
    return camera


def aim(camera, view):
    """Sets the camera to the view of a frame."""
    eye, target = up(view["position"]), up(view["target"])
    distance = (target - eye).length
    camera.location = eye
    camera.rotation_quaternion = (target - eye).to_track_quat("-Z", "Y")
    camera.data.angle = math.radians(view["field_of_view"])
    camera.data.clip_start, camera.data.clip_end = 1e-3 * distance, 1e4 * distance


def set_renderer(scene):
    settings = bpy.context.scene
    render, cycles = settings.render, settings.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = scene["width"], scene["height"]
    render.resolution_percentage = 100
    render.use_motion_blur = scene["shutter"] > 0
    cycles.samples = scene["samples"]
    cycles.use_adaptive_sampling = True
    cycles.adaptive_threshold = 0.01
    cycles.max_bounces, cycles.transmission_bounces = 12, 10
    cycles.transparent_max_bounces = 16
    cycles.caustics_refractive = cycles.caustics_reflective = False
    cycles.sample_clamp_indirect = 4
    cycles.use_denoising = False
    settings.view_settings.view_transform = "Filmic"
    settings.view_settings.look = "Medium High Contrast"


def add_denoiser():
    """Averages pixels with their neighbours of about the same colour and direction of surface, as seen through
    the water. Debian's Blender has no denoiser of its own."""
    settings = bpy.context.scene
    settings.view_layers[0].cycles.denoising_store_passes = True
    settings.use_nodes = True
    nodes, links = settings.node_tree.nodes, settings.node_tree.links
    nodes.clear()
    layers = nodes.new("CompositorNodeRLayers")
    surface = nodes.new("CompositorNodeMixRGB")
    surface.blend_type = "ADD"
    surface.inputs["Fac"].default_value = 0.3
    blur = nodes.new("CompositorNodeBilateralblur")
    blur.iterations, blur.sigma_space, blur.sigma_color = 2, 2.0, 0.1
    result = nodes.new("CompositorNodeComposite")
    links.new(layers.outputs["Denoising Albedo"], surface.inputs[1])
    links.new(layers.outputs["Denoising Normal"], surface.inputs[2])
    links.new(layers.outputs["Image"], blur.inputs["Image"])
    links.new(surface.outputs["Image"], blur.inputs["Determinator"])
    links.new(blur.outputs["Image"], result.inputs["Image"])
