// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "freshet/probe_reading.h"
#include "sim/small_scenes.h"

namespace freshet::test {
namespace {

TEST(ReadProbes, MeasuresThePresentState) {
  const Simulation sim = simulation_of(R"(
domain = { max = [1, 1] }
particles = { spacing = 0.05 }
fluid = { min = [0, 0], max = [1, 0.5], pressure = "hydrostatic" }
solver = { name = "wcsph", sound_speed = 20 }
time = { end = 1, step = 0.0005 }
probe = [
  { kind = "surface", name = "gauge", from = [0.5, 0], to = [0.5, 1] },
  { kind = "line", from = [0.5, 0.2], to = [0.5, 0.4], count = 3 },
]
)");
  const auto probes = read_probes(sim);
  ASSERT_EQ(probes.size(), 2u);
  EXPECT_EQ(probes[0].name, "gauge");
  ASSERT_EQ(probes[0].values.size(), 1u);
  EXPECT_NEAR(probes[0].values[0][0], 0.5, 0.03);
  EXPECT_EQ(probes[0].quantities[0].unit, "m");
  EXPECT_EQ(probes[1].name, "probe_1");
  ASSERT_EQ(probes[1].places.size(), 3u);
  EXPECT_EQ(probes[1].places[2], (Vector{0.5, 0.4}));
  for (const auto& values : probes[1].values) EXPECT_EQ(values.size(), probes[1].quantities.size());
}

}  // namespace
}  // namespace freshet::test
