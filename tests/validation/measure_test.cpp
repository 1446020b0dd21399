// SPDX-License-Identifier: MIT
// What a validation measures, on curves whose measures are known, and what a case must not say.
#include "validation/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "cli/files.h"
#include "freshet/error.h"
#include "freshet/scene.h"
#include "scene/expressions.h"

namespace freshet::test {
namespace {

Curve sampled(double (*f)(double), double end, int count = 2001) {
  Curve c;
  for (int k = 0; k < count; ++k) {
    c.x.push_back(end * k / (count - 1));
    c.y.push_back(f(c.x.back()));
  }
  return c;
}

TEST(Statistic, KnowsLinesDecaysAndPeriods) {
  const Curve line = sampled([](double x) { return 3 - 2 * x; }, 1);
  EXPECT_NEAR(-2, statistic("slope", line, ""), 1e-9);
  EXPECT_NEAR(2, statistic("mean", line, ""), 1e-9);
  EXPECT_NEAR(1, statistic("min", line, ""), 1e-9);
  EXPECT_NEAR(3, statistic("max", line, ""), 1e-9);
  EXPECT_NEAR(1, statistic("last", line, ""), 1e-9);
  const Curve decay = sampled([](double x) { return 5 * std::exp(-1.5 * x); }, 2);
  EXPECT_NEAR(-1.5, statistic("rate", decay, ""), 1e-9);
  const Curve wave =
      sampled([](double x) { return 1 + std::sin(2 * std::numbers::pi * x / 0.7); }, 5);
  EXPECT_NEAR(0.7, statistic("period", wave, ""), 1e-3);
  EXPECT_THROW(statistic("median", line, ""), Error);
  EXPECT_THROW(statistic("mean", {}, ""), Error) << "nothing was measured";
}

TEST(Difference, IsTakenWhereBothAreKnown) {
  const Curve line = sampled([](double x) { return x; }, 1);
  const Curve points{{-1, 0.5, 1, 7}, {0, 0.6, 1.2, 0}};
  EXPECT_NEAR(0.2, difference("max", line, points, points, 1.0, ""), 1e-9);
  EXPECT_NEAR(0.15, difference("mean", line, points, points, 1.0, ""), 1e-9);
  EXPECT_NEAR(std::sqrt(0.025), difference("rms", line, points, points, 1.0, ""), 1e-9);
  EXPECT_NEAR(0.1 / 0.6, difference("max", line, points, points, {}, ""), 1e-9)
      << "without a scale it is relative to what is expected";
  EXPECT_THROW(difference("max", line, {{7.0}, {0.0}}, {{7.0}, {0.0}}, 1.0, ""), Error);
}

class AMeasure : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  }
  void write(const std::string& file, const std::string& text) {
    std::ofstream(folder.path() / file) << text;
  }
  ValidationResult of(const ValidationMeasure& m) {
    ValidationCase c;
    c.folder = folder.path();
    return measure(c, m, folder.path());
  }
  TemporaryFolder folder;
};

TEST_F(AMeasure, ComparesWithPointsOfAFile) {
  write("front.csv", "time [s],distance [m]\n0,1\n1,2\n2,3\n3,4\n");
  write("reference.csv", "# by hand\nT,Z\n10,1.5\n11,2.6\n12,3.5\n");
  ValidationMeasure m;
  m.name = "front";
  m.table = "front.csv";
  m.x = "time";
  m.y = "distance";
  m.reference = "reference.csv";
  m.rx = "T";
  m.ry = "Z";
  m.align = 2.05;
  m.bound = 0.05;
  // The reference reaches 2.05 at 10.5, the run at 1.05: shifted by 9.45 it is 1.55 at 10.
  const ValidationResult r = of(m);
  EXPECT_NEAR(0.05 / 2.6, r.value, 0.02);
  EXPECT_TRUE(r.passed);
  EXPECT_NE(std::string::npos, r.plot.find("<svg"));
  m.bound = 1e-3;
  EXPECT_FALSE(of(m).passed);
  m.y = "height";
  EXPECT_THROW(of(m), Error) << "there is no such column";
}

TEST_F(AMeasure, TakesAStatisticOfTheRowsThatCount) {
  write("depth.csv", "time [s],y [m],pressure [Pa]\n0,0,7\n0,1,7\n2,0,30\n2,1,20\n2,2,nan\n");
  ValidationMeasure m;
  m.name = "slope";
  m.table = "depth.csv";
  m.x = "y";
  m.y = "pressure";
  m.when = "time > 1";
  m.statistic = "slope";
  m.expected = "-2*4";
  const ValidationResult r = of(m);
  EXPECT_NEAR(-10, *r.measured, 1e-9);
  EXPECT_NEAR(0.25, r.value, 1e-9);
  EXPECT_TRUE(r.passed) << "without a bound it is only told";
}

