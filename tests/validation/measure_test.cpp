// SPDX-License-Identifier: MIT
// What a validation measures, on curves whose measures are known, and what a case must not say.
#include "validate/measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "cli/files.h"
#include "freshet/error.h"
#include "freshet/scene.h"
#include "scene/model/expressions.h"

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

TEST(Statistic, IsExactForLinesDecaysAndPeriods) {
  const Curve line = sampled([](double x) { return 3 - 2 * x; }, 1);
  EXPECT_NEAR(-2, statistic("slope", line, ""), 1e-9);
  EXPECT_NEAR(0, statistic("scatter", line, ""), 1e-9);
  EXPECT_NEAR(6.0 / 78, statistic("scatter", {{0, 1, 2}, {0, 1, 4}}, ""), 1e-9);
  EXPECT_NEAR(2, statistic("mean", line, ""), 1e-9);
  EXPECT_NEAR(1, statistic("min", line, ""), 1e-9);
  EXPECT_NEAR(3, statistic("max", line, ""), 1e-9);
  EXPECT_NEAR(1, statistic("last", line, ""), 1e-9);
  const Curve decay = sampled([](double x) { return 5 * std::exp(-1.5 * x); }, 2);
  EXPECT_NEAR(-1.5, statistic("rate", decay, ""), 1e-9);
  const Curve wave =
      sampled([](double x) { return 1 + std::sin(2 * std::numbers::pi * x / 0.7); }, 5);
  EXPECT_NEAR(0.7, statistic("period", wave, ""), 1e-3);
  EXPECT_NEAR(2, statistic("height", wave, ""), 1e-3);
  const Curve ringing =
      sampled([](double x) { return std::exp(-0.4 * x) * std::pow(std::cos(9 * x), 2); }, 4, 20001);
  EXPECT_NEAR(-0.4, statistic("decay", ringing, ""), 1e-3);
  EXPECT_THROW(statistic("median", line, ""), Error);
  EXPECT_THROW(statistic("mean", {}, ""), Error) << "an empty curve must be rejected";
}

TEST(Difference, IsTakenWhereBothCurvesAreDefined) {
  const Curve line = sampled([](double x) { return x; }, 1);
  const Curve points{{-1, 0.5, 1, 7}, {0, 0.6, 1.2, 0}};
  EXPECT_NEAR(0.2, difference("max", line, points, points, 1.0, ""), 1e-9);
  EXPECT_NEAR(0.15, difference("mean", line, points, points, 1.0, ""), 1e-9);
  EXPECT_NEAR(std::sqrt(0.025), difference("rms", line, points, points, 1.0, ""), 1e-9);
  EXPECT_NEAR(0.1 / 0.6, difference("max", line, points, points, {}, ""), 1e-9)
      << "without a scale, the difference is relative to the expected value";
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
    return measure(c, m, read_table(folder.path() / m.table), folder.path());
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
  // The reference reaches 2.05 at 10.5, the run at 1.05. Shifted by 9.45, the run is 1.55 at 10.
  const ValidationResult r = of(m);
  EXPECT_NEAR(0.05 / 2.6, r.value, 0.02);
  EXPECT_TRUE(r.passed);
  EXPECT_NE(std::string::npos, r.plot.find("<svg"));
  m.bound = 1e-3;
  EXPECT_FALSE(of(m).passed);
  m.y = "height";
  EXPECT_THROW(of(m), Error) << "a missing column must be rejected";
}

TEST_F(AMeasure, TakesAStatisticOfTheSelectedRows) {
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
  EXPECT_TRUE(r.passed) << "without a bound, a measure passes";
  m.expected = "";
  EXPECT_NE(r.plot, of(m).plot) << "the plot must show the expected line";
  m.x = m.y;
  EXPECT_TRUE(of(m).plot.empty()) << "equal axes must give no plot";
}

