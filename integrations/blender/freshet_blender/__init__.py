# SPDX-License-Identifier: MIT
"""File > Import > Freshet run: a run of Freshet as a sequence. docs/blender.md describes it."""
bl_info = {
    "name": "Freshet",
    "description": "Imports fluid simulations of Freshet as sequences",
    "author": "The Freshet developers",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > Freshet run",
    "category": "Import-Export",
}

import os

import bpy
from bpy.props import BoolProperty, StringProperty

from . import files, sequence


class FreshetPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    command: StringProperty(
        name="Freshet program", default="freshet", subtype="FILE_PATH",
        description="Makes the surfaces of a run that has none for Blender yet",
    )  # fmt: skip

    def draw(self, _context):
        self.layout.prop(self, "command")


def command_of(context):
    addon = context.preferences.addons.get(__package__)
    return addon.preferences.command if addon else "freshet"


class ImportFreshet(bpy.types.Operator):
    """Import a run of Freshet: select its folder or a scene.json"""

    bl_idname = "import_scene.freshet"
    bl_label = "Import Freshet run"
    bl_options = {"REGISTER", "UNDO"}

    filepath: StringProperty(subtype="FILE_PATH")
    directory: StringProperty(subtype="DIR_PATH")
    filter_glob: StringProperty(default="scene.json;scene.toml", options={"HIDDEN"})
    particles: BoolProperty(
        name="Particles", default=False, description="Add the particles of the data files (PLY or VTP)"
    )
    surroundings: BoolProperty(
        name="Stage", default=True, description="Add floor, tank, light and camera, and set Cycles up"
    )

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context):
        path = self.filepath if os.path.exists(self.filepath) else self.directory
        try:
            sequence.import_run(path, command_of(context), self.particles, self.surroundings)
        except files.FileError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


def menu(self, _context):
    self.layout.operator(ImportFreshet.bl_idname, text="Freshet run")


def register():
    bpy.utils.register_class(FreshetPreferences)
    bpy.utils.register_class(ImportFreshet)
    bpy.types.TOPBAR_MT_file_import.append(menu)
    sequence.register()


def unregister():
    sequence.unregister()
    bpy.types.TOPBAR_MT_file_import.remove(menu)
    bpy.utils.unregister_class(ImportFreshet)
    bpy.utils.unregister_class(FreshetPreferences)
