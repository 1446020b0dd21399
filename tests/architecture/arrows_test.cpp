// SPDX-License-Identifier: MIT
// The dependency arrows of docs/architecture.md, read from the includes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;

/// The table of arrows: what each folder of src/, apps/validate, web and python may include besides
/// itself and the standard library, folders or single headers. "api" stands for include/freshet.
/// docs/architecture.md draws the arrows between folders.
const std::map<std::string, std::set<std::string>> arrows{
    {"core", {"api"}},
    {"kernels", {"core", "freshet/methods.h"}},
    {"pairs", {"core", "kernels"}},
    {"boundary", {"core"}},
    {"solvers",
     {"core", "kernels", "pairs", "boundary", "freshet/methods.h", "freshet/time_step.h",
      "freshet/whitewater.h"}},
    {"forces",
     {"core", "pairs", "boundary", "solvers", "freshet/methods.h", "freshet/time_step.h"}},
    {"engine",
     {"core", "kernels", "pairs", "boundary", "solvers", "forces", "backend", "bodies",
      "freshet/error.h", "freshet/frame.h", "freshet/methods.h", "freshet/particles.h",
      "freshet/real.h", "freshet/report.h", "freshet/state_array.h", "freshet/time_step.h",
      "freshet/vector.h", "freshet/whitewater.h", "fmt"}},
    {"methods", {"api"}},
    {"formats", {"api", "core", "fmt", "pugixml.hpp", "zlib.h"}},
    {"mesh", {"api", "core", "formats", "assimp", "fmt"}},
    {"scene",
     {"api", "core", "kernels", "boundary", "formats", "mesh", "toml++", "fmt", "muParser.h",
      "emscripten"}},
    {"bodies",
     {"api", "boundary", "core", "mesh", "scene", "btBulletDynamicsCommon.h", "BulletCollision",
      "BulletDynamics"}},
    {"render", {"api", "boundary", "cairo", "core", "fmt", "mesh", "scene", "spng.h", "surface"}},
    {"surface", {"api", "backend/cpu/threads.h", "core", "fmt", "meshoptimizer.h"}},
    {"import", {"api", "core", "fmt", "mesh", "nlohmann", "pugixml.hpp", "scene"}},
    {"io",
     {"api", "core", "render", "surface", "formats", "fmt", "nlohmann", "hdf5.h", "commit.h",
      "gif_lib.h", "webp"}},
    {"backend", {"api", "core", "boundary"}},
    {"backend/reference", {"api", "core", "backend"}},
    {"backend/cpu", {"api", "core", "backend", "omp.h", "immintrin.h"}},
    {"backend/cuda", {"core", "kernels", "solvers"}},
    {"sim",
     {"api", "bodies", "core", "kernels", "pairs/akinci2013.h", "boundary", "scene", "engine",
      "solvers/solve.h", "fmt"}},
    {"run", {"api", "core", "scene", "sim", "render", "surface", "io", "fmt", "nlohmann"}},
    {"validate",
     {"api", "core", "scene", "render", "run", "fmt", "toml++", "nlohmann", "openssl",
      "muParser.h"}},
    {"web", {"api", "core", "draw", "render", "view", "fmt", "emscripten"}},
    {"python", {"api", "pybind11"}},
    {"view", {"api", "core", "io", "mesh", "render", "run", "scene", "sim", "fmt", "toml++"}},
    {"draw", {"api", "render", "view", "GL", "GLES3"}},
    {"window",
     {"api", "draw", "io", "render", "run", "scene", "view", "fmt", "GLFW", "backends", "imgui.h",
      "imgui_impl_glfw.h", "imgui_impl_opengl3.h", "imgui_stdlib.h"}},
};

bool is_system(const std::string& include) {
  static const std::set<std::string> posix{"unistd.h", "fcntl.h", "spawn.h"};
  return include.find_first_of("./") == std::string::npos || include.starts_with("sys/") ||
         posix.contains(include);
}

/// The folder of a path: its first component, or backend/NAME.
std::string folder_of(const std::string& path) {
  const std::size_t first = path.find('/'), second = path.find('/', first + 1);
  const std::string folder = path.substr(0, first);
  if (folder == "freshet") return "api";
  return folder == "backend" && second != std::string::npos ? path.substr(0, second) : folder;
}

