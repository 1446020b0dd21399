// SPDX-License-Identifier: MIT
#include "formats/point_formats.h"

#include <gtest/gtest.h>

#include "cli/files.h"
#include "formats/point_bytes.h"

namespace freshet::test {
namespace {

TEST(PointFormats, AreFoundByTheirExtension) {
  for (const PointFormat& format : point_formats())
    EXPECT_EQ(&format, point_format_of(std::string("a.b") + format.extension)) << format.extension;
  EXPECT_EQ(point_format_of("a.vtu"), point_format_of("A.VTU"));
  EXPECT_EQ(nullptr, point_format_of("vtu"));
}

TEST(PointFormats, OtherOnesGetARemedy) {
  const std::string known =
      "not a known format of points (*.csv, *.ply, *.vtk, *.vtp, *.vtu, *.xyz, *.bgeo or "
      "*.bhclassic); ";
  const auto remedy = [&](const std::string& file) {
    const std::string error = read_error("x", file), begin = file + ": error: " + known;
    return error.starts_with(begin) ? error.substr(begin.size()) : error;
  };
  EXPECT_EQ("convert it to *.csv or *.ply", remedy("a"));
  EXPECT_EQ("convert it with PartVTK of DualSPHysics, which writes *.vtk", remedy("Part_0001.BI4"));
  EXPECT_EQ("name one of the *.vtp or *.vtu files that it lists", remedy("frames.pvd"));
  EXPECT_EQ("a mesh needs shape = \"mesh\"; points are exported as *.ply", remedy("a.stl"));
  EXPECT_EQ("unpack it with gunzip", remedy("a.bgeo.gz"));
}

TEST(PointFormats, AreInTheDocumentation) {
  const std::string scene = read_text(source_dir / "docs/scene.md"),
                    data = read_text(source_dir / "docs/data_files.md");
  for (const PointFormat& format : point_formats()) {
    const std::string name = std::string("`*") + format.extension + "`";
    EXPECT_TRUE(contains(scene, name)) << name;
    EXPECT_TRUE(contains(data, name)) << name;
  }
}

}  // namespace
}  // namespace freshet::test
