// SPDX-License-Identifier: MIT
/// Data files byte by byte, after the specifications of their formats.
#include "io/frame_data.h"

#include <gtest/gtest.h>

#include <cstring>
#include <pugixml.hpp>

#include "io/sample_frame.h"

namespace freshet::test {
namespace {

template <class T> T number_at(const std::string& bytes, std::size_t at) {
  T value{};
  if (at + sizeof value > bytes.size()) ADD_FAILURE() << "no number at " << at;
  else std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// A parsed VTP file: its elements, and the appended bytes after the underscore.
struct Vtp {
  explicit Vtp(const std::string& bytes) {
    const auto tag = bytes.find("<AppendedData encoding=\"raw\">");
    const auto underscore = bytes.find('_', tag);
    elements.load_string((bytes.substr(0, tag) + "</VTKFile>").c_str());
    appended = bytes.substr(underscore + 1);
    EXPECT_TRUE(bytes.ends_with("\n  </AppendedData>\n</VTKFile>\n"));
  }
  template <class T> std::vector<T> numbers(const pugi::xml_node& array) const {
    const std::size_t at = array.attribute("offset").as_ullong();
    std::vector<T> all(number_at<std::uint64_t>(appended, at) / sizeof(T));
    for (std::size_t k = 0; k < all.size(); ++k)
      all[k] = number_at<T>(appended, at + 8 + k * sizeof(T));
    return all;
  }
  pugi::xml_node root() const { return elements.child("VTKFile"); }
  pugi::xml_node piece() const { return root().child("PolyData").child("Piece"); }
  pugi::xml_node array(const char* of, const char* name) const {
    return piece().child(of).find_child_by_attribute("Name", name);
  }
  pugi::xml_document elements;
  std::string appended;
};

TEST(EncodeVtp, HasPointsArraysAndOneVertexPerParticle) {
  const Frame f = sample_frame(3, 5);
  const Vtp vtp(encode_vtp(f));
  EXPECT_STREQ("PolyData", vtp.root().attribute("type").value());
  EXPECT_STREQ("UInt64", vtp.root().attribute("header_type").value());
  EXPECT_STREQ("LittleEndian", vtp.root().attribute("byte_order").value());
  EXPECT_EQ(5, vtp.piece().attribute("NumberOfPoints").as_int());
  EXPECT_EQ(5, vtp.piece().attribute("NumberOfVerts").as_int());
  const auto points = vtp.piece().child("Points").child("DataArray");
  EXPECT_STREQ("Float32", points.attribute("type").value());
  EXPECT_EQ(f.x, vtp.numbers<float>(points));
  EXPECT_EQ(f.v, vtp.numbers<float>(vtp.array("PointData", "velocity")));
  EXPECT_EQ(f.density, vtp.numbers<float>(vtp.array("PointData", "density")));
  EXPECT_EQ(f.pressure, vtp.numbers<float>(vtp.array("PointData", "pressure")));
  EXPECT_EQ(f.id, vtp.numbers<std::uint64_t>(vtp.array("PointData", "id")));
  EXPECT_EQ((std::vector<std::int32_t>{0, 1, 2, 3, 4}),
            vtp.numbers<std::int32_t>(vtp.array("Verts", "connectivity")));
  EXPECT_EQ((std::vector<std::int32_t>{1, 2, 3, 4, 5}),
            vtp.numbers<std::int32_t>(vtp.array("Verts", "offsets")));
  const auto fields = vtp.root().child("PolyData").child("FieldData");
  EXPECT_STREQ("0.1", fields.find_child_by_attribute("Name", "TimeValue").child_value());
  EXPECT_STREQ("1234", fields.find_child_by_attribute("Name", "Step").child_value());
}

TEST(EncodeVtp, HasThreeComponentsPerPointIn2D) {
  const Frame f = sample_frame(2, 2);
  const Vtp vtp(encode_vtp(f));
  EXPECT_EQ((std::vector<float>{f.x[0], f.x[1], 0, f.x[2], f.x[3], 0}),
            vtp.numbers<float>(vtp.piece().child("Points").child("DataArray")));
  EXPECT_EQ((std::vector<float>{f.v[0], f.v[1], 0, f.v[2], f.v[3], 0}),
            vtp.numbers<float>(vtp.array("PointData", "velocity")));
}

TEST(EncodeVtp, HasTheSelectedFieldsOnly) {
  Scene::Output output;
  output.fields = {DataField::pressure};
  const Vtp vtp(encode_vtp(sample_frame(3, 2), DataFields(output)));
  EXPECT_TRUE(vtp.array("PointData", "pressure"));
  for (const char* name : {"velocity", "density", "id"})
    EXPECT_FALSE(vtp.array("PointData", name)) << name;
}

TEST(EncodePly, HasAHeaderAndOneRowPerParticle) {
  const Frame f = sample_frame(3, 2, 40);
  const std::string bytes = encode_ply(f);
  const std::string head =
      "ply\nformat binary_little_endian 1.0\ncomment time 0.1\ncomment step 1234\n"
      "comment dimension 3\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty float vx\nproperty float vy\nproperty float vz\n"
      "property float density\nproperty float pressure\nproperty uint id\nend_header\n";
  ASSERT_EQ(head, bytes.substr(0, head.size()));
  ASSERT_EQ(head.size() + 2 * 36, bytes.size());
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t at = head.size() + 36 * i;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(f.x[3 * i + k], number_at<float>(bytes, at + 4 * k));
      EXPECT_EQ(f.v[3 * i + k], number_at<float>(bytes, at + 12 + 4 * k));
    }
    EXPECT_EQ(f.density[i], number_at<float>(bytes, at + 24));
    EXPECT_EQ(f.pressure[i], number_at<float>(bytes, at + 28));
    EXPECT_EQ(f.id[i], number_at<std::uint32_t>(bytes, at + 32));
  }
}

TEST(EncodePly, StoresLargeIdsAsDoubles) {
  const std::string bytes = encode_ply(sample_frame(2, 2, 4294967295));
  EXPECT_NE(std::string::npos, bytes.find("property double id\n"));
  EXPECT_EQ(4294967297.0, number_at<double>(bytes, bytes.size() - 8));
  EXPECT_EQ(0.0f, number_at<float>(bytes, bytes.size() - 40 + 8));  // z
}

TEST(EncodeCsv, HasALineOfNamesAndOneRowPerParticle) {
  Frame f = sample_frame(2, 2, 5);
  f.x = {0.1f, 2, 3, 1e-7f};
  f.v = {1, -1, 0, 0.5f};
  f.density = {1000, 999.5f};
  f.pressure = {0, -3};
  EXPECT_EQ(
      "step,time,id,x,y,vx,vy,density,pressure\n"
      "1234,0.1,5,0.1,2,1,-1,1000,0\n"
      "1234,0.1,7,3,1e-07,0,0.5,999.5,-3\n",
      encode_csv(f));
  DataFields few;
  few.velocity = few.density = few.id = false;
  EXPECT_EQ("step,time,x,y,z,pressure\n", encode_csv(sample_frame(3, 0), few));
}

TEST(EncodePvd, NamesFilesRelativeToItsFolder) {
  const std::vector<double> times{0, 0.25};
  const std::vector<std::string> files{"data/frame_0000.vtp", "data/frame_0001.vtp"};
  pugi::xml_document pvd;
  ASSERT_TRUE(pvd.load_string(encode_pvd(times, files).c_str()));
  const auto root = pvd.child("VTKFile");
  EXPECT_STREQ("Collection", root.attribute("type").value());
  const auto first = root.child("Collection").first_child(), second = first.next_sibling();
  EXPECT_STREQ("0", first.attribute("timestep").value());
  EXPECT_STREQ("frame_0000.vtp", first.attribute("file").value());
  EXPECT_STREQ("0.25", second.attribute("timestep").value());
  EXPECT_STREQ("frame_0001.vtp", second.attribute("file").value());
  EXPECT_FALSE(second.next_sibling());
}

TEST(DataFiles, AreNamedByFormatAndFrame) {
  Scene scene;
  scene.output.data = {DataFormat::hdf5, DataFormat::vtp};
  EXPECT_EQ(
      (std::vector<std::string>{"data/frame_0000.h5", "data/frame_0001.h5", "data/frame_0000.vtp",
                                "data/frame_0001.vtp", "data/frames.pvd"}),
      data_files(scene, 2));
  scene.output.data = {DataFormat::vtp};
  scene.whitewater.emplace();
  EXPECT_EQ((std::vector<std::string>{"data/frame_0000.vtp", "data/frames.pvd",
                                      "data/whitewater_0000.vtp", "data/whitewater.pvd"}),
            data_files(scene, 1));
  scene.output.data = {};
  EXPECT_TRUE(data_files(scene, 2).empty());
  EXPECT_EQ("data/frame_12345.csv", data_file(DataFormat::csv, 12345));
}

}  // namespace
}  // namespace freshet::test
