// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "formats/point_formats.h"
#include "formats/point_sink.h"
#include "freshet/error.h"
#include "io/frame_data.h"
#include "io/frame_files.h"
#include "io/sample_frame.h"

namespace freshet::test {
namespace {

/// Keeps all columns of a file.
class AllColumns final : public PointSink {
 public:
  AllColumns() : PointSink("a.bgeo") {}
  void name(const std::string& column, std::size_t place) override {
    if (names.size() <= place) names.resize(place + 1);
    names[place] = column;
  }
  void check() override {}
  bool reads(std::size_t) const override { return true; }
  void note(std::string_view, double) override {}
  void add(const std::vector<double>& values) override { rows.push_back(values); }

  double at(std::size_t row, const std::string& column) const {
    const auto found = std::find(names.begin(), names.end(), column);
    return found == names.end() ? std::nan("") : rows[row][std::size_t(found - names.begin())];
  }
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
};

AllColumns columns_of(const Frame& frame, const DataFields& fields) {
  AllColumns columns;
  read_bgeo(encode_bgeo(frame, fields), columns);
  return columns;
}

TEST(FrameBgeo, IsReadByTheReaderOfPointFiles) {
  for (const int dimension : {2, 3}) {
    Frame frame = sample_frame(dimension, 4);
    frame.liquid = {0, 1, 2, 1};
    DataFields fields;
    fields.pscale = 0.25f;
    const AllColumns columns = columns_of(frame, fields);
    ASSERT_EQ(columns.rows.size(), 4);
    const auto d = std::size_t(dimension);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::string axis(1, "xyz"[k]);
        EXPECT_EQ(columns.at(i, axis), k < d ? double(frame.x[d * i + k]) : 0.0);
        EXPECT_EQ(columns.at(i, "v" + axis), k < d ? double(frame.v[d * i + k]) : 0.0);
      }
      EXPECT_EQ(columns.at(i, "density"), double(frame.density[i]));
      EXPECT_EQ(columns.at(i, "pressure"), double(frame.pressure[i]));
      EXPECT_EQ(columns.at(i, "id"), double(frame.id[i]));
      EXPECT_EQ(columns.at(i, "pscale"), 0.25);
      EXPECT_EQ(columns.at(i, "liquid"), double(frame.liquid[i]));
    }
  }
}

TEST(FrameBgeo, HasTheBytesOfTheFormat) {
  Frame frame = sample_frame(3, 1);
  frame.x = {1, 2, 3};
  DataFields few;
  few.velocity = few.density = few.pressure = few.id = false;
  using namespace std::string_literals;
  EXPECT_EQ(encode_bgeo(frame, few),
            "BgeoV\0\0\0\5\0\0\0\1\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
            "\x3F\x80\0\0\x40\0\0\0\x40\x40\0\0\x3F\x80\0\0\0\xFF"s);
  frame.x.clear();
  frame.id.clear();
  EXPECT_EQ(encode_bgeo(frame, few).size(), 43u);
}

TEST(FrameBgeo, RejectsIdsOfMoreThan31Bits) {
  EXPECT_THROW(encode_bgeo(sample_frame(3, 2, std::uint64_t(1) << 31), {}), Error);
  EXPECT_NO_THROW(encode_bgeo(sample_frame(3, 1, (std::uint64_t(1) << 31) - 1), {}));
}

}  // namespace
}  // namespace freshet::test
