// SPDX-License-Identifier: MIT
/// docs/tables.md has every column that a run writes, with its unit in 2D and in 3D, and no other.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "cli/files.h"
#include "freshet/run.h"
#include "io/frame_data.h"
#include "run/body_table.h"
#include "run/observables.h"
#include "run/percentile_table.h"

namespace freshet::test {
namespace {

using Units = std::map<std::string, std::set<std::string>>;  // "momentum A" -> units

std::vector<std::string> cells_of(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, separator);) {
    const auto first = cell.find_first_not_of(" \n");
    cells.push_back(
        first == cell.npos ? "" : cell.substr(first, cell.find_last_not_of(" \n") - first + 1));
  }
  return cells;
}

/// The columns of a section of the page, with their units in so many dimensions.
Units columns_on_the_page(const std::string& section, int dimension) {
  std::ifstream in(std::string(SOURCE_DIR) + "/docs/tables.md");
  Units all;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) inside = line == "## " + section;
    if (!inside || !line.starts_with("| `")) continue;
    const auto cells = cells_of(line, '|');  // the first one is empty
    for (const std::string& name : cells_of(cells[1], ','))
      all[name.substr(1, name.size() - 2)].insert(cells[dimension == 3 ? 3 : 2]);
  }
  return all;
}

void replace(std::string& text, const std::string& part, const std::string& by) {
  if (const auto at = text.find(part); at != std::string::npos) text.replace(at, part.size(), by);
}

/// Adds the columns of a header. Names of the scene and axes are those of the page.
void add(Units& all, const std::string& header, const Scene& scene) {
  for (std::string name : cells_of(header, ',')) {
    std::string unit;
    if (const auto bracket = name.find(" ["); name.ends_with("]")) {
      unit = name.substr(bracket + 2, name.size() - bracket - 3);
      name.resize(bracket);
    }
    for (const std::string& flow : scene.flow_names()) replace(name, " " + flow, " FLOW");
    for (const std::string& wall : scene.wall_names()) replace(name, " " + wall + " ", " WALL ");
    for (std::size_t k = 0; k < scene.body.size(); ++k)
      replace(name, " " + scene.body_name(k) + " ", " NAME ");
    for (const std::string axis : {" x", " y", " z"})
      for (const char* end : {"", " min", " max", " mean", " integral", " p01", " p99"})
        if (name.ends_with(axis + end)) {
          if (std::string(end).starts_with(" m") || std::string(end) == " integral")
            replace(name, " WALL ", " NAME ");
          replace(name, axis + end, std::string(" A") + end);
        }
    all[name].insert(unit);
  }
}

Scene empty_scene(int dimension) {
  Scene scene;
  scene.domain.max.assign(std::size_t(dimension), 1.0);
  scene.domain.min.assign(std::size_t(dimension), 0.0);
  return scene;
}

Units columns_of_observables(int dimension) {
  Units all;
  Scene scene = empty_scene(dimension);
  scene.inlet.resize(1);
  scene.outlet.resize(1);
  scene.counter.resize(1);
  scene.wall.resize(1);
  scene.body.resize(1);
  scene.output.statistics = true;
  for (const SolverMethod* solver : solver_methods())
    for (const auto viscosity : {ViscosityMethod::monaghan2005, ViscosityMethod::weiler2018}) {
      scene.solver.name = solver->solver;
      scene.solver.viscosity_method = viscosity;
      add(all, observables_header(scene), scene);
    }
  return all;
}

class TablesPage : public testing::TestWithParam<int> {};

TEST_P(TablesPage, HasTheColumnsOfObservables) {
  EXPECT_EQ(columns_on_the_page("observables.csv", GetParam()), columns_of_observables(GetParam()));
}

TEST_P(TablesPage, HasTheColumnsOfBodies) {
  Scene scene = empty_scene(GetParam());
  scene.body.resize(1);
  Units all;
  std::string header = body_header(scene);
  replace(header, "x [m],y [m],z [m]", "X [m],Y [m],Z [m]");  // not axes of a vector's column
  add(all, header, scene);
  Units page;
  for (const auto& [name, units] : columns_on_the_page("bodies.csv", GetParam()))
    page[name == "x" ? "X" : name == "y" ? "Y" : name == "z" ? "Z" : name] = units;
  EXPECT_EQ(page, all);
}

TEST_P(TablesPage, HasTheColumnsOfPercentiles) {
  const Scene scene = empty_scene(GetParam());
  Units all;
  add(all, percentile_header(scene), scene);
  EXPECT_EQ(columns_on_the_page("percentiles.csv", GetParam()), all);
}

