// SPDX-License-Identifier: MIT
/// What the subcommands share.
#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "freshet/simulation.h"

namespace freshet::cli {

enum ExitCode { done = 0, failed = 1, usage = 2, interrupted = 130 };

/// KEY=VALUE, each as an override.
std::vector<Override> overrides_of(const std::vector<std::string>& set);

/// What a command changes in a scene, and what it computes with.
struct ChangeArguments {
  std::vector<std::string> set;  // KEY=VALUE
  std::string isa;
  int threads = 0;

  void add_to(CLI::App& command);
  std::vector<Override> overrides() const { return overrides_of(set); }
  Execution execution() const { return {threads, isa}; }
};

/// The scene of a command with what is changed in it.
struct SceneArguments : ChangeArguments {
  std::string name, backend;

  void add_to(CLI::App& command);
  Scene load() const;
  std::vector<Override> overrides() const;
};

/// Each adds its subcommand to the program; the callback's exit code goes to `code`.
void add_run(CLI::App& app, int& code, const std::vector<std::string>& command_line);
void add_resume(CLI::App& app, int& code, const std::vector<std::string>& command_line);
void add_render(CLI::App& app, int& code);
void add_check(CLI::App& app, int& code);
void add_info(CLI::App& app, int& code);
void add_scenes(CLI::App& app, int& code);
void add_bench(CLI::App& app, int& code);
void add_plot(CLI::App& app, int& code);
void add_validate(CLI::App& app, int& code);
void add_schema(CLI::App& app, int& code);
void add_completion(CLI::App& app, int& code);

/// The file of a scene: a file of that name, else the scene that comes along under it.
std::filesystem::path find_scene(const std::string& name);
/// Where what comes along may lie, `name` below a folder: installed beside the program, or in the
/// sources above a build tree.
std::vector<std::filesystem::path> folders_that_come_along(const std::string& name);
/// The scenes that come along, by name.
std::vector<std::pair<std::string, std::filesystem::path>> scenes_that_come_along();

void print_diagnostics(const std::vector<Diagnostic>& diagnostics);

}  // namespace freshet::cli
