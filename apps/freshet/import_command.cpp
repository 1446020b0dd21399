// SPDX-License-Identifier: MIT
/// Scenes of other programs: `import`, and commands that take such a scene as it is.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "command.h"
#include "freshet/import.h"
#include "print.h"
#include "whole_file.h"

namespace freshet::cli {
namespace {

namespace fs = std::filesystem;

struct ImportArguments {
  std::string program, scene, output;
};

/// The file that `import` writes without --output: the scene's name, in the current folder.
fs::path output_of(const ImportArguments& a) {
  return a.output.empty() ? fs::path(a.scene).stem().concat(".toml") : fs::path(a.output);
}

bool has_extension(const fs::path& file, const char* expected) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension == expected;
}

/// Writes the file. A scene that another program made is not overwritten.
int import_scene(const ImportArguments& a) {
  const fs::path file = output_of(a);
  if (fs::exists(fs::symlink_status(file)))
    throw Error(Error::Kind::scene, file.string(), "exists already; choose another `output`",
                {"output"});
  const fs::path from = a.scene, to = file.parent_path();
  const ImportedScene scene =
      a.program == "dualsphysics" ? import_dualsphysics(from, to) : import_splishsplash(from, to);
  print_notes(scene.notes);
  write_whole(file, scene.toml);
  print_out("wrote {}\n", printable(file.string()));
  const Scene checked = parse_scene(scene.toml, file.string());
  print_diagnostics(scene_warnings(checked));
  return done;
}

}  // namespace

bool is_foreign_scene(const fs::path& file) {
  return has_extension(file, ".json") || has_extension(file, ".xml");
}

ImportedScene import_foreign(const fs::path& file, const fs::path& folder) {
  return has_extension(file, ".xml") ? import_dualsphysics(file, folder)
                                     : import_splishsplash(file, folder);
}

Scene load_converted(const ImportedScene& imported, const fs::path& file,
                     const std::vector<Override>& overrides) {
  return parse_scene(imported.toml, file.string() + " as TOML", overrides);
}

void print_notes(const std::vector<ImportNote>& notes) {
  std::string shown, reason;
  for (const ImportNote& note : notes)
    if (note.kind == ImportNote::Kind::display) {
      shown += (shown.empty() ? "" : ", ") + note.key;
      reason = note.message;
    } else print_error("{}\n", printable(note.text()));
  if (!shown.empty()) print_error("note: {}, and without effect: {}\n", reason, printable(shown));
}

void add_import(Program& program) {
  const auto a = std::make_shared<ImportArguments>();
  const Command command =
      program.add("import", "Convert a scene of another program, and list what has no counterpart");
  command.option("PROGRAM", a->program, "the other program")
      .required()
      .one_of({"dualsphysics", "splishsplash"});
  command.option("SCENE", a->scene, "its scene file").value("FILE").required();
  command.option("-o,--output", a->output, "the scene file to write (default: SCENE.toml, here)")
      .value("FILE");
  command.footer(
      "Examples:\n  freshet import splishsplash DamBreakModel.json -o dam.toml\n"
      "  freshet import dualsphysics CaseDambreak_Def.xml -o dam.toml");
  command.action([a] { return import_scene(*a); });
}

}  // namespace freshet::cli
