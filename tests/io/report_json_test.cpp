// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "freshet/report.h"

namespace freshet {
namespace {

TEST(ReportJson, HoldsWhatTheStatisticsAre) {
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

}  // namespace
}  // namespace freshet
