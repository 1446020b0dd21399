# SPDX-License-Identifier: MIT
"""blender --background --python tests/outside/open_in_blender.py -- DIR: Blender imports PLY files."""
import csv
import os
import sys

import bpy

folder = os.path.join(sys.argv[sys.argv.index("--") + 1], "data")
for name in ("frame_0000", "frame_0002"):
    bpy.ops.import_mesh.ply(filepath=os.path.join(folder, name + ".ply"))
    mesh = bpy.context.object.data
    with open(os.path.join(folder, name + ".csv")) as file:
        rows = list(csv.DictReader(file))
    assert len(mesh.vertices) == len(rows) == 512, len(mesh.vertices)
    for vertex, row in zip(mesh.vertices, rows):
        for a in range(3):
            assert abs(vertex.co[a] - float(row["xyz"[a]])) < 1e-6, (vertex.co, row)
print("Blender reads the PLY files")
