// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>

#include "formats/point_bytes.h"

namespace freshet::test {
namespace {

std::string houdini_name(const std::string& name) {
  return big_endian<std::uint16_t>({std::uint16_t(name.size())}) + name;
}

/// An attribute of numbers, with its defaults.
std::string attribute(const std::string& name, std::uint16_t size, std::int32_t type) {
  return houdini_name(name) + big_endian<std::uint16_t>({size}) + big_endian<std::int32_t>({type}) +
         std::string(4u * size, '\0');
}

std::string bgeo_head(std::int32_t points, std::int32_t attributes) {
  return "BgeoV" + big_endian<std::int32_t>({5, points, 0, 0, 0, attributes, 0, 0, 0});
}

/// Two points with an integer, a velocity and a name each, as Partio writes them.
std::string two_points(const std::string& velocity = "velocity", std::int32_t points = 2) {
  std::string bytes = bgeo_head(points, 3) + attribute("id", 1, 1) + attribute(velocity, 3, 5) +
                      houdini_name("material") + big_endian<std::uint16_t>({1}) +
                      big_endian<std::int32_t>({4, 2}) + houdini_name("water") +
                      houdini_name("oil");
  for (const float k : {0.0f, 3.0f})
    bytes += big_endian<float>({1 + k, 2 + k, 3 + k, 1}) + big_endian<std::int32_t>({7}) +
             big_endian<float>({4 + k, 5 + k, 6 + k}) + big_endian<std::int32_t>({1});
  return bytes;
}

std::string gzipped(const std::string& bytes) {
  z_stream z = {};
  EXPECT_EQ(Z_OK,
            deflateInit2(&z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY));
  std::string packed(bytes.size() + 100, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = uInt(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = uInt(packed.size());
  EXPECT_EQ(Z_STREAM_END, deflate(&z, Z_FINISH));
  packed.resize(z.total_out);
  deflateEnd(&z);
  return packed;
}

TEST(Bgeo, ReadsPlainAndCompressedFiles) {
  for (const std::string& bytes : {two_points(), gzipped(two_points()), two_points("v")}) {
    const PointCloud cloud = points_in(bytes, "a.bgeo", 3);
    EXPECT_EQ((std::vector<double>{1, 2, 3, 4, 5, 6}), cloud.x);
    EXPECT_EQ((std::vector<double>{4, 5, 6, 7, 8, 9}), cloud.v);
    EXPECT_EQ((std::vector<std::string>{"material", "id"}), cloud.unused);
  }
  EXPECT_TRUE(points_in(two_points("force"), "a.bhclassic", 3).v.empty());
}

TEST(Bgeo, DamagedFilesGivePointsOrErrors) {
  const std::string plain = two_points(), packed = gzipped(plain);
  damage(plain, "a.bgeo", plain.size(), 6);
  damage(packed, "a.bgeo", packed.size() - 20, 6);
}

TEST(Bgeo, ReportsWhatIsWrong) {
  const auto error = [](const std::string& bytes) { return read_error(bytes, "a.bgeo"); };
  EXPECT_EQ("a.bgeo: error: not a classic bgeo: it must begin with \"BgeoV\"; check the file",
            error("PGEOMETRY V5\n"));
  EXPECT_EQ(
      "a.bgeo: error: this bgeo is of Houdini 12 or newer; in Houdini, save it as *.bhclassic or "
      "*.ply",
      error("\x7FNSJb"));
  EXPECT_EQ(
      "a.bgeo: error: this bgeo is not of version 5; in Houdini, save it as *.bhclassic or *.ply",
      error("BgeoV" + big_endian<std::int32_t>({6})));
  EXPECT_EQ("a.bgeo: error: the number of points is negative; the file is damaged",
            error(bgeo_head(-1, 0)));
  EXPECT_EQ(
      "a.bgeo: error: the header announces 3 points, and the file is too short; it is cut off",
      error(two_points("velocity", 3)));
  EXPECT_EQ("a.bgeo: error: the file ends too early; it is cut off",  // allocates nothing for them
            error(gzipped(two_points("velocity", 1000))));
  EXPECT_EQ(
      "a.bgeo: error: the header announces 2147483647 points, and the file is too short; it is cut "
      "off",
      error(gzipped(two_points("velocity", 2147483647))));
  EXPECT_EQ("a.bgeo: error: attribute \"name\" has the unknown type 2; save the file without it",
            error(bgeo_head(1, 1) + attribute("name", 1, 2)));
  EXPECT_EQ("a.bgeo: error: the file ends too early; it is cut off",
            error(bgeo_head(1, 2) + attribute("v", 3, 5)));
  EXPECT_EQ("a.bgeo: error: 2147483647 point attributes; the maximum is 4096, save fewer",
            error(gzipped(bgeo_head(1, 2147483647) + std::string(1 << 20, '\0'))));
  EXPECT_EQ("a.bgeo: error: array \"points\" is nan at point 0; its values must be finite",
            error(bgeo_head(1, 0) + big_endian<float>({1, NAN, 3, 1})));
  EXPECT_EQ("a.bgeo: error: the file has no points; name another file", error(bgeo_head(0, 0)));
}

}  // namespace
}  // namespace freshet::test
