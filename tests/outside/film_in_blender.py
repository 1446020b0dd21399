# SPDX-License-Identifier: MIT
"""blender --background --python tests/outside/film_in_blender.py -- FOLDER: checks the picture that
`freshet film` made of drop.toml at its start, and the scene that it was made from."""
import os
import runpy
import sys

import bpy

folder = sys.argv[sys.argv.index("--") + 1]
image = bpy.data.images.load(os.path.abspath(os.path.join(folder, "frame_0000.png")))
assert tuple(image.size) == (64, 48), tuple(image.size)
pixels = list(image.pixels)
bright = [sum(pixels[k : k + 3]) / 3 for k in range(0, len(pixels), 4)]
assert 0.1 < sum(bright) / len(bright) < 0.9, "the picture is black or white"
assert max(bright) - min(bright) > 0.15, "the picture is empty"

script = os.path.join(os.path.dirname(__file__), "../../integrations/blender/render_film.py")
scene = os.path.join(folder, "scene")
again = os.path.abspath(os.path.join(folder, "again.png"))
sys.argv = ["blender", "--", scene, "frame_0000.json", again]
runpy.run_path(script, run_name="__main__")
liquid = bpy.data.objects["liquid0"]
corners = [liquid.matrix_world @ vertex.co for vertex in liquid.data.vertices]
low = [min(p[k] for p in corners) for k in range(3)]
high = [max(p[k] for p in corners) for k in range(3)]
# the drop fills x and z from 0.3 to 0.7, and y from 0.5 to 0.9: (x, y, z) became (x, -z, y)
for value, expected in zip(low + high, (0.3, -0.7, 0.5, 0.7, -0.3, 0.9)):
    assert abs(value - expected) < 0.03, (low, high)
assert os.path.getsize(again) > 0
print("Blender renders the film")