// Half of the depth at 0.5 and 1.5 s, by a table that has it at 0, 1 and 2 s.
TEST_F(AMeasure, TakesColumnsOfATableBeside) {
  write("jet.csv", "time [s],speed [m/s]\n0.5,1\n1.5,3\n");
  write("depth.csv", "time [s],depth [m]\n0,2\n1,4\n2,8\n");
  ValidationMeasure m;
  m.name = "speed over depth";
  m.table = "jet.csv";
  m.beside = "depth.csv";
  m.x = "time";
  m.y = "speed/depth";
  m.statistic = "last";
  m.expected = "0.25";
  const ValidationResult r = of(m);
  EXPECT_NEAR(3.0 / 6, *r.measured, 1e-9);
  EXPECT_NEAR(1, r.value, 1e-9);
  write("depth.csv", "x [m],depth [m]\n0,2\n1,4\n");
  EXPECT_THROW(of(m), Error) << "nobody knows when that was";
}

std::string refusal(const std::string& text) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "case.toml") << text;
  try {
    read_validation_case(folder.path());
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(ValidationCaseFile, TellsWhatIsWrong) {
  const std::string good =
      "title = \"t\"\nsource = \"s\"\nsolvers = [\"dfsph\"]\nspacings = [0.1]\n";
  const std::string measure = "[[measure]]\nname = \"m\"\ny = \"y\"\nstatistic = \"mean\"\n";
  EXPECT_EQ("", refusal(good + measure));
  EXPECT_NE(std::string::npos, refusal(good).find("no [[measure]]"));
  EXPECT_NE(std::string::npos, refusal("title = 3\n").find("title is not a text"));
  EXPECT_NE(std::string::npos, refusal(good + "colour = 1\n" + measure).find("unknown key colour"));
  EXPECT_NE(std::string::npos, refusal(good + measure + "bound = 1\n").find("without a reason"));
  EXPECT_NE(
      std::string::npos,
      refusal("title = \"t\"\nsource = \"s\"\nsolvers = [\"sph\"]\nspacings = [0.1]\n" + measure)
          .find("sph is no solver"));
  EXPECT_NE(std::string::npos, refusal("title = \n").find("case.toml:1:"));
  EXPECT_NE(std::string::npos,
            refusal(good + "[[measure]]\nname = \"m\"\ny = \"y\"\n").find("needs one of expected"));
}

TEST(ValidationCaseFile, OfEveryCaseIsGood) {
  const auto cases = validation_cases(SOURCE_DIR "/validation");
  EXPECT_GE(cases.size(), 8u);
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  for (const ValidationCase& c : cases) {
    EXPECT_TRUE(c.short_form) << c.name;
    for (const std::string& solver : c.solvers)
      EXPECT_NO_THROW(load_scene(c.scene, overrides_of(c, solver, c.spacings[0]))) << c.name;
    EXPECT_TRUE(std::any_of(c.measures.begin(), c.measures.end(),
                            [](const auto& m) { return m.bound.has_value(); }))
        << c.name << " shows nothing";
  }
}

TEST(ConvergenceOrder, IsTwoWhereAQuarterIsLeftOfTheError) {
  EXPECT_NEAR(2, convergence_order(4, 0.2, 1, 0.1), 1e-12);
}

TEST(ValidationReport, SaysWhatMissed) {
  ValidationRun good{
      "case", "dfsph", 0.1, 10, 5, 0.1, "", "", {{"m", 0.5, {}, 1.0, true, "why", ""}}, ""};
  ValidationRun bad = good;
  bad.solver = "wcsph";
  bad.results[0].passed = false;
  ValidationRun expected = bad;
  expected.expected_failure = "fails: it cannot";
  EXPECT_TRUE(good.as_expected());
  EXPECT_FALSE(bad.as_expected());
  EXPECT_TRUE(expected.as_expected());
  ValidationCase c;
  c.name = "case";
  c.title = "a < b";
  const std::string html = validation_html({c}, {good, bad, expected});
  EXPECT_NE(std::string::npos, html.find("a &lt; b"));
  EXPECT_NE(std::string::npos, html.find("2 of 3 runs are as they should be"));
  EXPECT_NE(std::string::npos, validation_markdown({c}, {bad}).find("| missed |"));
  EXPECT_NE(std::string::npos, validation_json({bad}).find("\"as_expected\": false"));
}

}  // namespace
}  // namespace freshet::test
