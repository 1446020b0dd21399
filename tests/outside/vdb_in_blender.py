# SPDX-License-Identifier: MIT
"""blender --background --python tests/outside/vdb_in_blender.py -- FILE: Blender reads the grids of a *.vdb
file, and makes a mesh of its level set that fills as much as the density."""
import sys

import bmesh
import bpy

bpy.ops.object.volume_import(filepath=sys.argv[sys.argv.index("--") + 1])
volume = bpy.context.object
assert volume.data.grids.load(), volume.data.grids.error_message
kinds = {grid.name: grid.data_type for grid in volume.data.grids}
assert kinds == {"surface": "FLOAT", "density": "FLOAT", "v": "VECTOR_FLOAT"}, kinds


def volume_of(grid, threshold):
    mesh = bpy.data.objects.new(grid, bpy.data.meshes.new(grid))
    bpy.context.collection.objects.link(mesh)
    node = mesh.modifiers.new("mesh", "VOLUME_TO_MESH")
    node.object, node.grid_name, node.threshold = volume, grid, threshold
    evaluated = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
    shape = bmesh.new()
    shape.from_mesh(evaluated.to_mesh())
    assert all(edge.is_manifold for edge in shape.edges)
    return shape.calc_volume(signed=True)


distance, density = volume_of("surface", 0), volume_of("density", 0.6)
assert distance > 0 and abs(density / distance - 1) < 0.1, (distance, density)
print("Blender reads the grids of", volume.name, "with the volume", distance)