// The other table has the depth at 0, 1 and 2 s; it is interpolated at 0.5 and 1.5 s.
TEST_F(AMeasure, InterpolatesColumnsOfAnotherTable) {
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
  EXPECT_THROW(of(m), Error) << "a table without time must be rejected";
}

TEST_F(AMeasure, CountsTimeFromAnEventInAnotherTable) {
  write("wall.csv", "time [s],pressure [Pa]\n1,0\n2,0\n3,50\n4,60\n");
  write("gauge.csv", "time [s],distance [m]\n0.5,0\n1.5,0.1\n2.5,0.2\n");
  ValidationMeasure m;
  m.name = "from the gauge to the wall";
  m.table = "wall.csv";
  m.x = m.y = "time";
  m.when = "pressure > 10";
  m.since = "gauge.csv";
  m.since_when = "distance > 0.05";
  m.statistic = "min";
  EXPECT_NEAR(1.5, of(m).value, 1e-9);
  m.since_when = "distance > 1";
  EXPECT_THROW(of(m), Error) << "an event that never happens must be rejected";
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

TEST(ValidationCaseFile, RejectsInvalidFiles) {
  const std::string good =
      "title = \"t\"\nsource = \"s\"\nsolvers = [\"dfsph\"]\nspacings = [0.1]\n";
  const std::string measure = "[[measure]]\nname = \"m\"\ny = \"y\"\nstatistic = \"mean\"\n";
  EXPECT_EQ("", refusal(good + measure));
  EXPECT_NE(std::string::npos, refusal(good).find("no [[measure]]"));
  EXPECT_NE(std::string::npos, refusal("title = 3\n").find("title must be a string"));
  EXPECT_NE(std::string::npos, refusal(good + "colour = 1\n" + measure).find("unknown key colour"));
  EXPECT_NE(std::string::npos, refusal(good + measure + "bound = 1\n").find("without a reason"));
  EXPECT_NE(
      std::string::npos,
      refusal("title = \"t\"\nsource = \"s\"\nsolvers = [\"sph\"]\nspacings = [0.1]\n" + measure)
          .find("unknown solver sph"));
  EXPECT_NE(std::string::npos, refusal("title = \n").find("case.toml:1:"));
  std::string deep = "a";
  for (int k = 0; k < 100000; ++k) deep += ".a";
  EXPECT_NE(std::string::npos, refusal(deep + " = 1\n").find("is it a validation case?"));
  EXPECT_NE(std::string::npos,
            refusal(good + "[[measure]]\nname = \"m\"\ny = \"y\"\n").find("needs one of expected"));
  EXPECT_NE(std::string::npos, refusal(good + "steps = [0.1]\n" + measure).find("exactly one of"));
  EXPECT_NE(std::string::npos,
            refusal(good + "vary = \"fluid.radius\"\n" + measure).find("vary and values together"));
}

TEST(ValidationCaseFile, OfEveryCaseIsValid) {
  const auto cases = validation_cases(SOURCE_DIR "/validation");
  EXPECT_GE(cases.size(), 8u);
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  for (const ValidationCase& c : cases) {
    EXPECT_TRUE(c.short_form) << c.name;
    for (const std::string& solver : c.solvers)
      EXPECT_NO_THROW(load_scene(c.scene, overrides_of(c, solver, c.resolutions[0]))) << c.name;
    EXPECT_TRUE(std::any_of(c.measures.begin(), c.measures.end(),
                            [](const auto& m) { return m.bound || m.order; }))
        << c.name << " must have a bound or an order";
  }
}

TEST(ConvergenceOrder, IsTwoIfHalfTheSpacingLeavesAQuarterOfTheError) {
  EXPECT_NEAR(2, convergence_order(4, 0.2, 1, 0.1), 1e-12);
}

TEST(ValidationReport, ListsMissedBounds) {
  ValidationRun good;
  good.case_name = "case";
  good.solver = "dfsph";
  good.resolution = 0.1;
  good.results.emplace_back();
  good.results[0].name = "m";
  good.results[0].value = 0.5;
  good.results[0].bound = 1;
  good.results[0].passed = true;
  ValidationRun bad = good;
  bad.solver = "wcsph";
  bad.results[0].value = 2;
  bad.results[0].passed = false;
  ValidationRun expected = bad;
  expected.results[0].expected_miss = "it cannot";
  ValidationRun after_all = good;
  after_all.results[0].expected_miss = "it cannot";
  ValidationRun broken = bad;
  broken.error = "it blew up";
  EXPECT_TRUE(good.as_expected());
  EXPECT_FALSE(bad.as_expected());
  EXPECT_TRUE(expected.as_expected());
  EXPECT_FALSE(after_all.as_expected());
  EXPECT_FALSE(broken.as_expected());
  broken.expected_failure = "it blows up";
  EXPECT_TRUE(broken.as_expected());
  ValidationCase c;
  c.name = "case";
  c.title = "a < b";
  const std::string html = validation_html({c}, {good, bad, expected});
  EXPECT_NE(std::string::npos, html.find("a &lt; b"));
  EXPECT_NE(std::string::npos,
            html.find("1 of 3 bounds are met (33 %). 2 of 3 runs meet or miss each "
                      "bound as their case expects."));
  EXPECT_NE(std::string::npos, html.find("<a href=\"#case\">case</a></td><td>0/1*, 0/1</td>"));
  const std::string table = validation_markdown({c}, {good, bad});
  EXPECT_NE(std::string::npos, table.find("| [case](#case) | 0/1* | 1/1 |")) << table;
  EXPECT_NE(std::string::npos, table.find("| `wcsph` 0.1 m | 0 | 0 | **2** |")) << table;
  EXPECT_NE(std::string::npos, validation_markdown({c}, {expected}).find("- Missed: it cannot."));
  EXPECT_NE(std::string::npos, validation_json({bad}).find("\"as_expected\": false"));
}

TEST(ValidationReport, AValueWithoutABoundIsNotGreen) {
  ValidationRun run;
  run.case_name = "case";
  run.results.emplace_back();
  run.results[0].name = "m";
  run.results[0].passed = true;
  ValidationCase c;
  c.name = "case";
  const std::string html = validation_html({c}, {run});
  EXPECT_EQ(std::string::npos, html.find("class=\"good\"")) << html;
  EXPECT_NE(std::string::npos, html.find("no bounds"));
}

/// A wave with a known velocity, measured after one step, with three spacings.
class AProgramme : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
    write_text(folder / "case/case.toml",
               "title = \"t\"\nsource = \"s\"\nscene = \"" SOURCE_DIR
               "/validation/interpolation/scene.toml\"\n"
               "solvers = [\"wcsph\"]\nspacings = [0.05, 0.025, 0.0125]\n"
               "[set.all]\n\"particles.support_radius\" = \"4 spacings\"\n"
               "\"solver.sound_speed\" = 10\n"
               "[[fails]]\nsolvers = [\"wcsph\"]\nmeasures = [\"too much\"]\nspacings = [0.05]\n"
               "reason = \"a third\"\n" +
                   measure("velocity", "expected = \"sin(2*pi*x)\"\norder = 1.8\n") +
                   measure("finest", "reference = \"finest\"\n") +
                   measure("too much", "expected = \"sin(2*pi*x)\"\nbound = 0.02\n"));
    options.cases = {read_validation_case(folder / "case")};
    options.output = folder / "runs";
  }
  static std::string measure(const std::string& name, const std::string& more) {
    return "[[measure]]\nname = \"" + name +
           "\"\ntable = \"probes/line.csv\"\nx = \"x\"\ny = \"velocity_y\"\n"
           "when = \"time > 0\"\nscale = 1\nreason = \"r\"\n" +
           more;
  }
  TemporaryFolder folder;
  ValidateOptions options;
};

