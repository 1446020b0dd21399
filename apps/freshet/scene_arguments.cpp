// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "command.h"
#include "print.h"

namespace freshet::cli {

namespace fs = std::filesystem;

std::vector<fs::path> folders_that_come_along(const std::string& name) {
  std::error_code ec;
  fs::path folder = fs::read_symlink("/proc/self/exe", ec).parent_path();
  std::vector<fs::path> all{folder / "../share/freshet" / name};
  for (; folder.has_relative_path(); folder = folder.parent_path()) all.push_back(folder / name);
  return all;
}

void ChangeArguments::add_to(const Command& command) {
  command.option("--set", set, "KEY=VALUE: change a key of the scene (TOML, else a string)")
      .repeatable_value();
  command.option("--threads", threads, "threads of the cpu backend (default: all)").at_least(1);
  command.option("--isa", isa, "instruction set of the cpu backend (default: the best)")
      .one_of({"plain", "sse42", "avx2", "avx512"});
}

std::vector<Override> overrides_of(const std::vector<std::string>& set) {
  std::vector<Override> all;
  for (const std::string& pair : set) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos)
      throw Error(Error::Kind::scene, "--set " + pair, "write KEY=VALUE, for example time.end=1");
    all.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
  }
  return all;
}

void SceneArguments::add_to(const Command& command) {
  command.option("SCENE", name, "a scene file, or the name of a bundled scene").required();
  command.option("--backend", backend, "the backend that computes").one_of({"cpu", "reference"});
  ChangeArguments::add_to(command);
}

std::vector<Override> SceneArguments::overrides() const {
  auto all = ChangeArguments::overrides();
  if (!backend.empty()) all.emplace_back("solver.backend", fmt::format("\"{}\"", backend));
  return all;
}

Scene SceneArguments::load() const { return load_scene(find_scene(name), overrides()); }

std::vector<std::pair<std::string, fs::path>> scenes_that_come_along() {
  std::vector<std::pair<std::string, fs::path>> all;
  for (const fs::path& folder : folders_that_come_along("scenes")) {
    std::error_code ec;
    for (const auto& entry : fs::recursive_directory_iterator(folder, ec))
      if (entry.path().extension() == ".toml") {
        const fs::path name = fs::relative(entry.path(), folder).replace_extension();
        all.emplace_back(name.string(), fs::weakly_canonical(entry.path()));
      }
    if (!all.empty()) break;
  }
  std::sort(all.begin(), all.end());
  return all;
}

fs::path find_scene(const std::string& name) {
  std::error_code ec;
  if (fs::is_regular_file(name, ec)) return name;
  std::string known;
  for (const auto& [scene, file] : scenes_that_come_along()) {
    if (scene == name) return file;
    known += (known.empty() ? "" : ", ") + scene;
  }
  if (fs::exists(name, ec)) return name;  // a folder, say: loading it tells what is wrong
  throw Error(
      Error::Kind::scene, name,
      fmt::format("no such file, and no scene of that name comes along ({}); check the path",
                  known));
}

namespace {

/// "--set time.end=..." for "time.end", "--output" for "output".
std::string command_line_of(const std::string& option) {
  return option.find('.') == std::string::npos ? "--" + option : "--set " + option + "=...";
}

}  // namespace

Diagnostic in_command_line_words(Diagnostic d) {
  if (d.place.starts_with("override ")) d.place.replace(0, 9, "--set ");
  if (d.place.starts_with("option ")) d.place.replace(0, 7, "--");
  for (const std::string& option : d.options) {
    const std::string quoted = "`" + option + "`";
    for (std::size_t at; (at = d.message.find(quoted)) != std::string::npos;)
      d.message.replace(at, quoted.size(), command_line_of(option));
  }
  return d;
}

void print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  for (const Diagnostic& d : diagnostics) {
    Diagnostic shown = in_command_line_words(d);
    shown.place = printable(shown.place);  // a file name may hold line ends
    print_error("{}\n", shown.text());
  }
}

}  // namespace freshet::cli
