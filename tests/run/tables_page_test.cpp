// SPDX-License-Identifier: MIT
/// docs/tables.md has every column that a run writes, with its unit in 2D and in 3D, and no other.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "io/frame_data.h"
#include "run/body_table.h"
#include "run/observables.h"
#include "sim/probes.h"

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
    for (const char* axis : {" x", " y", " z"})
      if (name.ends_with(axis)) name.replace(name.size() - 1, 1, "A");
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

TEST_P(TablesPage, HasTheColumnsOfProbes) {
  const std::string low = GetParam() == 3 ? "[0.1, 0.0, 0.1]" : "[0.1, 0.0]",
                    high = GetParam() == 3 ? "[0.5, 0.0, 0.5]" : "[0.5, 0.0]";
  const std::string line = "from = " + low + "\nto = " + high + "\n";
  const Scene scene = parse_scene(
      "[domain]\nmax = " + std::string(GetParam() == 3 ? "[1, 1, 1]" : "[1, 1]") +
          "\n[particles]\nspacing = 0.1\n[fluid]\nmin = " +
          (GetParam() == 3 ? "[0, 0, 0]\nmax = [1, 0.5, 1]" : "[0, 0]\nmax = [1, 0.5]") +
          "\n[solver]\nname = \"wcsph\"\n[time]\nend = 1\nstep = 1e-4\n"
          "[[probe]]\nat = " +
          low + "\n[[probe]]\nkind = \"line\"\n" + line + "[[probe]]\nkind = \"surface\"\n" + line +
          "[[probe]]\nkind = \"wall\"\n" + line,
      "test.toml");
  const Probes probes(scene);
  Units all;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    std::string header = probes.header(k);
    for (const char* axis : {",x [m]", ",y [m]", ",z [m]"}) replace(header, axis, ",A [m]");
    add(all, header, scene);
  }
  EXPECT_EQ(columns_on_the_page("probes/NAME.csv", GetParam()), all);
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
