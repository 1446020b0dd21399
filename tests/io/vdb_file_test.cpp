// SPDX-License-Identifier: MIT
#include "io/vdb_file.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

namespace freshet::test {
namespace {

/// Reads what encode_vdb() writes, by the description of OpenVDB's format 224.
class VdbReader {
 public:
  explicit VdbReader(const std::string& bytes) : bytes_(bytes) {
    EXPECT_EQ(take<std::int64_t>(), 0x56444220);
    EXPECT_EQ(take<std::uint32_t>(), 224u);
    at_ += 9;   // version of the library; grids have places
    at_ += 36;  // the UUID
    metadata();
    const int grids = take<std::int32_t>();
    for (int k = 0; k < grids; ++k) grid();
    EXPECT_EQ(at_, bytes.size());
  }
  struct Grid {
    std::string type;
    std::map<std::string, std::string> about;
    double cell = 0, x = 0;
    float background = 0;
    std::map<std::array<int, 3>, std::array<float, 3>> active;
    std::map<std::array<int, 3>, float> blocks, tiles;  ///< signs of their inactive values
    std::map<std::array<int, 3>, float> inactive;
  };
  std::map<std::string, Grid> grids;

 private:
  using Words = std::vector<std::uint64_t>;
  template <class T> T take() {
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }
  std::string text() {
    const auto size = take<std::uint32_t>();
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }
  std::map<std::string, std::string> metadata() {
    std::map<std::string, std::string> all;
    for (auto left = take<std::uint32_t>(); left > 0; --left) {
      const std::string name = text(), type = text();
      all[name] = text();
    }
    return all;
  }
  Words mask(int bits) {
    Words words;
    for (int k = 0; k < bits / 64; ++k) words.push_back(take<std::uint64_t>());
    return words;
  }
  static bool has(const Words& words, int k) { return words[std::size_t(k) / 64] >> (k % 64) & 1; }
  /// The signs of the inactive values of a node: 1, or -1 where they are -background.
  std::vector<float> signs(int count) {
    std::vector<float> all(std::size_t(count), 1);
    const int how = take<char>();
    EXPECT_TRUE(how == 0 || how == 3);
    if (how == 3) {
      const Words outside = mask(count);
      for (int k = 0; k < count; ++k) all[std::size_t(k)] = has(outside, k) ? 1.0f : -1.0f;
    }
    return all;
  }
  static std::array<int, 3> child(std::array<int, 3> corner, int k, int log, int edge) {
    const int in = (1 << log) - 1;
    return {corner[0] + (k >> (2 * log)) * edge, corner[1] + (k >> log & in) * edge,
            corner[2] + (k & in) * edge};
  }
  void grid() {
    const std::string name = text();
    Grid& g = grids[name];
    g.type = text();
    EXPECT_EQ(text(), "");
    const auto start = take<std::int64_t>(), values = take<std::int64_t>(),
               end = take<std::int64_t>();
    EXPECT_EQ(std::size_t(start), at_);
    EXPECT_EQ(take<std::uint32_t>(), 2u);
    g.about = metadata();
    EXPECT_EQ(text(), "UniformScaleTranslateMap");
    g.x = take<double>();
    at_ += 16;
    g.cell = take<double>();
    at_ += 14 * 8;
    EXPECT_EQ(take<std::uint32_t>(), 1u);
    const int components = g.type.find("vec3s") != std::string::npos ? 3 : 1;
    for (int k = 0; k < components; ++k) g.background = take<float>();
    EXPECT_EQ(take<std::uint32_t>(), 0u);
    std::vector<std::array<int, 3>> leaves;
    for (auto left = take<std::uint32_t>(); left > 0; --left) upper(g, leaves);
    EXPECT_EQ(std::size_t(values), at_);
    for (const auto& corner : leaves)
      leaf(g, corner, components, g.type.find("Half") != std::string::npos);
    EXPECT_EQ(std::size_t(end), at_);
  }
  void upper(Grid& g, std::vector<std::array<int, 3>>& leaves) {
    std::array<int, 3> corner;
    for (int& c : corner) c = take<std::int32_t>();
    const Words children = mask(32768);
    mask(32768);
    signs(32768);
    for (int k = 0; k < 32768; ++k)
      if (has(children, k)) lower(g, child(corner, k, 5, 128), leaves);
  }
  void lower(Grid& g, std::array<int, 3> corner, std::vector<std::array<int, 3>>& leaves) {
    const Words children = mask(4096);
    mask(4096);
    const std::vector<float> inside = signs(4096);
    for (int k = 0; k < 4096; ++k) {
      if (has(children, k)) {
        leaves.push_back(child(corner, k, 4, 8));
        mask(512);
      } else if (inside[std::size_t(k)] < 0) {
        g.tiles[child(corner, k, 4, 8)] = -1;
      }
    }
  }
  void leaf(Grid& g, std::array<int, 3> corner, int components, bool half) {
    const Words active = mask(512);
    const std::vector<float> sign = signs(512);
    for (int k = 0; k < 512; ++k) {
      const std::array<int, 3> p = child(corner, k, 3, 1);
      if (!has(active, k)) {
        g.inactive[p] = sign[std::size_t(k)];
        continue;
      }
      for (int c = 0; c < components; ++c)
        g.active[p][std::size_t(c)] = half ? from_half(take<std::uint16_t>()) : take<float>();
    }
  }

