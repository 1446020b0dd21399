# SPDX-License-Identifier: MIT
"""A run as a sequence: frame N of Blender shows the data file with number N, or the one before."""
import bisect
import os
import shutil
import subprocess

import bpy
from bpy.app.handlers import persistent

from . import files, materials, objects, stage

# Properties of objects that change from frame to frame, which are saved in the *.blend file.
FOLDER, KIND, INDEX, TIME_SCALE, SPACING = (
    "freshet_folder", "freshet_kind", "freshet_index", "freshet_time_scale", "freshet_spacing",
)  # fmt: skip
SHOWN = "freshet_shown"  # the number of the frame in the mesh

cache = {}  # folder: (its modification time, numbers, files)


def frames_of(folder):
    """The numbers and files of the frames, read again when the folder changes."""
    try:
        changed = os.stat(folder).st_mtime_ns
    except OSError:
        return [], []
    if folder not in cache or cache[folder][0] != changed:
        found = files.frame_files(folder)
        cache[folder] = (changed, list(found), list(found.values()))
    return cache[folder][1:]


def at(folder, number):
    """The file of a frame, or of the one before it; the first one before the start."""
    numbers, names = frames_of(folder)
    if not numbers:
        return None, None
    k = max(0, bisect.bisect_right(numbers, number) - 1)
    return numbers[k], names[k]


def data_file(folder, number):
    """A data file that this version reads, in the run of a folder RUN/film/scene."""
    run = os.path.dirname(os.path.dirname(folder))
    for extension in (".ply", ".vtp"):
        file = os.path.join(run, "data", "frame_%04d%s" % (number, extension))
        if os.path.isfile(file):
            return file
    return None


def show(item, number):
    """Puts the geometry of a frame into an object of a sequence."""
    folder = bpy.path.abspath(item[FOLDER])
    number, file = at(folder, number)
    if number is None or item.get(SHOWN) == number:
        return
    frame, kind = files.read_json(file), item[KIND]
    if kind == "liquid":
        arrays = files.read_glb(os.path.join(folder, frame["surfaces"][item[INDEX]]))
        objects.fill(item.data, arrays, item[TIME_SCALE])
    else:
        if kind == "whitewater":
            source = next(iter(frame.get("whitewater", [])), None)
        else:
            source = data_file(folder, number)
        points = files.read_points(os.path.join(folder, source)) if source else None
        objects.fill_points(item.data, points, item[SPACING], item[TIME_SCALE])
    item[SHOWN] = number


@persistent
def on_frame(scene, *_):
    """Shows the current frame. Renderers also visit times between frames, for motion blur: the
    blur follows from velocities, so that nothing is read for them."""
    if scene.frame_subframe != 0:
        return
    for item in scene.objects:
        if FOLDER in item:
            try:
                show(item, scene.frame_current)
            except files.FileError as error:
                print("Freshet:", error)


def register():
    bpy.app.handlers.frame_change_pre.append(on_frame)


def unregister():
    if on_frame in bpy.app.handlers.frame_change_pre:
        bpy.app.handlers.frame_change_pre.remove(on_frame)


def is_older(folder, run):
    """Whether a scene folder is of an earlier run in the same place."""
    manifest = os.path.join(run, "manifest.json")
    scene = os.path.join(folder, files.SCENE_FILE)
    return os.path.isfile(manifest) and os.path.getmtime(scene) < os.path.getmtime(manifest)


