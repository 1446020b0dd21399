# SPDX-License-Identifier: MIT
"""Objects of a scene folder: liquids, bodies, walls, foam and particles."""
import array
import math
import os

import bpy
import mathutils

from . import files, materials, stage

SMOOTH_ANGLE = 35  # degrees: sharper edges of bodies and walls stay sharp
RADII = {0: 0.15, 1: 0.22, 2: 0.3}  # of spray, foam and bubbles, in particle spacings
PARTICLE_RADIUS = 0.5


def new_object(collection, name, mesh):
    """An object whose mesh has y up."""
    item = bpy.data.objects.new(name, mesh)
    item.rotation_mode = "QUATERNION"
    item.rotation_quaternion = stage.Y_UP
    collection.objects.link(item)
    return item


def set_vectors(mesh, name, values):
    mesh.attributes.new(name, "FLOAT_VECTOR", "POINT").data.foreach_set("vector", values)


def scaled(values, factor):
    return values if factor == 1 else array.array("f", (factor * v for v in values))


def fill(mesh, arrays, time_scale=1.0):
    """Replaces the geometry of a mesh by the arrays of files.read_glb; None empties it. Cycles blurs
    by the attribute "velocity", in metres per second of Blender: `time_scale` simulated seconds."""
    mesh.clear_geometry()
    if arrays is None:
        return
    triangles = len(arrays.corners) // 3
    mesh.vertices.add(len(arrays.points) // 3)
    mesh.loops.add(len(arrays.corners))
    mesh.polygons.add(triangles)
    mesh.vertices.foreach_set("co", arrays.points)
    mesh.loops.foreach_set("vertex_index", array.array("i", arrays.corners))
    mesh.polygons.foreach_set("loop_start", array.array("i", range(0, len(arrays.corners), 3)))
    if mesh.polygons and not mesh.polygons[0].loop_total:  # Blender 3; later it follows
        mesh.polygons.foreach_set("loop_total", array.array("i", [3]) * triangles)
    mesh.polygons.foreach_set("use_smooth", [True] * triangles)
    if arrays.velocities is not None:
        set_vectors(mesh, "velocity", scaled(arrays.velocities, time_scale))
    mesh.update(calc_edges=True)


def add_liquid(collection, scene, k):
    """The surface of liquid k, still empty."""
    mesh = bpy.data.meshes.new("liquid%d" % k)
    mesh.materials.append(materials.liquid(mesh.name, scene["liquids"][k], stage.length_of(scene)))
    return new_object(collection, mesh.name, mesh)


def add_solid(collection, folder, about):
    """A body or a wall, or None if it has no surface."""
    arrays = files.read_glb(os.path.join(folder, about["mesh"]))
    if arrays is None:
        return None
    mesh = bpy.data.meshes.new(about["name"])
    fill(mesh, arrays)
    size = max(max(arrays.points[k::3]) - min(arrays.points[k::3]) for k in range(3))
    mesh.materials.append(materials.solid(about["name"], about, about["around"], size))
    if hasattr(mesh, "use_auto_smooth"):
        mesh.use_auto_smooth = True
        mesh.auto_smooth_angle = math.radians(SMOOTH_ANGLE)
    elif hasattr(mesh, "set_sharp_from_angle"):  # from Blender 4.1 on
        mesh.set_sharp_from_angle(angle=math.radians(SMOOTH_ANGLE))
    return new_object(collection, about["name"], mesh)


def place(item, pose, after=0.0):
    """Places a body as it is `after` seconds after a frame, if its velocity stays."""
    spin = stage.up(pose["angular_velocity"]) * after
    item.location = stage.up(pose["position"]) + after * stage.up(pose["velocity"])
    orientation = stage.turned(pose["orientation"])
    if spin.length > 0:
        orientation = mathutils.Quaternion(spin.normalized(), spin.length) @ orientation
    item.rotation_quaternion = orientation


def key(item, frame):
    """Adds a key frame of the place of an object, with straight lines to its neighbours."""
    for path in ("location", "rotation_quaternion"):
        item.keyframe_insert(path, frame=frame)
    for curve in item.animation_data.action.fcurves:
        curve.keyframe_points[-1].interpolation = "LINEAR"


def points_to_spheres(name, material):
    """Geometry nodes that show the vertices of a mesh as spheres; "radius" is an attribute."""
    tree = bpy.data.node_groups.new(name, "GeometryNodeTree")
    if hasattr(tree, "interface"):  # from Blender 4 on
        for way in ("INPUT", "OUTPUT"):
            tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    else:
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")
    start, end = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    radius = tree.nodes.new("GeometryNodeInputNamedAttribute")
    radius.data_type = "FLOAT"
    radius.inputs[0].default_value = "radius"
    spheres, look = tree.nodes.new("GeometryNodeMeshToPoints"), tree.nodes.new("GeometryNodeSetMaterial")
    look.inputs["Material"].default_value = material
    tree.links.new(start.outputs[0], spheres.inputs["Mesh"])
    tree.links.new(next(s for s in radius.outputs if s.enabled), spheres.inputs["Radius"])
    tree.links.new(spheres.outputs[0], look.inputs[0])
    tree.links.new(look.outputs[0], end.inputs[0])
    return tree


def add_points(collection, name, material):
    """Spheres at points, still none."""
    mesh = bpy.data.meshes.new(name)
    mesh.materials.append(material)
    item = new_object(collection, name, mesh)
    item.modifiers.new("spheres", "NODES").node_group = points_to_spheres(name, material)
    return item


def variation(k):
    """A factor from 0.7 to 1.3 that differs from point to point."""
    return 0.7 + 0.6 * ((k * 2654435761 >> 8) % 1024) / 1023


def radii_of(points, spacing):
    """The radii of foam, spray and bubbles by their kind [m]; of other particles half a spacing."""
    kinds, ids = points.columns.get("kind"), points.columns.get("id")
    if kinds is None:
        return array.array("f", [PARTICLE_RADIUS * spacing]) * points.count
    ids = ids if ids is not None else range(points.count)
    return array.array(
        "f", (RADII.get(int(kind), 0.2) * variation(int(k)) * spacing for kind, k in zip(kinds, ids))
    )


def fill_points(mesh, points, spacing, time_scale=1.0):
    """Replaces the points of a mesh by those of files.read_points; None empties it."""
    mesh.clear_geometry()
    if points is None or points.count == 0:
        return
    mesh.vertices.add(points.count)
    mesh.vertices.foreach_set("co", points.positions)
    mesh.attributes.new("radius", "FLOAT", "POINT").data.foreach_set("value", radii_of(points, spacing))
    if points.velocities is not None:
        set_vectors(mesh, "velocity", scaled(points.velocities, time_scale))
    for name in ("kind", "age"):
        if name in points.columns:
            values = array.array("f", points.columns[name])
            mesh.attributes.new(name, "FLOAT", "POINT").data.foreach_set("value", values)
    mesh.update()
