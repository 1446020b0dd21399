// SPDX-License-Identifier: MIT
/// Pictures of a resumed or rendered run take their colours from percentiles.csv.
#include "run/percentile_table.h"

#include <gtest/gtest.h>

#include "cli/files.h"
#include "freshet/error.h"
#include "render/pictures.h"

namespace freshet::test {
namespace {

ColorRanges equal_ranges(float low, float high) {
  ColorRanges all;
  all.fill({low, high});
  return all;
}

class PercentileTable : public testing::Test {
 protected:
  RangesByStep read(const std::string& rows) {
    write_text(file, percentile_header(scene) + rows);
    return {file, scene};
  }
  const Scene scene = flat_scene("");
  const TemporaryFolder folder;
  const fs::path file = folder / "percentiles.csv";
};

TEST_F(PercentileTable, HasTheRangesUpToAStep) {
  const RangesByStep ranges = read(percentile_line(2, 1, 0.1, equal_ranges(0.1f, 1.0f / 3)) +
                                   percentile_line(2, 5, 0.5, equal_ranges(-2, 0.2f)) +
                                   percentile_line(2, 9, 0.9, equal_ranges(0, 7)));
  const auto at = [&](std::int64_t step) {
    const ColorRange r = ranges.up_to(step)[std::size_t(ColorBy::pressure)];
    return std::pair(r.low, r.high);
  };
  EXPECT_TRUE(ranges.up_to(0)[0].is_empty());
  EXPECT_EQ(std::pair(0.1f, 1.0f / 3), at(1));
  EXPECT_EQ(std::pair(0.1f, 1.0f / 3), at(4));
  EXPECT_EQ(std::pair(-2.0f, 1.0f / 3), at(5));
  EXPECT_EQ(std::pair(-2.0f, 7.0f), at(100));
}

TEST_F(PercentileTable, HasNoRowOfNoParticles) {
  EXPECT_EQ("", percentile_line(2, 1, 0.1, percentiles_of(scene, Frame{})));
  EXPECT_TRUE(read("").up_to(9)[0].is_empty());
}

TEST_F(PercentileTable, RejectsWhatIsNoRange) {
  const std::string good = percentile_line(2, 1, 0.5, equal_ranges(1, 7));
  EXPECT_NO_THROW(read(good));
  for (const char* value : {"nan", "inf", "1e300", "8"}) {
    std::string bad = good;
    bad.replace(bad.find(",1,"), 3, std::string(",") + value + ",");
    EXPECT_THROW(read(bad), Error) << value;
  }
  for (const char* step : {"nan", "-1", "1e300"})
    EXPECT_THROW(read(step + good.substr(1)), Error) << step;
}

TEST_F(PercentileTable, RejectsAnotherTable) {
  write_text(file, "step,time [s],speed p01 [m/s]\n1,0.1,0\n");
  EXPECT_THROW(RangesByStep(file, scene), Error);
}

}  // namespace
}  // namespace freshet::test