def scene_folder(path, command="freshet"):
    """The scene folder of a path: itself, or that of a run, which `freshet` makes if it is missing
    or older than the run."""
    path = os.path.normpath(path)
    if os.path.isfile(path):
        path = os.path.dirname(path)
    for folder in (path, os.path.join(path, "scene"), os.path.join(path, "film", "scene")):
        if not os.path.isfile(os.path.join(folder, files.SCENE_FILE)) or not frames_of(folder)[0]:
            continue
        if not (is_older(folder, path) and shutil.which(command)):
            return folder
    if not os.path.isfile(os.path.join(path, "scene.toml")):
        raise files.FileError("%s: this folder holds neither a run nor a scene for Blender" % path)
    if not shutil.which(command):
        raise files.FileError(
            "the program %s is not found; set it in the preferences of the add-on, or run "
            "`freshet film %s --scene-only`" % (command, path)
        )
    done = subprocess.run(
        [command, "film", path, "--scene-only", "--overwrite", "--quiet"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode:
        raise files.FileError(done.stderr.strip() or "%s failed" % command)
    return os.path.join(path, "film", "scene")


def follow(item, folder, kind, scene, time_scale, index=0):
    """Makes an object show the frames of a folder."""
    item[FOLDER], item[KIND], item[INDEX] = folder, kind, index
    item[TIME_SCALE], item[SPACING] = time_scale, scene["spacing"]


def time_between(frames):
    """The simulated time from one number of a frame to the next [s]."""
    numbers = list(frames)
    if len(numbers) < 2:
        return 0.0
    times = [frames[numbers[0]]["time"], frames[numbers[-1]]["time"]]
    return (times[1] - times[0]) / (numbers[-1] - numbers[0])


def add_solids(collection, folder, scene, frames):
    for wall in scene["walls"]:
        objects.add_solid(collection, folder, wall)
    for k, about in enumerate(scene["bodies"]):
        item = objects.add_solid(collection, folder, about)
        for number, frame in frames.items() if item else ():
            objects.place(item, frame["bodies"][k])
            objects.key(item, number)


def add_camera(collection, frames):
    camera = stage.add_camera(collection)
    views = [frame["camera"] for frame in frames.values()]
    stage.aim(camera, views[0])
    if any(view != views[0] for view in views):
        for number, frame in frames.items():
            stage.aim(camera, frame["camera"])
            objects.key(camera, number)


def set_times(scene, frames, step):
    """The range of frames, and a shutter that is open as long as in `freshet film`."""
    numbers, settings = list(frames), bpy.context.scene
    settings.frame_start, settings.frame_end = numbers[0], numbers[-1]
    if scene["shutter"] > 0 and step > 0:
        settings.render.motion_blur_shutter = scene["shutter"] / step


def import_run(path, command="freshet", particles=False, surroundings=True):
    """Adds a run to the scene and returns its collection.

    particles     the particles of the data files, too, as spheres
    surroundings  floor, tank, light, camera and the settings of the renderer
    """
    folder = scene_folder(path, command)
    scene = files.read_scene(folder)
    frames = {number: files.read_json(file) for number, file in files.frame_files(folder).items()}
    if not frames:
        raise files.FileError("%s: this folder has no frames" % folder)
    name = scene.get("title") or os.path.basename(os.path.dirname(os.path.dirname(folder)))
    collection = bpy.data.collections.new(name or "Freshet")
    bpy.context.scene.collection.children.link(collection)
    step = time_between(frames)
    render = bpy.context.scene.render
    time_scale = step * render.fps / render.fps_base  # simulated seconds per second of the film
    for k in range(len(scene["liquids"])):
        follow(objects.add_liquid(collection, scene, k), folder, "liquid", scene, time_scale, k)
    if any(frame.get("whitewater") for frame in frames.values()):
        foam = objects.add_points(collection, "foam", materials.foam())
        follow(foam, folder, "whitewater", scene, time_scale)
    if particles:
        look = materials.solid("particles", {"color": "#3f7fbf"})
        item = objects.add_points(collection, "particles", look)
        follow(item, folder, "particles", scene, time_scale)
    add_solids(collection, folder, scene, frames)
    if surroundings:
        stage.add_floor(scene, collection)
        stage.add_tank(scene, collection)
        stage.add_light(collection)
        add_camera(collection, frames)
        stage.set_renderer(scene)
        render.use_lock_interface = True  # frames change meshes while a render runs
    set_times(scene, frames, step)
    bpy.context.scene.frame_set(bpy.context.scene.frame_start)
    for item in collection.objects:
        if FOLDER in item:
            show(item, bpy.context.scene.frame_current)  # raises what on_frame prints
    return collection
