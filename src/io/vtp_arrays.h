// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>
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

}  // namespace freshet
