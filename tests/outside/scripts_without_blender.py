# SPDX-License-Identifier: MIT
"""python3 tests/outside/scripts_without_blender.py FRESHET FOLDER: the scripts for Blender compile,
the add-on is complete, and its reader agrees with what Freshet writes. Needs no Blender."""
import ast
import importlib.util
import os
import subprocess
import sys
import zipfile

sys.dont_write_bytecode = True
freshet, out = sys.argv[1:3]
root = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
scripts = os.path.join(root, "integrations", "blender")
package = os.path.join(scripts, "freshet_blender")


def run(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


found = 0
for folder in (scripts, package):
    for name in os.listdir(folder):
        if name.endswith(".py") or name == "build_addon":
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                ast.parse(file.read(), name, feature_version=(3, 10))  # of Blender 3.4
            found += 1
assert found >= 8, found

os.makedirs(out, exist_ok=True)
run(sys.executable, os.path.join(scripts, "build_addon"), out)
with zipfile.ZipFile(os.path.join(out, "freshet_blender.zip")) as archive:
    names = sorted(os.path.basename(name) for name in archive.namelist())
    assert names == sorted(n for n in os.listdir(package) if n.endswith(".py")), names

place = importlib.util.spec_from_file_location("files", os.path.join(package, "files.py"))
files = importlib.util.module_from_spec(place)
place.loader.exec_module(files)
folder = os.path.join(out, "run")
run(freshet, "run", os.path.join(root, "tests/outside/drop.toml"), "--output", folder, "--overwrite", "--quiet")
run(freshet, "film", folder, "--scene-only", "--overwrite", "--quiet")
stage = os.path.join(folder, "film", "scene")
assert files.read_scene(stage)["spacing"] == 0.05
frames = files.frame_files(stage)
assert list(frames) == [0, 1, 2], frames
mesh = files.read_glb(os.path.join(stage, files.read_json(frames[2])["surfaces"][0]))
assert len(mesh.points) == len(mesh.velocities) > 300 and max(mesh.corners) == len(mesh.points) // 3 - 1
assert all(abs(v + 0.981) < 0.1 for v in mesh.velocities[1::3])  # after 0.1 s of free fall

points = [files.read_points(os.path.join(folder, "data", "frame_0002" + end)) for end in (".ply", ".vtp")]
for one in points:
    assert one.count == 512 and len(one.positions) == len(one.velocities) == 3 * 512
assert points[0].positions == points[1].positions and points[0].velocities == points[1].velocities
assert list(points[0].columns["id"]) == list(points[1].columns["id"])

text = b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
text += b"property uchar kind\nend_header\n1 2 3 2\n4 5 6 0\n"
foam = files.Points(files.read_ply(text))
assert list(foam.positions) == [1, 2, 3, 4, 5, 6] and list(foam.columns["kind"]) == [2, 0]
damaged = os.path.join(out, "damaged.ply")
with open(damaged, "wb") as file:
    file.write(text[:90])
try:
    files.read_points(damaged)
    raise AssertionError("a damaged file was read")
except files.FileError as error:
    assert damaged in str(error), error
print("The scripts for Blender read what Freshet writes")
