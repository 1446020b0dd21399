// SPDX-License-Identifier: MIT
/// What the subcommands share.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "command_line.h"
#include "freshet/simulation.h"

namespace freshet::cli {

/// KEY=VALUE, each as an override.
std::vector<Override> overrides_of(const std::vector<std::string>& set);

/// What a command changes in a scene, and what it computes with.
struct ChangeArguments {
  std::vector<std::string> set;  // KEY=VALUE
  std::string isa;
  int threads = 0;

  void add_to(const Command& command);
  std::vector<Override> overrides() const { return overrides_of(set); }
  Execution execution() const { return {threads, isa}; }
};

/// The scene of a command with what is changed in it.
struct SceneArguments : ChangeArguments {
  std::string name, backend;

  void add_to(const Command& command);
  Scene load() const;
  std::vector<Override> overrides() const;
};

/// Each adds its subcommand to the program.
void add_run(Program& program, const std::vector<std::string>& command_line);
void add_resume(Program& program, const std::vector<std::string>& command_line);
void add_render(Program& program);
void add_check(Program& program);
void add_info(Program& program);
void add_scenes(Program& program);
void add_bench(Program& program);
void add_plot(Program& program);
void add_validate(Program& program);
void add_schema(Program& program);
void add_completion(Program& program);

/// The file of a scene: a file of that name, else the scene that comes along under it.
std::filesystem::path find_scene(const std::string& name);
/// Where what comes along may lie, `name` below a folder: installed beside the program, or in the
/// sources above a build tree.
std::vector<std::filesystem::path> folders_that_come_along(const std::string& name);
/// The scenes that come along, by name.
std::vector<std::pair<std::string, std::filesystem::path>> scenes_that_come_along();

/// The options and overrides of a diagnostic as the command line spells them.
Diagnostic in_command_line_words(Diagnostic diagnostic);
void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

}  // namespace freshet::cli