 public:
  static float from_half(std::uint16_t bits) {
    const int exponent = bits >> 10 & 31;
    const auto digits = float(bits & 1023);
    const float size =
        exponent == 0 ? std::ldexp(digits, -24) : std::ldexp(1024 + digits, exponent - 25);
    return bits >> 15 ? -size : size;
  }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

using Values = std::array<float, block_points>;
constexpr double corner[] = {0.5, -1, 2};

TEST(VdbFile, HoldsALevelSet) {
  Values near, far;  // two blocks of distances from the plane x = 3
  for (int k = 0; k < block_points; ++k) {
    near[std::size_t(k)] = std::clamp(float(k % block_cells) - 3, -3.0f, 3.0f);
    far[std::size_t(k)] = 3;
  }
  far[std::size_t(point_index(1, 2, 5))] = -2.5f;
  const VdbGrid grid{"surface",
                     VdbGrid::Class::level_set,
                     1,
                     3,
                     false,
                     0.1f,
                     {{{-1, 0, 0}, {near.data()}}, {{16, 2, -513}, {far.data()}}},
                     {{-2, 0, 0}, {-600, 4, 4}}};
  const std::string bytes = encode_vdb({grid}, corner, 0.1, 0.25, 40);
  const VdbReader file(bytes);
  const auto& read = file.grids.at("surface");
  EXPECT_EQ(read.type, "Tree_float_5_4_3");
  EXPECT_EQ(read.about.at("class"), "level set");
  EXPECT_EQ(read.cell, 0.1);
  EXPECT_EQ(read.x, 0.5);
  EXPECT_FLOAT_EQ(read.background, 0.3f);
  EXPECT_EQ(read.active.size(), 5u * 64 + 1) << "the points within the band";
  EXPECT_FLOAT_EQ(read.active.at({-8 + 2, 7, 1})[0], -0.1f);
  EXPECT_FLOAT_EQ(read.active.at({16 * 8 + 1, 2 * 8 + 2, -513 * 8 + 5})[0], -0.25f);
  EXPECT_EQ(read.inactive.at({-8, 0, 0}), -1);
  EXPECT_EQ(read.inactive.at({-8 + 7, 0, 0}), 1);
  EXPECT_EQ(read.tiles.size(), 2u);
  EXPECT_TRUE(read.tiles.contains({-16, 0, 0}) && read.tiles.contains({-4800, 32, 32}));
  EXPECT_EQ(bytes, encode_vdb({grid}, corner, 0.1, 0.25, 40)) << "also the UUID";
  EXPECT_NE(bytes.substr(21, 36), encode_vdb({grid}, corner, 0.1, 0.5, 41).substr(21, 36));
}

TEST(VdbFile, HoldsVectorsOfHalfFloats) {
  Values x{}, y{}, z{};
  const auto k = std::size_t(point_index(1, 2, 3));
  x[k] = 1.5f, z[k] = -0.1f;
  Values fluid{};
  fluid[k] = fluid[std::size_t(point_index(7, 0, 0))] = 1;
  const VdbGrid grid{"v",
                     VdbGrid::Class::unknown,
                     3,
                     0,
                     true,
                     1,
                     {{{0, 0, 0}, {x.data(), y.data(), z.data()}, fluid.data()}},
                     {}};
  const std::string bytes = encode_vdb({grid}, corner, 0.1, 0, 0);
  const VdbReader file(bytes);
  const auto& read = file.grids.at("v");
  EXPECT_EQ(read.type, "Tree_vec3s_5_4_3_HalfFloat");
  ASSERT_EQ(read.active.size(), 2u);
  EXPECT_EQ(read.active.at({7, 0, 0})[0], 0) << "at rest";
  const auto value = read.active.at({1, 2, 3});
  EXPECT_EQ(value[0], 1.5f);
  EXPECT_EQ(value[1], 0);
  EXPECT_NEAR(value[2], -0.1, 1e-4);
}

TEST(VdbFile, OfNothingHasAnEmptyTree) {
  const VdbGrid grid{"density", VdbGrid::Class::fog_volume, 1, 0, true, 1, {}, {}};
  const std::string bytes = encode_vdb({grid}, corner, 0.1, 0, 0);
  const VdbReader file(bytes);
  EXPECT_TRUE(file.grids.at("density").active.empty());
}

TEST(VdbFile, RoundsToTheNearestHalfFloat) {
  for (int bits = 0; bits < 0x7C00; ++bits) {
    const float value = VdbReader::from_half(std::uint16_t(bits));
    ASSERT_EQ(half_float(value), bits);
    ASSERT_EQ(half_float(-value), bits | 0x8000);
    const float next = VdbReader::from_half(std::uint16_t(bits + 1));
    if (bits + 1 < 0x7C00) {
      ASSERT_EQ(half_float(value + 0.49f * (next - value)), bits);
      ASSERT_EQ(half_float(value + 0.51f * (next - value)), bits + 1);
    }
  }
  EXPECT_EQ(half_float(1e9f), 0x7BFF) << "the largest one";
}

}  // namespace
}  // namespace freshet::test