/// The sources below src/, those of the Python module, and the two programs that include internal
/// headers: by path relative to src/, apps/ or the root.
std::map<fs::path, fs::path> sources() {
  std::map<fs::path, fs::path> files;
  for (const fs::path below : {"src", "apps/validate", "./web", "./python"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / below)) {
      const std::string extension = entry.path().extension();
      if (extension == ".h" || extension == ".cpp" || extension == ".cu")
        files[fs::relative(entry.path(), fs::path(SOURCE_DIR) / *below.begin())] = entry.path();
    }
  return files;
}

TEST(Architecture, EveryIncludeFollowsAnArrow) {
  const std::regex line("\\s*#include [\"<]([^\">]+)[\">].*");
  int read = 0;
  for (const auto& [relative, file] : sources()) {
    const std::string folder = folder_of(relative);
    ASSERT_TRUE(arrows.contains(folder)) << folder << " is not in the table of arrows";
    std::ifstream in(file);
    std::smatch match;
    for (std::string text; std::getline(in, text);) {
      if (!std::regex_match(text, match, line) || is_system(match[1])) continue;
      const std::string to = folder_of(match[1]);
      const auto& may = arrows.at(folder);
      EXPECT_TRUE(to == folder || may.contains(to) || may.contains(match[1]))
          << relative << " includes " << match[1];
      ++read;
    }
  }
  EXPECT_GT(read, 50);
}

/// The arrows between the folders, one per line, as Mermaid draws them.
std::string diagram() {
  std::string lines;
  for (const auto& [from, may] : arrows) {
    std::set<std::string> to;
    for (const std::string& include : may) {
      const std::string folder = arrows.contains(include) ? include : folder_of(include);
      if (arrows.contains(folder)) to.insert(folder);
    }
    for (const std::string& folder : to) lines += "  " + from + " --> " + folder + "\n";
  }
  return lines;
}

TEST(Architecture, DocumentDrawsEveryArrow) {
  std::ifstream in(SOURCE_DIR "/docs/architecture.md");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_NE(text.find("flowchart TD\n" + diagram() + "```"), std::string::npos)
      << "docs/architecture.md must draw these arrows:\n"
      << diagram();
}

bool reaches(const std::string& from, const std::string& to, std::set<std::string>& seen) {
  if (!seen.insert(from).second) return false;
  for (const std::string& next : arrows.at(from))
    if (arrows.contains(next) && (next == to || reaches(next, to, seen))) return true;
  return false;
}

TEST(Architecture, NoArrowPointsBack) {
  for (const auto& [folder, may] : arrows) {
    std::set<std::string> seen;
    EXPECT_FALSE(reaches(folder, folder, seen)) << folder;
  }
}

TEST(Architecture, LibraryDoesNotPrintOrExit) {
  const std::regex forbidden(
      "std::(cout|cerr|clog|printf|puts)|fmt::print|\\bv?f?printf\\(|\\bf?put(s|c|char)\\(|"
      "\\b(stdout|stderr)\\b|\\b(exit|abort)\\(");
  for (const auto& [relative, file] : sources()) {
    std::ifstream in(file);
    for (std::string text; std::getline(in, text);)
      EXPECT_FALSE(std::regex_search(text, forbidden)) << relative << ": " << text;
  }
}

TEST(Architecture, AppsIncludePublicHeadersOnly) {
  const std::regex line("\\s*#include \"([^\"]+)\".*");
  for (const auto& entry : fs::recursive_directory_iterator(SOURCE_DIR "/apps/freshet")) {
    std::ifstream in(entry.path());
    std::smatch match;
    for (std::string text; std::getline(in, text);)
      if (std::regex_match(text, match, line) && match[1].str().find('/') != std::string::npos) {
        EXPECT_TRUE(match[1].str().starts_with("freshet/") || match[1] == "validate/validate.h" ||
                    match[1] == "window/window.h")
            << entry.path() << ": " << text;
      }
  }
}

}  // namespace
