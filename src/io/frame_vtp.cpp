// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <limits>
#include <numeric>

#include "io/frame_data.h"
#include "io/vtp_arrays.h"

namespace freshet {
namespace {

/// Three numbers per particle; z is 0 in 2D.
std::vector<float> in_space(const std::vector<float>& values, int dimension) {
  if (dimension == 3) return values;
  std::vector<float> all;
  all.reserve(values.size() / 2 * 3);
  for (std::size_t i = 0; i < values.size(); i += 2)
    all.insert(all.end(), {values[i], values[i + 1], 0.0f});
  return all;
}

std::string point_data(const Frame& frame, const DataFields& fields, VtpArrays& data) {
  std::string text = "      <PointData>\n";
  if (fields.velocity)
    text += data.array("Float32", "velocity", 3, in_space(frame.v, frame.dimension));
  if (fields.density) text += data.array("Float32", "density", 1, frame.density);
  if (fields.pressure) text += data.array("Float32", "pressure", 1, frame.pressure);
  if (fields.id) text += data.array("UInt64", "id", 1, frame.id);
  if (!frame.liquid.empty()) text += data.array("Int32", "liquid", 1, frame.liquid);
  return text + "      </PointData>\n";
}

/// A vertex cell per particle: other programs show nothing without cells.
template <class Index> std::string verts(std::size_t n, const char* type, VtpArrays& data) {
  std::vector<Index> places(n);
  std::iota(places.begin(), places.end(), Index(0));
  std::string text = "      <Verts>\n" + data.array(type, "connectivity", 1, places);
  std::iota(places.begin(), places.end(), Index(1));
  return text + data.array(type, "offsets", 1, places) + "      </Verts>\n";
}

}  // namespace

std::string encode_vtp(const Frame& frame, const DataFields& fields) {
  const std::size_t n = frame.size();
  VtpArrays data;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "  <PolyData>\n"
      "    <FieldData>\n"
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n"
      "      <DataArray type=\"Int64\" Name=\"Step\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n"
      "      <DataArray type=\"Int64\" Name=\"Dimension\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n"
      "    </FieldData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
      frame.time, frame.step, frame.dimension, n, n);
  text += point_data(frame, fields, data);
  text += "      <Points>\n" +
          data.array("Float32", "Points", 3, in_space(frame.x, frame.dimension)) +
          "      </Points>\n";
  text += n <= std::size_t(std::numeric_limits<std::int32_t>::max())
              ? verts<std::int32_t>(n, "Int32", data)
              : verts<std::int64_t>(n, "Int64", data);
  text += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_";
  text.reserve(text.size() + data.bytes.size() + 40);
  return text + data.bytes + "\n  </AppendedData>\n</VTKFile>\n";
}

}  // namespace freshet