/// A scene with every kind of table and probe.
Scene scene_with_all_tables(int dimension) {
  std::string text = R"(
domain.max = [1, 1Z]
particles.spacing = 0.1
solver = { name = "wcsph", sound_speed = 30.0 }
walls.method = "adami2012"
time = { end = 0.002, step = 1e-3 }
picture = { width = 64, height = 48 }
output = { statistics = true, data = ["csv"], frame_every = 0.002, observables_every = 0.002 }
fluid = { min = [0, 0O], max = [1, 0.3Z] }
[[body]]
min = [0.3, 0.6L]
max = [0.7, 0.9H]
motion = "fixed"
[[counter]]
center = [0.5, 0.1O]
direction = [1, 0O]
[[probe]]
name = "point"
at = [0.1, 0.1L]
[[probe]]
name = "line"
kind = "line"
from = [0.1, 0L]
to = [0.5, 0H]
[[probe]]
name = "plane"
kind = "plane"
from = [0.1, 0.0L]
to = [0.5, 0.3L]
[[probe]]
name = "surface"
kind = "surface"
from = [0.1, 0L]
to = [0.1, 0.5L]
[[probe]]
name = "wall"
kind = "wall"
from = [0.1, 0L]
to = [0.5, 0H]
)";
  const bool solid = dimension == 3;
  const std::pair<char, const char*> thirds[] = {
      {'Z', ", 1"}, {'O', ", 0"}, {'L', ", 0.1"}, {'H', ", 0.5"}};
  for (const auto& [letter, third] : thirds)
    for (auto at = text.find(std::string(1, letter) + "]"); at != text.npos;
         at = text.find(std::string(1, letter) + "]"))
      text.replace(at, 1, solid ? third : "");
  return parse_scene(text, "tables.toml");
}

/// The section of the page about a table of a run.
std::string section_of(const fs::path& file) {
  const std::string folder = file.parent_path().string();
  if (folder == "probes") return "probes/NAME.csv";
  return folder == "data" ? "data/frame_0000.csv" : file.string();
}

/// Every CSV file that a run writes, by its section of the page.
TEST_P(TablesPage, HasEveryTableOfARun) {
  const TemporaryFolder folder;
  const Scene scene = scene_with_all_tables(GetParam());
  RunOptions options;
  options.output = folder / "run";
  options.scene_name = "tables";
  options.execution.threads = 1;
  run(scene, options);
  std::map<std::string, Units> tables;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "run")) {
    if (entry.path().extension() != ".csv") continue;
    const std::string section = section_of(entry.path().lexically_relative(folder / "run"));
    std::string header = lines_of(read_text(entry.path())).at(0);
    for (const char* axis : {",x [m]", ",y [m]", ",z [m]"})
      if (section == "probes/NAME.csv") replace(header, axis, ",A [m]");
    add(tables[section], header, scene);
  }
  std::set<std::string> sections;
  for (const auto& [section, columns] : tables) sections.insert(section);
  EXPECT_EQ((std::set<std::string>{"bodies.csv", "data/frame_0000.csv", "observables.csv",
                                   "percentiles.csv", "probes/NAME.csv"}),
            sections);
  EXPECT_EQ(columns_on_the_page("probes/NAME.csv", GetParam()), tables["probes/NAME.csv"]);
  for (const char* section : {"bodies.csv", "observables.csv", "percentiles.csv"}) {
    const Units page = columns_on_the_page(section, GetParam());
    for (const auto& [name, units] : tables[section]) {
      const auto row = page.find(name);
      EXPECT_TRUE(row != page.end() && row->second == units) << section << ": " << name;
    }
  }
}

TEST_P(TablesPage, HasTheColumnsOfDataFiles) {
  Frame frame;
  frame.dimension = GetParam();
  frame.id = {0};
  frame.x = frame.v = {0, 0, 0};
  frame.density = frame.pressure = {0};
  frame.liquid = {0};
  const std::string text = encode_csv(frame);
  std::set<std::string> names, page;
  for (std::string name : cells_of(text.substr(0, text.find('\n')), ',')) {
    for (const std::string axis : {"x", "y", "z"})
      if (name == axis || name == "v" + axis) name.replace(name.size() - 1, 1, "A");
    names.insert(name);
  }
  for (const auto& [name, units] : columns_on_the_page("data/frame_0000.csv", GetParam()))
    page.insert(name);
  EXPECT_EQ(page, names);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, TablesPage, testing::Values(2, 3));

}  // namespace
}  // namespace freshet::test
