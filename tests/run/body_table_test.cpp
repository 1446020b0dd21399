// SPDX-License-Identifier: MIT
/// `freshet render` places bodies by bodies.csv, so a damaged table must not pass.
#include "run/body_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cli/files.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

const Scene& two_bodies() {
  static const Scene scene = parse_scene(
      "domain.max = [1, 1]\nparticles.spacing = 0.05\ntime = { end = 1, step = 1e-3 }\n"
      "fluid = { min = [0, 0], max = [0.5, 0.3] }\nsolver.name = \"wcsph\"\n"
      "[[body]]\nname = \"a\"\nmin = [0.6, 0.1]\nmax = [0.7, 0.2]\nmotion = \"fixed\"\n"
      "[[body]]\nname = \"b\"\nmin = [0.8, 0.1]\nmax = [0.9, 0.2]\nmotion = \"fixed\"\n",
      "test.toml");
  return scene;
}

std::string row(int step, const std::string& body, const std::string& last = "0") {
  return std::to_string(step) + "," + std::to_string(step) + ".5," + body +
         ",1,2,3,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0," + last + "\n";
}

std::string refused(const std::string& rows) {
  try {
    read_bodies(body_header(two_bodies()) + rows, two_bodies(), "bodies.csv");
    return "no error";
  } catch (const Error& e) {
    const std::string words = e.what(),
                      remedy = "; put the table back as the run wrote it, or run the scene again";
    EXPECT_TRUE(words.ends_with(remedy)) << words;
    return words.substr(0, words.size() - std::min(words.size(), remedy.size()));
  }
}

TEST(ReadBodies, ReadsWhatARunWrites) {
  Simulation sim(two_bodies());
  std::string table = body_header(sim.scene());
  for (int k = 0; k < 2; ++k) {
    sim.step();
    table += body_lines(sim.frame(), sim.scene());
  }
  const auto times = read_bodies(table, sim.scene(), "bodies.csv");
  ASSERT_EQ(2u, times.size());
  const auto& [time, bodies] = *times.rbegin();
  EXPECT_NEAR(sim.time(), time, 1e-8);
  ASSERT_EQ(2u, bodies.size());
  EXPECT_NEAR(sim.bodies()[1].position[0], bodies[1].position[0], 1e-8);
  EXPECT_EQ(1, bodies[0].orientation[3]);
}

TEST(ReadBodies, SkipsALastTimeThatIsNotComplete) {
  const std::string whole = body_header(two_bodies()) + row(1, "a") + row(1, "b");
  for (const std::string& rest : {std::string(), row(2, "a"), row(2, "a") + "2,0.5,b,1,2",
                                  row(2, "a") + row(2, "b", "0.12").substr(0, 40)})
    EXPECT_EQ(1u, read_bodies(whole + rest, two_bodies(), "bodies.csv").size()) << rest;
}

TEST(ReadBodies, ReadsTheUnitsOfOlderVersionsIn2D) {
  std::string header = body_header(two_bodies());
  for (const char axis : {'x', 'y', 'z'}) {
    const std::string torque = fmt::format("torque {} [N m/m]", axis);
    ASSERT_NE(std::string::npos, header.find(torque));
    header.replace(header.find(torque), torque.size(), fmt::format("torque {} [N]", axis));
  }
  EXPECT_EQ(1u, read_bodies(header + row(1, "a") + row(1, "b"), two_bodies(), "b.csv").size());
}

TEST(ReadBodies, RejectsDamagedTables) {
  for (const char* table : {"", "step,time [s]\n", "no line end"}) try {
      read_bodies(table, two_bodies(), "bodies.csv");
      ADD_FAILURE() << table;
    } catch (const Error& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with(
          "bodies.csv:1: error: the first line does not name the columns of a table of bodies, "
          "which are step,time [s],body,x [m]"))
          << e.what();
    }
  EXPECT_EQ("bodies.csv:3: error: this line has 4 values, and the first line names 22 columns",
            refused(row(1, "a") + "1,0.5,b,1\n" + row(2, "a")));
  std::string turned = row(1, "a");
  turned.replace(turned.find("0,0,0,1"), 7, "0,5,0,1");
  EXPECT_EQ("bodies.csv:2: error: qx, qy, qz and qw are not a unit quaternion", refused(turned));
  for (const char* value : {"nan", "inf", "", "1x", "1e999", "1e300"})
    EXPECT_EQ("bodies.csv:3: error: the value in column 22 is not a finite number",
              refused(row(1, "a") + row(1, "b", value)))
        << value;
  EXPECT_EQ("bodies.csv:2: error: the step is not a whole number from 0", refused(row(-1, "a")));
  EXPECT_EQ(
      "bodies.csv:2: error: this row is not of the body \"a\"; every time has a row for each "
      "body, in the order of the scene",
      refused(row(1, "b") + row(1, "a")));
  EXPECT_EQ(
      "bodies.csv:3: error: the time is 2.5, and the row before is of the time 1.5, which lacks a "
      "row of the body \"b\"",
      refused(row(1, "a") + row(2, "b")));
  EXPECT_EQ("bodies.csv:4: error: the time is 1.5, and must be greater than that before, 1.5",
            refused(row(1, "a") + row(1, "b") + row(1, "a")));
}

}  // namespace
}  // namespace freshet::test
