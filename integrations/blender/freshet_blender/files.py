# SPDX-License-Identifier: MIT
"""Reads the files that Freshet writes for Blender. Needs neither Blender nor numpy, which Debian
does not install with Blender. docs/film.md describes the scene folder."""
import array
import glob
import json
import os
import re
import struct
import sys

FORMAT = 2  # of scene.json
SCENE_FILE = "scene.json"


class FileError(Exception):
    """A file is missing, damaged or of another version."""


class Mesh:
    """Arrays: positions and velocities (3 floats a vertex), corners (3 indices a triangle)."""

    def __init__(self, points, corners, velocities=None):
        self.points, self.corners, self.velocities = points, corners, velocities


def read_json(file):
    try:
        with open(file, encoding="utf-8") as stream:
            return json.load(stream)
    except (OSError, ValueError) as error:
        raise FileError("%s: %s" % (file, error)) from error


def read_scene(folder):
    """scene.json of a scene folder."""
    scene = read_json(os.path.join(folder, SCENE_FILE))
    if scene.get("format") != FORMAT:
        raise FileError(
            "%s: its format is %s, and this version of the script reads %s; make the folder again"
            % (os.path.join(folder, SCENE_FILE), scene.get("format"), FORMAT)
        )
    return scene


def frame_files(folder):
    """The numbers of the frames of a scene folder, and their files."""
    found = {}
    for file in glob.glob(os.path.join(glob.escape(folder), "frame_*.json")):
        match = re.fullmatch(r"frame_(\d+)\.json", os.path.basename(file))
        if match:
            found[int(match.group(1))] = file
    return dict(sorted(found.items()))


def numbers(kind, data):
    """An array of little-endian numbers."""
    values = array.array(kind)
    values.frombytes(data)
    if sys.byteorder == "big":
        values.byteswap()
    return values


def read_glb(file):
    """The mesh of a *.glb file that Freshet wrote, or None if it has none."""
    try:
        with open(file, "rb") as stream:
            data = stream.read()
        length = struct.unpack_from("<I", data, 12)[0]
        document = json.loads(data[20 : 20 + length])
        if "meshes" not in document:
            return None
        buffer = memoryview(data)[28 + length :]

        def values(accessor, kind):
            view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
            return numbers(kind, buffer[view["byteOffset"] : view["byteOffset"] + view["byteLength"]])

        primitive = document["meshes"][0]["primitives"][0]
        attributes = primitive["attributes"]
        velocities = values(attributes["_VELOCITY"], "f") if "_VELOCITY" in attributes else None
        return Mesh(values(attributes["POSITION"], "f"), values(primitive["indices"], "I"), velocities)
    except (OSError, ValueError, KeyError, IndexError, struct.error) as error:
        raise FileError("%s: not a mesh of Freshet: %s" % (file, error)) from error


PLY_KINDS = {
    "char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h",
    "ushort": "H", "uint16": "H", "int": "i", "int32": "i", "uint": "I", "uint32": "I",
    "float": "f", "float32": "f", "double": "d", "float64": "d",
}  # fmt: skip


def read_ply(data):
    """The columns of the vertices of a PLY file, binary little-endian or ascii."""
    end = data.index(b"end_header\n") + len(b"end_header\n")
    columns, count, element, encoding = [], 0, "", ""
    for line in data[:end].decode("ascii", "replace").splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            encoding = words[1]
        elif words[:1] == ["element"]:
            element = words[1]
            count = int(words[2]) if element == "vertex" else count
        elif words[:1] == ["property"] and element == "vertex":
            columns.append((words[2], PLY_KINDS[words[1]]))
    if encoding == "ascii":
        rows = (line.split() for line in data[end:].decode("ascii").splitlines()[:count])
        values = list(zip(*([float(word) for word in row] for row in rows)))
        return {name: array.array("d", v) for (name, _), v in zip(columns, values)}
    if encoding != "binary_little_endian":
        raise ValueError("unknown encoding " + encoding)
    row = struct.Struct("<" + "".join(kind for _, kind in columns))
    values = list(zip(*row.iter_unpack(data[end : end + count * row.size])))
    return {name: array.array(kind, v) for (name, kind), v in zip(columns, values)}


VTK_KINDS = {
    "Int8": "b", "UInt8": "B", "Int16": "h", "UInt16": "H", "Int32": "i", "UInt32": "I",
    "Int64": "q", "UInt64": "Q", "Float32": "f", "Float64": "d",
}  # fmt: skip


def read_vtp(data):
    """The arrays of the points of a VTK XML file with raw appended data, as Freshet writes it.
    Vectors become columns: "Points" becomes x, y, z, "velocity" vx, vy, vz."""
    start = data.index(b'<AppendedData encoding="raw">')
    start = data.index(b"_", start) + 1
    columns = {}
    head = data[: data.index(b"<Verts>")].decode("ascii", "replace")
    for element in re.findall(r"<DataArray ([^>]*)/>", head):
        about = dict(re.findall(r'(\w+)="([^"]*)"', element))
        place = start + int(about["offset"])
        size = struct.unpack_from("<Q", data, place)[0]
        values = numbers(VTK_KINDS[about["type"]], data[place + 8 : place + 8 + size])
        name, parts = about["Name"], int(about.get("NumberOfComponents", 1))
        if parts == 1:
            columns[name] = values
        elif parts == 3:
            prefix = {"Points": "", "velocity": "v"}.get(name, name + "_")
            for k in range(3):
                columns[prefix + "xyz"[k]] = values[k::3]
    return columns


class Points:
    """Positions and velocities (3 floats a point, velocities or None), and other columns."""

    def __init__(self, columns):
        self.count = len(columns["x"])
        self.positions = self.together([columns[c] for c in "xyz"])
        has_velocities = all("v" + c in columns for c in "xyz")
        self.velocities = self.together([columns["v" + c] for c in "xyz"]) if has_velocities else None
        self.columns = columns

    def together(self, parts):
        values = array.array("f", bytes(12 * self.count))
        for k, part in enumerate(parts):
            values[k::3] = array.array("f", part)
        return values


def read_points(file):
    """The points of a PLY or a VTP file of Freshet: a data file, or one of foam and spray."""
    try:
        with open(file, "rb") as stream:
            data = stream.read()
        columns = read_vtp(data) if file.endswith(".vtp") else read_ply(data)
        return Points(columns or {c: [] for c in "xyz"})
    except (OSError, ValueError, KeyError, IndexError, struct.error) as error:
        raise FileError("%s: not a file of points of Freshet: %s" % (file, error)) from error
