// SPDX-License-Identifier: MIT
/// What the subcommands share.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "command_line.h"
#include "freshet/import.h"
#include "freshet/simulation.h"

namespace freshet::cli {

/// The keys that a command sets and removes.
struct KeyArguments {
  std::vector<std::string> set;  // KEY=VALUE
  std::vector<std::string> unset;

  /// `keys`: which keys, for the help text.
  void add_to(const Command& command, const std::string& keys = "a key of the scene");
  /// Keys are removed before others are set.
  std::vector<Override> overrides() const;
};

/// What a command changes in a scene, and what it computes with.
struct ChangeArguments : KeyArguments {
  std::string isa;
  int threads = 0;

  void add_to(const Command& command);
  Execution execution() const { return {threads, isa}; }
};

std::vector<std::string> solver_names();

/// The scene of a command with what is changed in it.
struct SceneArguments : ChangeArguments {
  std::string name, backend, solver;

  void add_to(const Command& command);
  /// What the arguments change, and the keys that --solver drops.
  SceneChange change() const;
  /// The changed scene; prints the keys that --solver drops.
  Scene load() const;
};

/// Each adds its subcommand to the program.
void add_run(Program& program, const std::vector<std::string>& command_line);
void add_resume(Program& program, const std::vector<std::string>& command_line);
void add_render(Program& program);
void add_measure(Program& program);
void add_surface(Program& program);
void add_film(Program& program);
void add_view(Program& program);
void add_new(Program& program);
void add_import(Program& program);
void add_check(Program& program);
void add_info(Program& program);
void add_scenes(Program& program);
void add_bench(Program& program);
void add_plot(Program& program);
void add_validate(Program& program);
void add_schema(Program& program);
void add_completion(Program& program);
void add_complete(Program& program);
void add_manual(Program& program);

/// The file of a scene: a file of that name, else the bundled scene.
std::filesystem::path find_scene(const std::string& name);
/// Where what comes along may lie, `name` below a folder: installed beside the program, or in the
/// sources above a build tree.
std::vector<std::filesystem::path> folders_that_come_along(const std::string& name);
/// The bundled scenes, by name.
std::vector<std::pair<std::string, std::filesystem::path>> scenes_that_come_along();

/// Whether the file is a scene of another program, by its extension: *.json or *.xml.
bool is_foreign_scene(const std::filesystem::path& file);
/// Converts such a scene. Files are named relative to `folder`.
ImportedScene import_foreign(const std::filesystem::path& file,
                             const std::filesystem::path& folder);
/// Loads a converted scene. Messages name the file and lines of the TOML.
Scene load_converted(const ImportedScene& imported, const std::filesystem::path& file,
                     const std::vector<Override>& overrides);
/// Prints what a conversion takes instead; keys of the other program's window are one line.
void print_notes(const std::vector<ImportNote>& notes);

/// The bundled validation cases.
std::vector<std::string> case_names();

/// The options and overrides of a diagnostic as the command line spells them.
Diagnostic in_command_line_words(Diagnostic diagnostic);
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

}  // namespace freshet::cli
