// SPDX-License-Identifier: MIT
// Arrays of the fluid that a caller keeps while the simulation goes on.
#include <gtest/gtest.h>

#include <algorithm>

#include "freshet/simulation.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

/// A filling tank, so that the memory of the fluid grows, with images behind its walls.
constexpr const char* filling_tank = R"(
domain = { max = [0.6, 0.6] }
particles = { spacing = 0.04 }
fluid = { min = [0, 0], max = [0.6, 0.2] }
inlet = { center = [0.12, 0.4], direction = [1, 0], width = 0.16, speed = 2 }
walls = { method = "ghost", y_max = "open" }
solver = { name = "wcsph", sound_speed = 20 }
time = { end = 1, step = 0.0005 }
)";

void expect_kept(const char* backend) {
  Simulation alone = simulation_of(filling_tank, backend),
             sim = simulation_of(filling_tank, backend);
  std::vector<std::shared_ptr<const void>> kept;
  std::vector<std::pair<std::span<const Real>, std::vector<Real>>> seen;
  for (int k = 0; k < 150; ++k) {
    const ParticleView f = sim.fluid();
    for (const auto field : {f.x, f.v, f.density, f.pressure}) {
      seen.push_back({field, {field.begin(), field.end()}});
      kept.push_back(sim.keep(field.data()));
      ASSERT_NE(kept.back(), nullptr);
    }
    EXPECT_NE(sim.keep(f.id.data()), nullptr);
    EXPECT_NE(sim.fluid().x.data(), f.x.data());
    sim.step();
    alone.step();
  }
  EXPECT_GT(sim.fluid().size(), seen.front().first.size() / 2);
  for (const auto& [view, before] : seen)
    EXPECT_TRUE(std::equal(view.begin(), view.end(), before.begin(), before.end()));
  EXPECT_EQ(sim.state_sha256(), alone.state_sha256());
  EXPECT_EQ(sim.kept_sha256(), alone.kept_sha256());
}

TEST(Keep, ArraysStayAndStepsHaveTheSameBits) { expect_kept("cpu"); }
TEST(Keep, ArraysOfTheReferenceStay) { expect_kept("reference"); }

TEST(Keep, ArraysThatAreCopiesAreNotKept) {
  Simulation sim = simulation_of(R"(
domain = { max = [1, 1] }
particles = { spacing = 0.1 }
fluid = [{ min = [0, 0], max = [1, 0.3] }, { min = [0, 0.3], max = [1, 0.6], rest_density = 500 }]
solver = { name = "wcsph", sound_speed = 20 }
time = { end = 1, step = 0.0005 }
)");
  EXPECT_EQ(sim.keep(sim.fluid().density.data()), nullptr);
  EXPECT_NE(sim.keep(sim.fluid().liquid.data()), nullptr);
  EXPECT_EQ(sim.keep(nullptr), nullptr);
}

}  // namespace
}  // namespace freshet::test
