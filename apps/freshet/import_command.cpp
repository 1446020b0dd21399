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

/// Writes the file. A scene that another program made is not overwritten.
int import_scene(const ImportArguments& a) {
  const fs::path file = output_of(a);
  if (fs::exists(fs::symlink_status(file)))
    throw Error(Error::Kind::scene, file.string(), "exists already; choose another `output`",
                {"output"});
  const ImportedScene scene = import_splishsplash(fs::path(a.scene), file.parent_path());
  print_notes(scene.notes);
  write_whole(file, scene.toml);
  print_out("wrote {}\n", printable(file.string()));
  const Scene checked = parse_scene(scene.toml, file.string());
  print_diagnostics(scene_warnings(checked));
  return done;
}

}  // namespace

bool is_json_scene(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension == ".json";
}

Scene load_converted(const ImportedScene& imported, const fs::path& file,
                     const std::vector<Override>& overrides) {
  return parse_scene(imported.toml, file.string() + " as TOML", overrides);
}

void print_notes(const std::vector<ImportNote>& notes) {
  std::string shown;
  for (const ImportNote& note : notes)
    if (note.kind == ImportNote::Kind::display) shown += (shown.empty() ? "" : ", ") + note.key;
    else print_error("{}\n", printable(note.text()));
  if (!shown.empty())
    print_error("note: only for the window and the files of SPlisHSPlasH, and without effect: {}\n",
                printable(shown));
}

void add_import(Program& program) {
  const auto a = std::make_shared<ImportArguments>();
  const Command command =
      program.add("import", "Convert a scene of another program, and list what has no counterpart");
  command.option("PROGRAM", a->program, "the other program").required().one_of({"splishsplash"});
  command.option("SCENE", a->scene, "its scene file").value("FILE").required();
  command.option("-o,--output", a->output, "the scene file to write (default: SCENE.toml, here)")
      .value("FILE");
  command.footer("Example:\n  freshet import splishsplash DamBreakModel.json -o dam.toml");
  command.action([a] { return import_scene(*a); });
}

}  // namespace freshet::cli