TEST_F(AProgramme, ReportsOrdersAndExpectedMisses) {
  const auto runs = validate(options);
  ASSERT_EQ(3u, runs.size());
  for (const ValidationRun& r : runs) EXPECT_TRUE(r.as_expected()) << r.resolution << r.error;
  EXPECT_FALSE(runs[0].passed()) << "0.06 exceeds the bound of 0.02";
  ASSERT_EQ(4u, runs[1].results.size());
  EXPECT_EQ("velocity: order of convergence", runs[1].results[3].name);
  EXPECT_NEAR(2, runs[1].results[3].value, 0.1);
  EXPECT_GT(runs[0].results[1].value, runs[1].results[1].value)
      << "the error must decrease with the spacing";
  EXPECT_EQ(2u, runs[2].results.size()) << "the finest run must not be compared with itself";
}

// The case varies a key, measures across the runs of a solver, and the caller overrides the
// spacing.
TEST_F(AProgramme, VariesAnyKeyAndMeasuresAcrossRuns) {
  write_text(folder / "case/case.toml",
             "title = \"t\"\nsource = \"s\"\nscene = \"" SOURCE_DIR
             "/validation/interpolation/scene.toml\"\n"
             "solvers = [\"wcsph\"]\nvary = \"particles.support_radius\"\nunit = \"m\"\n"
             "values = [0.1, 0.2, 0.15]\n[set.all]\n\"solver.sound_speed\" = 10\n" +
                 measure("velocity", "statistic = \"max\"\n") +
                 "[[measure]]\nname = \"trend\"\ntable = \"runs\"\nx = \"2*support_radius\"\n"
                 "y = \"velocity\"\nstatistic = \"slope\"\nexpected = \"0\"\nscale = 1\n");
  options.cases = {read_validation_case(folder / "case")};
  options.overrides = {{"particles.spacing", "0.05"}};
  const auto runs = validate(options);
  ASSERT_EQ(3u, runs.size());
  EXPECT_EQ("support_radius", runs[0].varies);
  EXPECT_EQ(0.2, runs[0].resolution);
  EXPECT_EQ(400, runs[0].particles) << "the caller's spacing must apply";
  EXPECT_EQ(1u, runs[1].results.size());
  ASSERT_EQ(2u, runs[2].results.size());
  // For three equidistant points, the slope of the fit is that between the outer two.
  const double slope = (*runs[0].results[0].measured - *runs[2].results[0].measured) / 0.2;
  EXPECT_NEAR(slope, *runs[2].results[1].measured, 1e-9 + 1e-6 * std::abs(slope));
  EXPECT_NE(0, slope);
}

