// SPDX-License-Identifier: MIT
// A scene flows alike at any distance from the origin.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

#include "cli/files.h"
#include "engine/select.h"
#include "freshet/checkpoint.h"
#include "scene/model/expressions.h"
#include "scene/model/setup.h"
#include "sim/probes.h"
#include "sim/same_bits.h"

namespace freshet::test {
namespace {

/// Replaces each number in braces by its sum with a shift.
std::string shifted(std::string text, double shift) {
  for (auto at = text.find('{'); at != text.npos; at = text.find('{')) {
    const auto end = text.find('}', at);
    const double x = std::stod(text.substr(at + 1, end - at - 1)) + shift;
    text.replace(at, end + 1 - at, fmt::format("{:.12g}", x));
  }
  return text;
}

/// A column with walls of every kind of the solver, flows, a moved body and a body force.
std::string everything(const std::string& solver, const std::string& sides, bool functions) {
  return "[domain]\nmin = [{0}, {0}]\nmax = [{1.2}, {0.6}]\n" +
         std::string(functions ? "body_force = [\"3*sin(4*(x - {0}))\", \"0\"]\n" : "") +
         "[particles]\nspacing = 0.025\n"
         "[fluid]\nmin = [{0.4}, {0}]\nmax = [{0.8}, {0.4}]\n"
         "[[wall]]\nshape = \"sphere\"\ncenter = [{1}, {0.1}]\nradius = 0.06\n"
         "[[inlet]]\ncenter = [{0.1}, {0.45}]\ndirection = [1, 0]\nwidth = 0.1\nspeed = 1\n"
         "[[outlet]]\nmin = [{1.1}, {0}]\nmax = [{1.2}, {0.2}]\n"
         "[[counter]]\ncenter = [{0.9}, {0}]\ndirection = [1, 0]\n[walls]\n" +
         sides + "[solver]\nname = \"" + solver + "\"\n[time]\nend = 0.5\nstep = 0.0002\n";
}

/// The index of each particle by its id.
std::map<std::uint64_t, std::size_t> index_of(const ParticleView& f) {
  std::map<std::uint64_t, std::size_t> index;
  for (std::size_t i = 0; i < f.size(); ++i) index[f.id[i]] = i;
  return index;
}

/// The largest difference of a position, relative to the shift, or of a velocity between two runs.
double difference(const Simulation& a, const Simulation& b, double shift) {
  const ParticleView f = a.fluid(), g = b.fluid();
  if (f.size() != g.size()) return INFINITY;
  auto there = index_of(g);
  double most = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t d = 0; d < 2; ++d) {
      const std::size_t j = there[f.id[i]];
      most = std::max(most, std::abs(f.position(i, d) + shift - g.position(j, d)));
      most = std::max(most, std::abs(double(f.v[2 * i + d]) - double(g.v[2 * j + d])));
    }
  return most;
}

TEST(FarOrigin, ChangesNoFlow) {
  for (const auto& [solver, sides] :
       {std::pair("wcsph", ""), std::pair("wcsph", "method = \"adami2012\"\n"),
        std::pair("delta_sph", "method = \"ghost\"\n"), std::pair("mueller2003", ""),
        std::pair("mueller2003", "method = \"ghost\"\n"), std::pair("dfsph", "x_min = \"open\"\n"),
        std::pair("wcsph", "method = \"monaghan2009\"\n")}) {
    SCOPED_TRACE(std::string(solver) + " " + sides);
    const std::string text = everything(solver, sides, reads_expressions());
    for (const double shift : {1000.0, -70000.0}) {
      Simulation here = simulation_of(shifted(text, 0), "cpu", {1, ""});
      Simulation there = simulation_of(shifted(text, shift), "cpu", {1, ""});
      for (int k = 0; k < 200; ++k) here.step(), there.step();
      EXPECT_LT(difference(here, there, shift), 1e-5) << shift;
      const auto a = here.flows(), b = there.flows();
      for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(a[k].particles, b[k].particles);
      EXPECT_NEAR(here.statistics().height_mean + shift, there.statistics().height_mean, 1e-5);
      EXPECT_EQ(here.statistics().out_of_bounds, there.statistics().out_of_bounds);
      const auto forces = here.wall_forces(), far_forces = there.wall_forces();
      for (std::size_t k = 0; k < forces.size(); ++k)
        EXPECT_NEAR(forces[k][1], far_forces[k][1], 1e-3 * std::abs(forces[k][1]) + 0.1);
    }
  }
}

// The body's cells are not square: in a corner of square ones, the rounding of the scene's numbers
// decides by which face a body particle is moved deeper.
TEST(FarOrigin, ChangesNoBodyAndNoProbe) {
  const std::string text =
      "[domain]\nmin = [{0}, {0}]\nmax = [{1}, {0.6}]\n[particles]\nspacing = 0.025\n"
      "[fluid]\nmin = [{0}, {0}]\nmax = [{1}, {0.3}]\npressure = \"hydrostatic\"\n"
      "[[body]]\nname = \"paddle\"\nmin = [{0.3}, {0.1}]\nmax = [{0.5}, {0.19}]\nmotion = "
      "\"moved\"\n"
      "key = [{ time = 0 }, { time = 0.2, translation = [0.1, 0.05], angle = 40 }]\n"
      "[[probe]]\nname = \"point\"\nat = [{0.7}, {0.1}]\n"
      "[[probe]]\nname = \"bed\"\nkind = \"wall\"\nfrom = [{0.6}, {0}]\nto = [{0.9}, {0}]\n"
      "[[probe]]\nname = \"level\"\nkind = \"surface\"\nfrom = [{0.7}, {0}]\nto = [{0.7}, {0.6}]\n"
      "[solver]\nname = \"wcsph\"\n[time]\nend = 0.2\nstep = 0.0002\n";
  std::string keys = text;  // inline tables have braces of their own
  keys.replace(keys.find("{ time = 0 }"), 12, "<time = 0>");
  keys.replace(keys.find("{ time = 0.2"), 1, "<");
  keys.replace(keys.find("= 40 }"), 6, "= 40>");
  const auto scene = [&](double shift) {
    std::string s = shifted(keys, shift);
    std::replace(s.begin(), s.end(), '<', '{');
    std::replace(s.begin(), s.end(), '>', '}');
    return s;
  };
  Simulation here = simulation_of(scene(0), "cpu", {1, ""});
  Simulation there = simulation_of(scene(5000), "cpu", {1, ""});
  for (int k = 0; k < 200; ++k) here.step(), there.step();
  EXPECT_LT(difference(here, there, 5000), 1e-5);
  for (int d = 0; d < 2; ++d)
    EXPECT_NEAR(here.bodies()[0].position[std::size_t(d)] + 5000,
                there.bodies()[0].position[std::size_t(d)], 1e-9);
  const auto a = Probes(here.scene()).look(here), b = Probes(there.scene()).look(there);
  const auto numbers = [](const std::string& line, std::size_t skip) {
    std::vector<double> all;
    std::istringstream in(line);
    for (std::string word; std::getline(in, word, ',');)
      if (skip > 0) --skip;
      else all.push_back(std::stod(word));
    return all;
  };
  for (std::size_t p = 0; p < a.size(); ++p) {
    const auto x = numbers(a[p], p == 0 ? 3 : 1), y = numbers(b[p], p == 0 ? 3 : 1);
    for (std::size_t k = 0; k < x.size(); ++k)
      EXPECT_NEAR(x[k], y[k], 1e-3 * std::abs(x[k]) + 1e-5) << p;
  }
}

/// A drop at rest, 3000 m from the origin.
std::string drop(const std::string& more = "") {
  return "domain = { min = [3000, 0], max = [3001, 1], gravity = [0, 0] }\n"
         "particles = { spacing = 0.05 }\n"
         "fluid = { min = [3000.4, 0.4], max = [3000.6, 0.6] }\n"
         "time = { end = 1, step = 0.001 }\nsolver = { name = \"wcsph\", sound_speed = 10 }\n" +
         more;
}

TEST(FarOrigin, PositionsOfTheInterfaceAreThoseOfTheScene) {
  Simulation sim = simulation_of(drop());
  const ParticleView f = sim.fluid();
  EXPECT_EQ(3000, f.origin[0]);
  EXPECT_EQ(0, f.origin[1]);
  EXPECT_EQ(Real(3000.425), f.x[0]);
  EXPECT_NEAR(3000.425, f.position(0, 0), 1e-7);
  EXPECT_EQ(f.x[1], Real(f.position(0, 1)));
  EXPECT_EQ(float(3000.425), sim.frame().x[0]);
  double seen = 0;
  sim.set_force([&](const ParticleView& fluid, double, std::span<double>) { seen = fluid.x[0]; });
  sim.step();
  EXPECT_NEAR(3000.425, seen, 0.001);
}

TEST(FarOrigin, WrittenPositionsReachTheSimulation) {
  Simulation sim = simulation_of(drop());
  const auto fluid = sim.edit_fluid();
  const double untouched = sim.fluid().position(1, 0);
  fluid.x[0] = Real(3000.75);
  EXPECT_EQ(3000.75, sim.fluid().position(0, 0)) << "the view must show it at once";
  fluid.x[2 * 5 + 1] = Real(0.25);
  fluid.v[0] = 1;
  sim.step();
  const auto at = [&](std::uint64_t id, std::size_t d) {
    return sim.fluid().position(index_of(sim.fluid())[id], d);
  };
  EXPECT_NEAR(3000.751, at(0, 0), 1e-4);
  EXPECT_NEAR(0.25, at(5, 1), 1e-4);
  EXPECT_NEAR(untouched, at(1, 0), 1e-4);
  const std::vector<Real> x{Real(3000.125), Real(0.5)};
  const std::uint64_t id = sim.add_particles(x);
  const ParticleView more = sim.fluid();
  ASSERT_EQ(17u, more.size());
  EXPECT_EQ(id, more.id[16]);
  EXPECT_EQ(3000.125, more.position(16, 0));
  EXPECT_EQ(Real(0.5), more.x[2 * 16 + 1]);
  sim.remove_particles(std::vector<std::uint64_t>{id});
  EXPECT_EQ(16u, sim.fluid().size());
}

TEST(FarOrigin, ChangesNoPointsOfAFile) {
  const TemporaryFolder folder;
  const auto sampled = [&](double shift) {
    std::string points = "x,y\n";
    for (const double x : {0.1, 0.4, 0.7})
      points += fmt::format("{:.9f},{:.9f}\n", x + shift, 0.3 + shift);
    write_text(folder / "points.csv", points);
    write_text(folder / "scene.toml",
               shifted("[domain]\nmin = [{0}, {0}]\nmax = [{1}, {1}]\n[particles]\nspacing = 0.1\n"
                       "[fluid]\nshape = \"points\"\nfile = \"points.csv\"\n"
                       "[time]\nend = 1\nstep = 0.001\n",
                       shift));
    return sample(load_scene(folder / "scene.toml")).x;
  };
  EXPECT_EQ(6u, sampled(0).size());
  EXPECT_EQ(sampled(0), sampled(20000));
}

TEST(FarOrigin, HasTheSameBitsEverywhere) {
  const std::string text = shifted(everything("wcsph", "x_max = \"open\"\n", false), 1000);
  expect_same_bits(text, 60);
  expect_same_bits_after_restart(text, 40, 20);
}

TEST(FarOrigin, RejectsACheckpointOfAnotherOrigin) {
  Simulation sim = simulation_of(drop());
  Checkpoint c = sim.checkpoint();
  const auto origin = std::find_if(c.arrays.begin(), c.arrays.end(),
                                   [](const auto& a) { return a.name == "fluid/origin"; });
  ASSERT_NE(origin, c.arrays.end());
  Checkpoint without = c;
  without.arrays.erase(without.arrays.begin() + (origin - c.arrays.begin()));
  EXPECT_THROW(sim.restore(without), Error);
  const double other = 2000;
  std::memcpy(origin->bytes.data(), &other, sizeof other);
  EXPECT_THROW(sim.restore(c), Error);
}

TEST(FarOrigin, WarnsWhereSlowFlowWouldStop) {
  const auto warned = [](const std::string& size, const std::string& spacing,
                         const std::string& more) {
    const Scene scene = parse_scene(
        "domain = { max = [" + size + ", 10]" + more + " }\nparticles.spacing = " + spacing +
            "\nfluid = { max = [10, 5], min = [0, 0] }\nsolver = { name = \"wcsph\", sound_speed = "
            "200 }\ntime = { end = 1, step = 1e-4 }\n",
        "test.toml");
    for (const Diagnostic& d : scene_warnings(scene))
      if (d.message.find("slow flow will stop") != std::string::npos) return true;
    return false;
  };
  const std::string weightless = ", gravity = [0, 0]";
  EXPECT_FALSE(warned("10", "0.1", ""));
  EXPECT_FALSE(warned("100", "0.1", ""));
  EXPECT_TRUE(warned("1000", "0.1", "")) << "14 m/s in steps of 1e-4 s";
  EXPECT_FALSE(warned("100", "0.1", weightless));
  EXPECT_TRUE(warned("1000", "0.1", weightless));
}

TEST(FarOrigin, StaysZeroForADomainNearIt) {
  const auto origin = [](const std::string& min, const std::string& max) {
    return origin_of(with_defaults(parse_scene(
        "domain = { min = " + min + ", max = " + max +
            " }\nparticles.spacing = 0.1\nfluid = { shape = \"lattice\", from = " + min +
            ", count = [1, 1] }\ntime = { end = 1, step = 0.01 }\n",
        "test.toml")));
  };
  EXPECT_EQ(Triple{}, origin("[-1, -1]", "[1, 1]"));
  EXPECT_EQ(Triple{}, origin("[0.9, -1.9]", "[1.9, -0.9]"));
  EXPECT_EQ((Triple{1.1, 0, 0}), origin("[1.1, 0]", "[2.1, 1]"));
  EXPECT_EQ((Triple{0, -2.5, 0}), origin("[0, -2.5]", "[1, -1.5]"));
  EXPECT_EQ(Triple{}, origin("[0, 2]", "[5, 3]")) << "the longest side counts";
}

}  // namespace
}  // namespace freshet::test
