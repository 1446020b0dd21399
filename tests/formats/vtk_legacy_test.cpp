// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "formats/point_bytes.h"

namespace freshet::test {
namespace {

const std::vector<double> legacy_x{1, 2, 3, 4.5, 5, 6}, legacy_v{7, 8, 9, 10, 11, 12};

std::string legacy_head(const std::string& storage, const std::string& type,
                        const std::string& version = "3.0") {
  return "# vtk DataFile Version " + version + "\na title\n" + storage + "\nDATASET " + type + "\n";
}

const std::string ascii_points = "POINTS 2 float\n1 2 3\n4.5 5 6\n";
const std::string ascii_polydata = legacy_head("ASCII", "POLYDATA") + ascii_points;

/// As DualSPHysics writes it: big-endian numbers between lines of text.
std::string binary_polydata() {
  return legacy_head("BINARY", "POLYDATA") + "POINTS 2 float\n" +
         big_endian<float>({1, 2, 3, 4.5, 5, 6}) + "\nVERTICES 2 4\n" +
         big_endian<std::int32_t>({1, 0, 1, 1}) + "\nPOINT_DATA 2\nSCALARS Idp unsigned_int\n" +
         "LOOKUP_TABLE default\n" + big_endian<std::uint32_t>({0, 1}) + "\nVECTORS Vel float\n" +
         big_endian<float>({7, 8, 9, 10, 11, 12}) + "\nSCALARS Rhop float\nLOOKUP_TABLE default\n" +
         big_endian<float>({1000, 1001}) + "\n";
}

TEST(VtkLegacy, ReadsBinaryPolydata) {
  const PointCloud cloud = points_in(binary_polydata(), "a.vtk", 3);
  EXPECT_EQ(legacy_x, cloud.x);
  EXPECT_EQ(legacy_v, cloud.v);
  EXPECT_EQ((std::vector<std::string>{"Idp", "Rhop"}), cloud.unused);
}

/// As SPlisHSPlasH writes it: attributes in a field.
TEST(VtkLegacy, ReadsABinaryUnstructuredGrid) {
  const std::string bytes =
      legacy_head("BINARY", "UNSTRUCTURED_GRID", "4.1") + "POINTS 2 double\n" +
      big_endian<double>({1, 2, 3, 4.5, 5, 6}) + "\nCELLS 2 4\n" +
      big_endian<std::int32_t>({1, 0, 1, 1}) + "\nCELL_TYPES 2\n" +
      big_endian<std::int32_t>({1, 1}) + "\nPOINT_DATA 2\nSCALARS id unsigned_int 1\n" +
      "LOOKUP_TABLE id_table\n" + big_endian<std::uint32_t>({0, 1}) + "\nFIELD FieldData 2\n" +
      "density 1 2 double\n" + big_endian<double>({1000, 1000}) + "\nvelocity 3 2 double\n" +
      big_endian<double>({7, 8, 9, 10, 11, 12}) + "\n";
  const PointCloud cloud = points_in(bytes, "a.vtk", 3);
  EXPECT_EQ(legacy_x, cloud.x);
  EXPECT_EQ(legacy_v, cloud.v);
  EXPECT_EQ((std::vector<std::string>{"id", "density"}), cloud.unused);
}

/// As VTK 9 writes it: offsets of cells, fields of the file, and information behind arrays.
TEST(VtkLegacy, ReadsAsciiOfVersion5) {
  const std::string text =
      legacy_head("ASCII", "POLYDATA", "5.1") + "FIELD FieldData 1\nTimeValue 1 1 double\n0.5 \n" +
      ascii_points +
      "METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 1 2 \n\n"
      "VERTICES 3 2\nOFFSETS vtktypeint64\n0 1 2 \nCONNECTIVITY vtktypeint64\n0 1 \n"
      "CELL_DATA 2\nSCALARS patch int\nLOOKUP_TABLE default\n1 2\n"
      "POINT_DATA 2\nNORMALS Normals float\n0 0 1 0 0 1\nTEXTURE_COORDINATES uv 2 float\n0 0 1 1\n"
      "COLOR_SCALARS rgb 3\n0 0 1 0 0 1\nLOOKUP_TABLE rainbow 1\n0 0 0 1\n"
      "FIELD FieldData 3\nphase%20field 1 2 short\n0 1\nMETADATA\nCOMPONENT_NAMES\nphase\n\n"
      "U 3 2 float\n7 8 9 10 11 12\nNULL_ARRAY\n";
  const PointCloud cloud = points_in(text, "a.vtk", 3);
  EXPECT_EQ(legacy_x, cloud.x);
  EXPECT_EQ(legacy_v, cloud.v);
  EXPECT_EQ((std::vector<std::string>{"Normals", "uv", "rgb", "patch", "phase field"}).size(),
            cloud.unused.size());
  for (const char* name : {"Normals", "uv", "rgb", "patch", "phase field"})
    EXPECT_EQ(1, std::count(cloud.unused.begin(), cloud.unused.end(), name)) << name;
}

TEST(VtkLegacy, ReadsBinaryOfVersion5) {
  const std::string bytes =
      legacy_head("BINARY", "UNSTRUCTURED_GRID", "5.1") + "POINTS 2 float\n" +
      big_endian<float>({1, 2, 3, 4.5, 5, 6}) + "\nMETADATA\nINFORMATION 0\n\nCELLS 3 2\n" +
      "OFFSETS vtktypeint64\n" + big_endian<std::int64_t>({0, 1, 2}) +
      "\nCONNECTIVITY vtktypeint64\n" + big_endian<std::int64_t>({0, 1}) + "\nCELL_TYPES 2\n" +
      big_endian<std::int32_t>({1, 1}) + "\nPOINT_DATA 2\nFIELD FieldData 1\nv 3 2 double\n" +
      big_endian<double>({7, 8, 9, 10, 11, 12}) + "\nMETADATA\nCOMPONENT_NAMES\nX\n\n";
  const PointCloud cloud = points_in(bytes, "a.vtk", 3);
  EXPECT_EQ(legacy_x, cloud.x);
  EXPECT_EQ(legacy_v, cloud.v);
  EXPECT_TRUE(cloud.unused.empty());
}

TEST(VtkLegacy, ReadsVelocitiesAsScalars) {
  const PointCloud cloud =
      points_in(ascii_polydata +
                    "point_data 2\nscalars vx float\nlookup_table default\n7 10\n"
                    "SCALARS vy double 1\n8 11\nSCALARS vz float\n9\n12\n",
                "a.VTK", 3);
  EXPECT_EQ(legacy_v, cloud.v);
  EXPECT_TRUE(cloud.unused.empty());
}

TEST(VtkLegacy, DamagedFilesGivePointsOrErrors) {
  const std::string binary = binary_polydata();
  damage(binary, "a.vtk", binary.find("\nVERTICES"), 6);
  const std::string ascii = ascii_polydata + "POINT_DATA 2\nVECTORS v float\n7 8 9 10 11 12\n";
  damage(ascii, "a.vtk", ascii.find(" 6\n"), 6);
  for (std::size_t n = binary.find("VECTORS") + 1; n < binary.find("\nSCALARS Rhop"); ++n)
    EXPECT_NE("read without an error", read_error(binary.substr(0, n), "a.vtk")) << n;
}

TEST(VtkLegacy, ReportsLineAndRemedy) {
  const auto error = [](const std::string& text) { return read_error(text, "a.vtk"); };
  EXPECT_EQ(
      "a.vtk:1: error: not legacy VTK: the first line is not \"# vtk DataFile Version\"; check the "
      "file",
      error("<VTKFile type=\"PolyData\">\n"));
  EXPECT_EQ("a.vtk:3: error: line 3 must be ASCII or BINARY; save the file again",
            error("# vtk DataFile Version 3.0\ntitle\nDATASET POLYDATA\n"));
  EXPECT_EQ(
      "a.vtk:4: error: DATASET is \"structured_points\" and must be POLYDATA or "
      "UNSTRUCTURED_GRID; save the points as one of them",
      error(legacy_head("ASCII", "STRUCTURED_POINTS")));
  EXPECT_EQ("a.vtk: error: the file has no POINTS; save it again",
            error(legacy_head("ASCII", "POLYDATA")));
  EXPECT_EQ(
      "a.vtk:5: error: POINTS has 18446744073709551615 tuples, and the file is too short; it is "
      "cut off",
      error(legacy_head("ASCII", "POLYDATA") + "POINTS 18446744073709551615 float\n1 2 3\n"));
  EXPECT_EQ(
      "a.vtk:5: error: POINTS has 6148914691236517206 tuples, and the file is too short; it is cut "
      "off",  // 3 times this is 2
      error(legacy_head("BINARY", "POLYDATA") + "POINTS 6148914691236517206 char\n123456\n"));
  EXPECT_EQ("a.vtk:5: error: POINTS has no valid count; save the file again",
            error(legacy_head("ASCII", "POLYDATA") + "POINTS -1 float\n"));
  EXPECT_EQ(
      "a.vtk:5: error: POINTS must have a numeric type such as float; save the file again without "
      "it",
      error(legacy_head("ASCII", "POLYDATA") + "POINTS 1 string\n1 2 3\n"));
  EXPECT_EQ("a.vtk:7: error: array \"points\": value 4 is not a finite number; save the file again",
            error(legacy_head("ASCII", "POLYDATA") + "POINTS 2 float\n1 2 3\n4 nan 6\n"));
  EXPECT_EQ("a.vtk: error: array \"points\" is inf at point 0; its values must be finite",
            error(legacy_head("BINARY", "POLYDATA") + "POINTS 1 float\n" +
                  big_endian<float>({1, INFINITY, 3})));
  EXPECT_EQ("a.vtk:8: error: POINT_DATA is 3, and the number of points is 2; save the file again",
            error(ascii_polydata + "POINT_DATA 3\n"));
  EXPECT_EQ("a.vtk:9: error: unknown keyword \"vecters\"; save the file again",
            error(ascii_polydata + "POINT_DATA 2\nVECTERS v float\n"));
  EXPECT_EQ(
      "a.vtk:10: error: array \"v\" has 3 tuples, and the number of points is 2; save the file "
      "again",
      error(ascii_polydata + "POINT_DATA 2\nFIELD FieldData 1\nv 3 3 float\n"));
  EXPECT_EQ("a.vtk:10: error: FIELD has fewer arrays than its count; the file is cut off",
            error(ascii_polydata + "POINT_DATA 2\nFIELD FieldData 2\na 1 2 int 1 2\n"));
  EXPECT_EQ("a.vtk:11: error: array \"p\": value 1 is not a number; save the file again",
            error(ascii_polydata + "POINT_DATA 2\nSCALARS p float\n5\nNORMALS n float\n"));
  EXPECT_EQ("a.vtk:8: error: POINTS occurs twice; save the points as one data set",
            error(ascii_polydata + "POINTS 2 float\n"));
  EXPECT_EQ("a.vtk: error: z is 3, and the scene is in 2D; make it 0, or add z to domain.max",
            read_error(ascii_polydata, "a.vtk", 2));
}

}  // namespace
}  // namespace freshet::test
