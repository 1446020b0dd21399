// SPDX-License-Identifier: MIT
/// VTK XML files that VTK 9.1 wrote (tests/formats/vtk), and damaged ones.
#include <gtest/gtest.h>
#include <zlib.h>

#include "cli/files.h"
#include "freshet/error.h"
#include "io/frame_data.h"
#include "io/sample_frame.h"
#include "scene/sample/point_cloud.h"

namespace freshet::test {
namespace {

PointCloud read(const std::string& text, int dimension = 3) {
  return points_in(text, "a.vtp", dimension);
}

std::string refused(const std::string& text, int dimension = 3) {
  try {
    read(text, dimension);
    return "read without an error";
  } catch (const Error& e) {
    return e.what();
  }
}

class VtkFile : public testing::TestWithParam<const char*> {};

TEST_P(VtkFile, GivesPointsAndVelocities) {
  const std::string text = read_text(source_dir / "tests/formats/vtk" / GetParam());
  const PointCloud cloud = read(text);
  std::vector<double> x, v;
  for (int k = 0; k < 5; ++k) {
    x.insert(x.end(), {0.125 * k, 0.25 + k, -0.5 * k});
    v.insert(v.end(), {1.0 * k, 2 * k + 0.5, -1.0 * k});
  }
  EXPECT_EQ(x, cloud.x);
  EXPECT_EQ(v, cloud.v);
}

TEST_P(VtkFile, IsRejectedIfTruncated) {
  const std::string text = read_text(source_dir / "tests/formats/vtk" / GetParam());
  const std::size_t needed = text.find("<Verts>");
  for (std::size_t n = 0; n < needed; n += 7)
    EXPECT_THROW(read(text.substr(0, n)), Error) << n << " bytes";
}

TEST_P(VtkFile, WithAChangedByteGivesPointsOrAnError) {
  const std::string whole = read_text(source_dir / "tests/formats/vtk" / GetParam());
  for (std::size_t at = 0; at < whole.size(); at += 3)
    for (const char byte : {'\0', '9', '<', '"', '\xFF'}) {
      std::string text = whole;
      text[at] = byte;
      try {
        EXPECT_LE(read(text).x.size(), 15u);
      } catch (const Error& e) {
        EXPECT_TRUE(std::string(e.what()).starts_with("a.vtp")) << e.what();
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Files, VtkFile,
                         testing::Values("ascii.vtp", "binary_zlib.vtp", "binary_plain_64.vtp",
                                         "appended_base64_zlib.vtp", "appended_base64_plain_64.vtp",
                                         "appended_raw_zlib_64.vtp", "appended_raw_plain.vtp",
                                         "big_endian.vtp"));

TEST(VtkXml, OfAnotherKindIsRejectedWithARemedy) {
  EXPECT_EQ(
      "a.vtp: error: its compressor is LZ4 or LZMA; save it with ZLib, or without compression",
      refused(read_text(source_dir / "tests/formats/vtk/lz4.vtp")));
  EXPECT_EQ("a.vtp: error: its byte_order must be LittleEndian or BigEndian; save it again",
            refused("<VTKFile type=\"PolyData\" byte_order=\"Middle\"/>"));
  EXPECT_EQ(
      "a.vtp: error: its type is \"ImageData\" and must be PolyData or UnstructuredGrid; save the "
      "points as *.vtp or *.vtu, in one file",
      refused("<VTKFile type=\"ImageData\"/>"));
  EXPECT_EQ("a.vtp: error: not VTK XML: the element VTKFile is missing; check the file",
            refused("# vtk DataFile Version 3.0\n"));
  EXPECT_EQ("a.vtp: error: its header_type must be UInt32 or UInt64; save it again",
            refused("<VTKFile type=\"PolyData\" header_type=\"Int8\"/>"));
  EXPECT_EQ("a.vtp:2: error: invalid XML; the file is damaged or cut off",
            refused("<VTKFile type=\"PolyData\">\n  <PolyData>"));
  EXPECT_EQ("a.vtp: error: the file ends inside a tag; it is cut off",
            refused("<VTKFile><AppendedData encoding"));
  EXPECT_EQ("a.vtp: error: the file has no points; name another file",
            refused("<VTKFile type=\"PolyData\"/>"));
}

/// A file of one piece; the root element has `attributes`.
std::string file_of(const std::string& piece, const std::string& points = "1",
                    const std::string& attributes = "") {
  return "<VTKFile type=\"PolyData\" " + attributes + "><PolyData><Piece NumberOfPoints=\"" +
         points + "\">" + piece + "</Piece></PolyData></VTKFile>";
}

/// A Points element; its array has these attributes and this text.
std::string points_of(const std::string& attributes, const std::string& text) {
  return "<Points><DataArray NumberOfComponents=\"3\" " + attributes + ">" + text +
         "</DataArray></Points>";
}

const std::string ascii = "type=\"Float32\" format=\"ascii\"",
                  binary = "type=\"Float32\" format=\"binary\"";

TEST(VtkXml, JoinsPiecesAndSkipsEmptyOnes) {
  const std::string one = "<Piece NumberOfPoints=\"1\">" + points_of(ascii, "1 2\n3") + "</Piece>";
  const PointCloud cloud =
      read("<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"><PolyData>" + one +
           "<Piece NumberOfPoints=\"0\"/>" + one + "</PolyData></VTKFile>");
  EXPECT_EQ((std::vector<double>{1, 2, 3, 1, 2, 3}), cloud.x);
  EXPECT_TRUE(cloud.v.empty());
}

TEST(VtkXml, NamesArraysThatAreNotUsed) {
  const std::string array = "<DataArray NumberOfComponents=\"3\" " + ascii + " Name=";
  const PointCloud cloud =
      read(file_of(points_of(ascii, "1 2 3") + "<PointData>" + array + "\"Vel\">4 5 6</DataArray>" +
                   array + "\"Normals\">0 0 1</DataArray><DataArray " + ascii +
                   " Name=\"density\">7</DataArray></PointData>"));
  EXPECT_EQ((std::vector<double>{4, 5, 6}), cloud.v);
  EXPECT_EQ((std::vector<std::string>{"Normals", "density"}), cloud.unused);
}

TEST(VtkXml, In2DMustHaveAHeightOfZero) {
  EXPECT_EQ((std::vector<double>{1, 2}), read(file_of(points_of(ascii, "1 2 0")), 2).x);
  EXPECT_EQ("a.vtp: error: z is 3, and the scene is in 2D; make it 0, or add z to domain.max",
            refused(file_of(points_of(ascii, "1 2 3")), 2));
}

TEST(VtkXml, ReportsInvalidPieces) {
  EXPECT_EQ("a.vtp: error: a piece has no points; save the file again", refused(file_of("")));
  EXPECT_EQ("a.vtp: error: the attribute NumberOfPoints of a piece is missing; save the file again",
            refused(file_of("", "many")));
  EXPECT_EQ("a.vtp: error: its points must have 3 components; save the file again",
            refused(file_of("<Points><DataArray>1 2</DataArray></Points>")));
  EXPECT_EQ(
      "a.vtp: error: NumberOfPoints is 18446744073709551615, and the file is too short; it is cut "
      "off",
      refused(file_of(points_of(ascii, "1 2 3"), "18446744073709551615")));
  EXPECT_EQ("a.vtp: error: array \"Velocity\" has 1 component per point; write 3, or rename it",
            refused(file_of("<PointData><DataArray Name=\"Velocity\">1</DataArray></PointData>" +
                            points_of(ascii, "1 2 3"))));
  const std::string one = points_of(ascii, "1 2 3");
  EXPECT_EQ("a.vtp: error: its pieces have different arrays; merge them into one piece",
            refused("<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"1\">" + one +
                    "</Piece><Piece NumberOfPoints=\"1\"><PointData><DataArray Name=\"velocity\" "
                    "NumberOfComponents=\"3\">1 2 3</DataArray></PointData>" +
                    one + "</Piece></PolyData></VTKFile>"));
}

TEST(VtkXml, ReportsInvalidArrays) {
  const auto said = [](const std::string& attributes, const std::string& text,
                       const std::string& points = "1", const std::string& root = "") {
    const std::string what = refused(file_of(points_of(attributes, text), points, root));
    const std::string begin = "a.vtp:1: error: array \"points\": ";
    return what.starts_with(begin) ? what.substr(begin.size()) : what;
  };
  EXPECT_EQ("value 2 is not a finite number; save the file again", said(ascii, "1 2 three"));
  EXPECT_EQ("value 1 is not a finite number; save the file again", said(ascii, "1 nan 3"));
  EXPECT_EQ("more than the expected 3 numbers; save the file again", said(ascii, "1 2 3 4"));
  EXPECT_EQ("it ends too early; the file is cut off", said(ascii, "1 2", "2"));
  EXPECT_EQ("its format must be ascii, binary or appended; save the file again",
            said("type=\"Float32\" format=\"hex\"", "1 2 3"));
  EXPECT_EQ("its type is unknown; save it as Float32 or Float64",
            said("type=\"String32\" format=\"binary\"", "DAAAAAAAgD8AAIA/AACAPw=="));
  EXPECT_EQ("read without an error", said(binary, " DAAAAAAA gD8AAIA/AACAPw==\n"));
  EXPECT_EQ("read without an error", said(binary, "DAAAAA==AACAPwAAgD8AAIA/"));
  EXPECT_EQ("its data is not base64; save the file again",
            said(binary, "DAAA-AAAgD8AAIA/AACAPw=="));
  EXPECT_EQ("its data is not base64; save the file again",
            said(binary, "DA=AAAAAgD8AAIA/AACAPw=="));
  EXPECT_EQ("its data is not base64; save the file again",
            said(binary, "DAAAAAAAgD8AAIA/AACAP==="));
  EXPECT_EQ("it ends too early; the file is cut off", said(binary, "DAAAAAAAgD8AAIA/AACAPw="));
  EXPECT_EQ("it ends too early; the file is cut off", said(binary, "DAAAAAAAgD8AAIA/"));
  EXPECT_EQ("it ends too early; the file is cut off", said(binary, ""));
  EXPECT_EQ("12 bytes instead of 24; save the file again",
            said(binary, "DAAAAAAAgD8AAIA/AACAPw==", "2"));
  const std::string appended = "type=\"Float32\" format=\"appended\"";
  EXPECT_EQ("its offset is missing; save the file again", said(appended, ""));
  EXPECT_EQ("it ends too early; the file is cut off", said(appended + " offset=\"9\"", ""));
  EXPECT_EQ("it ends too early; the file is cut off", said(appended + " offset=\"0\"", ""));
}

std::string base64(const std::string& bytes) {
  static constexpr const char* digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned bits = 0;
    for (std::size_t b = 0; b < 3; ++b)
      bits = bits << 8 | (k + b < bytes.size() ? static_cast<unsigned char>(bytes[k + b]) : 0u);
    for (std::size_t d = 0; d < 4; ++d)
      text += k + d <= bytes.size() ? digits[bits >> (18 - 6 * d) & 63] : '=';
  }
  return text;
}

std::string sizes(const std::vector<std::uint32_t>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), 4 * numbers.size()};
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  packed.resize(size);
  return packed;
}

TEST(VtkXml, InflatesBlocksAndRejectsWrongSizes) {
  const float numbers[] = {1, 2, 3, 4, 5, 6};
  const std::string bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
  const std::string a = deflated(bytes.substr(0, 16)), b = deflated(bytes.substr(16));
  const auto sizes_of = [&](std::uint32_t blocks, std::uint32_t block, std::uint32_t last) {
    return base64(sizes({blocks, block, last, std::uint32_t(a.size()), std::uint32_t(b.size())}));
  };
  const auto text = [&](const std::string& header) {
    return file_of(points_of(binary, header + base64(a + b)), "2",
                   "compressor=\"vtkZLibDataCompressor\"");
  };
  EXPECT_EQ((std::vector<double>{1, 2, 3, 4, 5, 6}), read(text(sizes_of(2, 16, 8))).x);
  const std::string array = "a.vtp:1: error: array \"points\": ";
  EXPECT_EQ(array + "its zlib data is damaged; save the file again",
            refused(text(sizes_of(2, 16, 9))));
  EXPECT_EQ(array + "its zlib data is damaged; save the file again",
            refused(text(sizes_of(2, 15, 8))));
  EXPECT_EQ(array + "16 bytes instead of 24; save the file again",
            refused(text(base64(sizes({1, 16, 0, std::uint32_t(a.size())})))));
  EXPECT_EQ(array + "it ends too early; the file is cut off",
            refused(text(sizes_of(4000000000, 16, 8))));
  EXPECT_EQ(array + "it ends too early; the file is cut off",  // allocates no four billion bytes
            refused(text(sizes_of(2, 4000000000, 8))));
}

TEST(VtkXml, ErrorsOfTextNameTheLineOfTheValue) {
  EXPECT_EQ("a.vtp:4: error: array \"points\": value 4 is not a finite number; save the file again",
            refused(file_of("\n" + points_of(ascii, "\n1 2 3\n4 inf 6\n"), "2")));
}

TEST(VtkXml, RejectsBinaryValuesThatAreNotFinite) {
  const float numbers[] = {1, 2, 3, 4, NAN, 6};
  const std::string bytes(reinterpret_cast<const char*>(numbers), sizeof numbers);
  EXPECT_EQ("a.vtp: error: array \"points\" is nan at point 1; its values must be finite",
            refused(file_of(points_of(binary, base64(sizes({24}) + bytes)), "2")));
}

/// The same file as an UnstructuredGrid, as ParaView saves it for *.vtu.
TEST(VtkXml, ReadsAnUnstructuredGrid) {
  for (const char* file : {"ascii.vtp", "binary_zlib.vtp", "appended_raw_zlib_64.vtp"}) {
    const std::string text = read_text(source_dir / "tests/formats/vtk" / file);
    std::string grid = text;
    for (std::size_t at; (at = grid.find("PolyData")) != std::string::npos;)
      grid.replace(at, 8, "UnstructuredGrid");
    const PointCloud a = read(text), b = points_in(grid, "a.vtu", 3);
    EXPECT_EQ(a.x, b.x) << file;
    EXPECT_EQ(a.v, b.v) << file;
  }
}

TEST(VtkXml, ReadsTheVelocitiesOfCommonPrograms) {
  const auto array = [](const std::string& name, const std::string& numbers, int components) {
    return "<DataArray " + ascii + " Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\">" + numbers + "</DataArray>";
  };
  const auto with = [&](const std::string& arrays, int dimension = 3) {
    return read(file_of(points_of(ascii, dimension == 3 ? "1 2 3" : "1 2 0") + "<PointData>" +
                        arrays + "</PointData>"),
                dimension);
  };
  const std::vector<double> v{4, 5, 6};
  for (const char* name : {"v", "velocity", "Velocity", "vel", "Vel", "U", "Velocity [m/s]"})
    EXPECT_EQ(v, with(array(name, "4 5 6", 3)).v) << name;
  EXPECT_EQ(v, with(array("vx", "4", 1) + array("vy", "5", 1) + array("vz", "6", 1)).v);
  EXPECT_EQ((std::vector<double>{4, 5}), with(array("velocity", "4 5", 2), 2).v);
  const PointCloud two = with(array("U", "7 8 9", 3) + array("Velocity", "4 5 6", 3));
  EXPECT_EQ(v, two.v);
  EXPECT_EQ(std::vector<std::string>{"U"}, two.unused);
  const PointCloud scalar = with(array("v", "4", 1));  // a volume
  EXPECT_TRUE(scalar.v.empty());
  EXPECT_EQ(std::vector<std::string>{"v"}, scalar.unused);
  const PointCloud other = with(array("x", "7", 1) + array("vx", "7", 1) + array("v", "4 5 6", 3));
  EXPECT_EQ((std::vector<double>{1, 2, 3}), other.x);
  EXPECT_EQ(v, other.v);
  EXPECT_EQ((std::vector<std::string>{"x", "vx"}), other.unused);
}

TEST(VtkXml, NamesArraysOfCells) {
  const PointCloud cloud = read(file_of(
      points_of(ascii, "1 2 3") + "<CellData><DataArray Name=\"stress\">1</DataArray></CellData>"));
  EXPECT_EQ(std::vector<std::string>{"stress"}, cloud.unused);
}

TEST(VtkXml, ReadsAFrameOfARunExactly) {
  for (const int dimension : {2, 3}) {
    const Frame frame = sample_frame(dimension, 9);
    const PointCloud cloud = read(encode_vtp(frame), dimension);
    EXPECT_EQ(std::vector<double>(frame.x.begin(), frame.x.end()), cloud.x);
    EXPECT_EQ(std::vector<double>(frame.v.begin(), frame.v.end()), cloud.v);
    EXPECT_EQ((std::vector<std::string>{"density", "pressure", "id"}), cloud.unused);
  }
}

}  // namespace
}  // namespace freshet::test
