// SPDX-License-Identifier: MIT
// The median of runs whose starts differ in the last digits.
#include "validate/repeats.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cli/files.h"
#include "scene/model/expressions.h"

namespace freshet::test {
namespace {

ValidationRun run_with(std::vector<double> values) {
  ValidationRun r;
  r.seconds = 1;
  for (const double value : values) {
    ValidationResult result;
    result.value = value;
    result.passed = value < 0.5;
    r.results.push_back(result);
  }
  return r;
}

TEST(Repeats, HaveTheMedianOfEachResult) {
  const ValidationRun median =
      median_of({run_with({0.9, 0.1}), run_with({0.2, 0.3}), run_with({0.4, 0.2})});
  EXPECT_EQ(0.4, median.results[0].value);
  EXPECT_TRUE(median.results[0].passed);
  EXPECT_EQ(0.2, median.results[1].value);
  EXPECT_EQ(3, median.seconds);
  EXPECT_EQ("0.2 to 0.9", range_of(median.results[0]));
}

TEST(Repeats, TakeTheWorseOfTwoAndWhatCouldNotBeMeasuredAsTheWorst) {
  EXPECT_EQ(0.9, median_of({run_with({0.9}), run_with({0.1})}).results[0].value);
  const double none = std::nan("");
  EXPECT_EQ(0.3, median_of({run_with({none}), run_with({0.1}), run_with({0.3})}).results[0].value);
}

TEST(Repeats, FailWithOneOfThem) {
  ValidationRun failed;
  failed.error = "the run failed";
  EXPECT_EQ("the run failed", median_of({run_with({0.1}), failed}).error);
}

TEST(Repeats, OfOneRunAreThatRun) {
  const ValidationRun run = median_of({run_with({0.1})});
  EXPECT_EQ("", range_of(run.results[0]));
}

TEST(Repeats, ChangeTheStart) {
  Scene scene;
  EXPECT_TRUE(changed_start(scene, 0).empty());
  EXPECT_EQ(2u, changed_start(scene, 2).size());
  scene.particles.jitter = 0.1;
  scene.particles.seed = 5;
  const auto seed_alone = changed_start(scene, 2);
  ASSERT_EQ(1u, seed_alone.size());
  EXPECT_EQ("7", seed_alone[0].second);
}

TEST(Repeats, AreRunByTheProgramme) {
  if (!reads_expressions()) GTEST_SKIP() << "built without muParser";
  TemporaryFolder folder;
  const auto read_with = [&](const std::string& repeats) {
    write_text(
        folder / "case/case.toml",
        "title = \"t\"\nsource = \"s\"\nscene = \"" SOURCE_DIR
        "/validation/interpolation/scene.toml\"\nsolvers = [\"wcsph\"]\nspacings = [0.05]\n" +
            repeats +
            "[set.all]\n\"particles.support_radius\" = \"4 spacings\"\n"
            "\"solver.sound_speed\" = 10\n[[measure]]\nname = \"velocity\"\ntable = "
            "\"probes/line.csv\"\nx = \"x\"\ny = \"velocity_y\"\nwhen = \"time > 0\"\nscale = 1\n"
            "expected = \"sin(2*pi*x)\"\n");
    return read_validation_case(folder / "case");
  };
  ValidateOptions options;
  options.cases = {read_with("repeats = 3\n")};
  options.output = folder / "runs";
  const auto runs = validate(options);
  ASSERT_EQ(1u, runs.size());
  ASSERT_EQ("", runs[0].error);
  const ValidationResult& velocity = runs[0].results.at(0);
  ASSERT_EQ(3u, velocity.repeats.size());
  EXPECT_EQ(velocity.value, velocity.repeats[1]);
  EXPECT_LT(velocity.repeats[0], velocity.repeats[2]) << "the starts must differ";
  options.repeats = 1;
  EXPECT_TRUE(validate(options)[0].results[0].repeats.empty());
  EXPECT_THROW(read_with("repeats = 0\n"), Error);
  EXPECT_THROW(read_with("repeats = 1.5\n"), Error);
}

}  // namespace
}  // namespace freshet::test
