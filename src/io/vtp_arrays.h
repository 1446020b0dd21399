// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace freshet {

/// The appended data of a VTK XML file: arrays, each after its size in bytes.
class VtpArrays {
 public:
  /// Appends an array and returns its DataArray element.
  template <class T>
  std::string array(const char* type, const char* name, int components,
                    const std::vector<T>& values) {
    const std::string element = fmt::format(
        "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
        "offset=\"{}\"/>\n",
        type, name, components, bytes.size());
    const std::uint64_t size = values.size() * sizeof(T);
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes.append(reinterpret_cast<const char*>(values.data()), size);
    return element;
  }
  std::string bytes;
};

/// The start of a VTK XML PolyData file of a time [s] and step, within its FieldData.
inline std::string vtp_start(double time, std::int64_t step) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n"
      "  <PolyData>\n"
      "    <FieldData>\n"
      "      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n"
      "      <DataArray type=\"Int64\" Name=\"Step\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n",
      time, step);
}

/// The file: `text` up to the end of its piece, and the arrays.
inline std::string vtp_file(std::string text, const VtpArrays& data) {
  text += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_";
  text.reserve(text.size() + data.bytes.size() + 40);
  return std::move(text) + data.bytes + "\n  </AppendedData>\n</VTKFile>\n";
}

}  // namespace freshet
