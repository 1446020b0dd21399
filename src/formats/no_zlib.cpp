// SPDX-License-Identifier: MIT
// Replaces vtk_xml.cpp and gzip_bytes.cpp in builds without pugixml or zlib.
#include "formats/gzip_bytes.h"
#include "formats/point_formats.h"

namespace freshet {

void read_vtk_xml(std::string_view, PointSink& sink) {
  sink.fail(
      "this build reads no VTK XML, as pugixml or zlib was missing; convert the file to *.vtk, "
      "*.ply or *.csv");
}

struct InputBytes::Gzip {};

InputBytes::InputBytes(std::string_view bytes, const FilePlace& place)
    : bytes_(bytes), place_(place) {
  if (is_gzip(bytes))
    place.fail(
        "this build reads no compressed files, as pugixml or zlib was missing; unpack it with "
        "gunzip");
}
InputBytes::~InputBytes() = default;

std::string_view InputBytes::inflate(std::size_t) { return {}; }

}  // namespace freshet
