// SPDX-License-Identifier: MIT
#include "io/vtp_points.h"

#include <fmt/format.h>

#include <limits>
#include <numeric>

namespace freshet {

VtpPoints::VtpPoints(std::size_t points, double time, std::int64_t step, int dimension)
    : points_(points), dimension_(dimension), text_(vtp_start(time, step)) {
  text_ += fmt::format(
      "      <DataArray type=\"Int64\" Name=\"Dimension\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n"
      "    </FieldData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
      "      <PointData>\n",
      dimension, points, points);
}

std::vector<float> VtpPoints::in_space(const std::vector<float>& values) const {
  if (dimension_ == 3) return values;
  std::vector<float> all;
  all.reserve(values.size() / 2 * 3);
  for (std::size_t i = 0; i < values.size(); i += 2)
    all.insert(all.end(), {values[i], values[i + 1], 0.0f});
  return all;
}

void VtpPoints::add(const char* name, const std::vector<float>& values) {
  text_ += arrays_.array("Float32", name, 1, values);
}
void VtpPoints::add(const char* name, const std::vector<std::int32_t>& values) {
  text_ += arrays_.array("Int32", name, 1, values);
}
void VtpPoints::add(const char* name, const std::vector<std::uint64_t>& values) {
  text_ += arrays_.array("UInt64", name, 1, values);
}
void VtpPoints::add_vectors(const char* name, const std::vector<float>& values) {
  text_ += arrays_.array("Float32", name, 3, in_space(values));
}

/// A vertex cell per point: other programs show nothing without cells.
template <class Index> std::string VtpPoints::verts(const char* type) {
  std::vector<Index> places(points_);
  std::iota(places.begin(), places.end(), Index(0));
  std::string text = "      <Verts>\n" + arrays_.array(type, "connectivity", 1, places);
  std::iota(places.begin(), places.end(), Index(1));
  return text + arrays_.array(type, "offsets", 1, places) + "      </Verts>\n";
}

std::string VtpPoints::bytes_at(const std::vector<float>& x) && {
  text_ += "      </PointData>\n      <Points>\n" +
           arrays_.array("Float32", "Points", 3, in_space(x)) + "      </Points>\n";
  text_ += points_ <= std::size_t(std::numeric_limits<std::int32_t>::max())
               ? verts<std::int32_t>("Int32")
               : verts<std::int64_t>("Int64");
  return vtp_file(std::move(text_), arrays_);
}

}  // namespace freshet
