# SPDX-License-Identifier: MIT
"""blender --background --python tests/outside/addon_in_blender.py -- ADDON.zip RUN FRESHET: installs
the add-on and imports the run of drop.toml, to which it adds a file of foam."""
import os
import struct
import sys

import bpy

addon, run, freshet = (os.path.abspath(path) for path in sys.argv[sys.argv.index("--") + 1 :])
ROWS = [(0.5, 0.2, 0.6, 0, 1, 0, kind, 0.1, kind + 7) for kind in range(3)]


def write_foam(file):
    names = ["float " + n for n in ("x", "y", "z", "vx", "vy", "vz")] + ["uchar kind", "float age", "uint id"]
    head = "ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % len(ROWS)
    head += "".join("property %s\n" % name for name in names) + "end_header\n"
    os.makedirs(os.path.dirname(file), exist_ok=True)
    with open(file, "wb") as stream:
        stream.write(head.encode() + b"".join(struct.pack("<6fBfI", *row) for row in ROWS))


def corners(item):
    evaluated = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
    points = [evaluated.matrix_world @ vertex.co for vertex in item.data.vertices]
    return [pick(p[k] for p in points) for pick in (min, max) for k in range(3)]


def expect_near(values, expected, tolerance):
    for value, other in zip(values, expected):
        assert abs(value - other) < tolerance, (values, expected)


def velocities(item):
    return [tuple(v.vector) for v in item.data.attributes["velocity"].data]


write_foam(os.path.join(run, "data", "whitewater_0001.ply"))
bpy.ops.preferences.addon_install(filepath=addon)
bpy.ops.preferences.addon_enable(module="freshet_blender")
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.preferences.addon_enable(module="freshet_blender")
bpy.context.preferences.addons["freshet_blender"].preferences.command = freshet
assert bpy.ops.import_scene.freshet(filepath=run, particles=True) == {"FINISHED"}

scene, objects = bpy.context.scene, bpy.data.objects
assert (scene.frame_start, scene.frame_end) == (0, 2), (scene.frame_start, scene.frame_end)
liquid, foam, particles, box = (objects[name] for name in ("liquid0", "foam", "particles", "box"))
# The drop fills x and z from 0.3 to 0.7, and y from 0.5 to 0.9: (x, y, z) became (x, -z, y).
expect_near(corners(liquid), (0.3, -0.7, 0.5, 0.7, -0.3, 0.9), 0.03)
assert len(particles.data.vertices) == 512 and len(foam.data.vertices) == 0
expect_near(corners(box), (0.1, -0.2, 0.1, 0.2, -0.1, 0.2), 1e-4)

scene.frame_set(1)
time = 0.05  # of the frame: the drop has fallen for this long
expect_near(corners(liquid), (0.3, -0.7, 0.5 - 4.905 * time**2, 0.7, -0.3, 0.9 - 4.905 * time**2), 0.03)
# The film shows 0.05 s of the run in each frame, which lasts 1/24 s.
scale = 0.05 * scene.render.fps / scene.render.fps_base
expect_near(velocities(liquid)[0], (0, -9.81 * time * scale, 0), 0.05 * scale)
assert len(foam.data.vertices) == 3
expect_near(corners(foam), (0.5, -0.6, 0.2, 0.5, -0.6, 0.2), 1e-6)
radii = [value.value for value in foam.data.attributes["radius"].data]
assert all(0.1 * 0.05 < radius < 0.4 * 0.05 for radius in radii), radii
instances = foam.evaluated_get(bpy.context.evaluated_depsgraph_get())
assert instances.type == "MESH" and foam.modifiers[0].node_group, instances.type
expect_near(corners(box), (0.1, -0.2, 0.15, 0.2, -0.1, 0.25), 1e-3)  # it rises by 1 m/s

assert scene.camera and scene.render.engine == "CYCLES" and scene.render.use_motion_blur
scene.render.resolution_x, scene.render.resolution_y, scene.cycles.samples = 64, 48, 2
scene.render.filepath = os.path.join(run, "imported.png")
bpy.ops.render.render(write_still=True)
assert len(liquid.data.vertices) and len(foam.data.vertices) == 3, "the render changed the frame"
assert os.path.getsize(scene.render.filepath) > 0

blend = os.path.join(run, "imported.blend")
bpy.ops.wm.save_as_mainfile(filepath=blend)
bpy.ops.wm.open_mainfile(filepath=blend)
bpy.context.scene.frame_set(2)
assert len(bpy.data.objects["foam"].data.vertices) == 0, "a saved sequence still moves"
print("Blender imports the run")
