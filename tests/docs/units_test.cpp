// SPDX-License-Identifier: MIT
/// Every text has the system of units of freshet/units.h.
#include "freshet/units.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace freshet::test {
namespace {

namespace fs = std::filesystem;

TEST(Units, ArePerMetreOfDepthIn2D) {
  const Units slice = units_in(2), solid = units_in(3);
  for (const auto& quantity : {&Units::force, &Units::torque, &Units::momentum, &Units::energy,
                               &Units::mass, &Units::inertia}) {
    const std::string unit = solid.*quantity;
    EXPECT_EQ((unit.find('/') == unit.npos ? unit : "(" + unit + ")") + "/m", slice.*quantity);
  }
  for (const auto& quantity : {&Units::density, &Units::pressure, &Units::speed, &Units::length})
    EXPECT_STREQ(solid.*quantity, slice.*quantity);
  EXPECT_STREQ("m^2", slice.volume);  // m^3/m
  EXPECT_EQ("kg m²/m", raised_unit(slice.inertia));
}

/// The files of the project that name units, by path.
std::vector<fs::path> texts() {
  std::vector<fs::path> all{fs::path(SOURCE_DIR) / "README.md",
                            fs::path(SOURCE_DIR) / "README.zh-CN.md"};
  for (const char* below : {"apps", "docs", "examples", "include", "scenes", "src", "validation"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / below))
      if (entry.is_regular_file() &&
          std::regex_match(entry.path().extension().string(),
                           std::regex(R"(\.(h|cpp|cu|md|json|toml|py))")))
        all.push_back(entry.path());
  return all;
}

TEST(Units, NoTextHasAMassPerArea) {
  const std::regex area(R"(kg/m((\^|\*\*)?[2D]|²))"), older(R"(plot_tables\.cpp$|tables\.md$)");
  int older_units = 0;
  for (const fs::path& file : texts()) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      if (!std::regex_search(line, area)) continue;
      if (std::regex_search(file.string(), older)) ++older_units;
      else ADD_FAILURE() << file << ": " << line;
    }
  }
  EXPECT_EQ(3, older_units) << "the units that older versions wrote";
}

}  // namespace
}  // namespace freshet::test
