// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "command.h"
#include "freshet/solver_method.h"
#include "freshet/suggest.h"
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

void KeyArguments::add_to(const Command& command, const std::string& keys) {
  command.option("--set", set, fmt::format("change {} (VALUE is TOML, else a string)", keys))
      .value("KEY=VALUE")
      .repeatable_value();
  command.option("--unset", unset, fmt::format("remove {}, so that its default applies", keys))
      .value("KEY")
      .repeatable_value();
}

std::vector<Override> KeyArguments::overrides() const {
  std::vector<Override> all;
  for (const std::string& key : unset) {
    if (key.find('=') != std::string::npos)
      throw Error(Error::Kind::scene, "--unset " + key, "write a key without a value");
    all.emplace_back(key, std::nullopt);
  }
  for (const std::string& pair : set) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos)
      throw Error(Error::Kind::scene, "--set " + pair, "write KEY=VALUE, for example time.end=1");
    all.emplace_back(pair.substr(0, equals), pair.substr(equals + 1));
  }
  return all;
}

void ChangeArguments::add_to(const Command& command) {
  KeyArguments::add_to(command);
  command.option("--threads", threads, "threads of the cpu backend (default: all)").at_least(1);
  command.option("--isa", isa, "instruction set of the cpu backend (default: the best)")
      .one_of({"plain", "sse42", "avx2", "avx512"});
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const SolverMethod* m : solver_methods()) names.emplace_back(m->name);
  return names;
}

void SceneArguments::add_to(const Command& command) {
  command.option("SCENE", name, "a scene file, or the name of a bundled scene").required();
  command
      .option("--solver", solver,
              "another solver than the scene's; keys that it does not use are dropped")
      .one_of(solver_names());
  command.option("--backend", backend, "the backend that computes").one_of({"cpu", "reference"});
  ChangeArguments::add_to(command);
}

SceneChange SceneArguments::change() const {
  auto all = overrides();
  if (!backend.empty()) all.emplace_back("solver.backend", fmt::format("\"{}\"", backend));
  if (solver.empty()) return {std::move(all), {}};
  if (is_foreign_scene(find_scene(name)))
    throw Error(Error::Kind::scene, "option solver " + solver,
                "changes scenes in TOML only; write the scene by `freshet import`, and run that");
  return change_solver(find_scene(name), solver, all);
}

Scene SceneArguments::load() const {
  const SceneChange c = change();
  print_diagnostics(c.dropped);
  const fs::path file = find_scene(name);
  if (!is_foreign_scene(file)) return load_scene(file, c.overrides);
  const ImportedScene imported = import_foreign(file, file.parent_path());
  print_notes(imported.notes);
  return load_converted(imported, file, c.overrides);
}

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

namespace {

/// The scene files in the folder of the file `name`, with that folder before their names.
std::set<std::string, std::less<>> scene_files_beside(const fs::path& name) {
  std::set<std::string, std::less<>> files;
  const fs::path folder = name.has_parent_path() ? name.parent_path() : fs::path(".");
  std::error_code ec;
  for (fs::directory_iterator entry(folder, ec), end; !ec && entry != end; entry.increment(ec))
    if (entry->path().extension() == ".toml")
      files.insert((name.parent_path() / entry->path().filename()).string());
  return files;
}

}  // namespace

fs::path find_scene(const std::string& name) {
  std::error_code ec;
  if (fs::is_regular_file(name, ec)) return name;
  std::set<std::string, std::less<>> known;
  for (const auto& [scene, file] : scenes_that_come_along()) {
    if (scene == name) return file;
    known.insert(scene);
  }
  if (fs::exists(name, ec)) return name;  // a folder, for example: loading it reports the error
  if (known.empty())
    throw Error(
        Error::Kind::scene, name,
        "no such file, and this program finds no bundled scenes; check the path, or install "
        "the program with its scenes (cmake --install)");
  const std::set<std::string, std::less<>> files = scene_files_beside(name);
  const std::string guess = nearest(name, known), file = nearest(name, files);
  throw Error(Error::Kind::scene, name,
              fmt::format("no such file, and no bundled scene of that name; {}",
                          !file.empty() ? fmt::format("did you mean {}?", file)
                          : !guess.empty()
                              ? fmt::format("did you mean {}? `freshet scenes` lists them", guess)
                              : "check the path; `freshet scenes` lists the bundled scenes"));
}

namespace {

/// "--set time.end=..." for "time.end", "--unset time.end" for "removal time.end", "--output" for
/// "output".
std::string command_line_of(const std::string& option) {
  if (option.starts_with("removal ")) return "--unset " + option.substr(8);
  return option.find('.') == std::string::npos ? "--" + option : "--set " + option + "=...";
}

}  // namespace

Diagnostic in_command_line_words(Diagnostic d) {
  if (d.place.starts_with("override ")) d.place.replace(0, 9, "--set ");
  if (d.place.starts_with("removal ")) d.place.replace(0, 8, "--unset ");
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
