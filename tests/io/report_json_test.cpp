// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "freshet/report.h"

namespace freshet {
namespace {

TEST(ReportJson, HoldsStatisticsAndTimings) {
  Report report;
  report.statistics.density_error_mean = 0.25;
  report.statistics.density_error_max = 0.5;
  report.statistics.speed_max = 3;
  report.statistics.fastest = 1234567890123456789;
  report.time_steps.last_ruled = "sound";
  report.time_steps.ruled["sound"] = 7;
  report.verbs = {{"density", 2, 0.001, 1000}};
  const auto json = nlohmann::json::parse(to_json(report));
  const auto& statistics = json.at("statistics");
  EXPECT_EQ(0.25, statistics.at("density_error").at("mean"));
  EXPECT_EQ(0.5, statistics.at("density_error").at("max"));
  EXPECT_EQ(3, statistics.at("speed").at("max"));
  EXPECT_EQ(1234567890123456789u, statistics.at("speed").at("fastest"));
  EXPECT_EQ("sound", json.at("time_steps").at("last_ruled"));
  EXPECT_EQ(7, json.at("time_steps").at("ruled").at("sound"));
  EXPECT_EQ("density", json.at("verbs").at(0).at("name"));
  EXPECT_EQ(1000, json.at("verbs").at(0).at("ns_per_particle"));
}

TEST(ReportJson, HoldsEachSolve) {
  Report report;
  report.time_steps.retried = 3;
  report.solves = {{"divergence", 0.001, 20, 30, 4, 0, 2, 0.0005, 0.0009},
                   {"density", 0.0001, 20, 50, 9, 1, 3, 0.00009, 0.0002}};
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(3, json.at("time_steps").at("retried"));
  const auto& solves = json.at("solves");
  ASSERT_EQ(2u, solves.size());
  EXPECT_EQ("divergence", solves[0].at("name"));
  EXPECT_EQ(1.5, solves[0].at("mean_iterations"));
  const nlohmann::json density{{"name", "density"},      {"tolerance", 0.0001},
                               {"solves", 20},           {"iterations", 50},
                               {"mean_iterations", 2.5}, {"most_iterations", 9},
                               {"not_converged", 1},     {"last_iterations", 3},
                               {"last_error", 0.00009},  {"worst_error", 0.0002}};
  EXPECT_EQ(density, solves[1]);
}

TEST(ReportJson, HasNoSolvesWithoutIterations) {
  const auto json = nlohmann::json::parse(to_json(Report{}));
  EXPECT_EQ(nlohmann::json::array(), json.at("solves"));
  EXPECT_EQ(0, json.at("time_steps").at("retried"));
}

TEST(ReportJson, HasNullForANanError) {
  Report report;
  report.solves.resize(1);
  report.solves[0].last_error = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_TRUE(json.at("solves")[0].at("last_error").is_null());
}

}  // namespace
}  // namespace freshet
