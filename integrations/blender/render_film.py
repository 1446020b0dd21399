# SPDX-License-Identifier: MIT
"""Renders one frame of a scene folder of `freshet film` (docs/film.md) with Cycles:

blender -b --factory-startup --python-exit-code 3 -P render_film.py -- FOLDER FRAME.json PICTURE.png

The add-on freshet_blender imports the same folder.
"""
import os
import sys

import bpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from freshet_blender import files, materials, objects, stage  # noqa: E402


def add_foam(collection, folder, scene, frame):
    for file in frame.get("whitewater", []):
        item = objects.add_points(collection, "foam", materials.foam())
        points = files.read_points(os.path.join(folder, file))
        objects.fill_points(item.data, points, scene["spacing"])


def add_moving(collection, folder, scene, frame):
    """Liquids, foam and bodies at frame 1, where the shutter is open from frame 0.5 to 1.5."""
    for k, surface in enumerate(frame["surfaces"]):
        item = objects.add_liquid(collection, scene, k)
        objects.fill(item.data, files.read_glb(os.path.join(folder, surface)))
    add_foam(collection, folder, scene, frame)
    for about, pose in zip(scene["bodies"], frame["bodies"]):
        item = objects.add_solid(collection, folder, about)
        if item is None:
            continue
        objects.place(item, pose)
        if scene["shutter"] > 0:
            for k in range(3):
                objects.place(item, pose, (k - 1) * scene["shutter"])
                objects.key(item, k)


def set_output(scene, picture):
    """One frame lasts as long as the shutter is open, so that velocities are per second."""
    settings = bpy.context.scene
    render = settings.render
    render.filepath = picture
    render.use_file_extension = False
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGB"
    if scene["shutter"] > 0:
        render.fps, render.fps_base = 1, scene["shutter"]
        render.motion_blur_shutter = 1
    settings.cycles.device = "CPU"
    settings.cycles.seed = 0
    settings.frame_set(1)


def main(folder, frame_file, picture):
    scene = files.read_scene(folder)
    frame = files.read_json(os.path.join(folder, frame_file))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    collection = bpy.context.scene.collection
    add_moving(collection, folder, scene, frame)
    for wall in scene["walls"]:
        objects.add_solid(collection, folder, wall)
    stage.add_floor(scene, collection)
    stage.add_tank(scene, collection)
    stage.add_light(collection)
    stage.aim(stage.add_camera(collection), frame["camera"])
    stage.set_renderer(scene)
    if scene.get("denoise"):
        stage.add_denoiser()
    set_output(scene, picture)
    bpy.ops.render.render(write_still=True)


main(*sys.argv[sys.argv.index("--") + 1 :])
