// SPDX-License-Identifier: MIT
/// Copies a bundled scene, with the files that it reads, to start a scene of one's own from.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

#include "command.h"
#include "print.h"
#include "whole_file.h"

namespace freshet::cli {
namespace {

namespace fs = std::filesystem;

struct NewArguments {
  std::string scene, file;
};

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw Error(Error::Kind::run, file.string(), why);
}

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) fail(file, fmt::format("cannot be read: {}", std::strerror(errno)));
  return text;
}

/// The files that a scene reads, relative to it.
std::set<fs::path> inputs_of(const Scene& scene, const fs::path& folder) {
  std::set<fs::path> all;
  const auto add = [&](const std::string& file) {
    if (!file.empty()) all.insert(fs::path(file).lexically_relative(folder));
  };
  for (const Scene::Fluid& f : scene.fluid) add(f.file);
  for (const Scene::Wall& w : scene.wall) add(w.file);
  for (const Scene::Body& b : scene.body) {
    add(b.file);
    add(b.path);
  }
  return all;
}

/// The copies, by their place, and the scene last. Throws Error (kind scene) if a file of another
/// content is in the way.
std::vector<std::pair<fs::path, std::string>> copies(const fs::path& scene, const fs::path& file) {
  const fs::path from = scene.lexically_normal().parent_path(), to = file.parent_path();
  std::vector<std::pair<fs::path, std::string>> all;
  for (const fs::path& input : inputs_of(load_scene(scene), from)) {
    if (input.is_absolute() || *input.begin() == "..")
      throw Error(Error::Kind::scene, scene.string(),
                  fmt::format("reads {}, which is not below its folder; copy both by hand",
                              input.string()));
    all.emplace_back(to / input, read(from / input));
  }
  all.emplace_back(file, read(scene));
  for (const auto& [path, text] : all) {
    if (!fs::exists(fs::symlink_status(path))) continue;
    if (path != file && fs::is_regular_file(path) && read(path) == text) continue;
    throw Error(Error::Kind::scene, path.string(),
                fs::is_directory(path)
                    ? fmt::format("exists already and is a folder; name a file, such as {}",
                                  (path / scene.filename()).string())
                    : "exists already; choose another FILE");
  }
  return all;
}

}  // namespace

void add_new(Program& program) {
  const auto a = std::make_shared<NewArguments>();
  const Command command =
      program.add("new", "Copy a bundled scene, with the files that it reads, to change it");
  command.option("SCENE", a->scene, "the name of a bundled scene, or a scene file").required();
  command.option("FILE", a->file, "the new scene file").required();
  command.footer("Example:\n  freshet new dam_break_2d my_scene.toml");
  command.action([a] {
    for (const auto& [file, text] : copies(find_scene(a->scene), a->file)) {
      write_whole(file, text);
      print_out("wrote {}\n", printable(file.string()));
    }
    return done;
  });
}

}  // namespace freshet::cli