TEST_F(AProgramme, HasAShortForm) {
  write_text(folder / "case/case.toml",
             read_text(folder / "case/case.toml") +
                 "[short]\nsolvers = [\"wcsph\"]\nspacings = [0.05]\nend = 2e-5\ncost = \"0 s\"\n");
  options.cases = {read_validation_case(folder / "case")};
  options.solvers = {"wcsph"};
  options.short_form = true;
  const auto shorter = validate(options);
  ASSERT_EQ(1u, shorter.size());
  EXPECT_EQ(2, shorter[0].steps);
}

TEST_F(AProgramme, ReusesRunsOfTheSameScene) {
  const auto before = validate(options);
  const fs::path told = folder / "runs/case_wcsph_0.05/report.json";
  write_text(told, R"({"steps": 77, "statistics": {"particles": 3}})");
  options.resume = true;
  const auto after = validate(options);
  EXPECT_EQ(77, after[0].steps) << "the run was repeated";
  EXPECT_EQ(before[0].results[0].value, after[0].results[0].value);
  fs::remove_all(folder / "runs/case_wcsph_0.025");
  options.run = false;
  EXPECT_EQ(2u, validate(options).size()) << "one run is missing, and none may be started";
  options.run = true;
  options.cases[0].set[0].second[0].second = "3 spacings";
  EXPECT_NE(77, validate(options)[0].steps) << "another scene must be run again";
}

}  // namespace
}  // namespace freshet::test
