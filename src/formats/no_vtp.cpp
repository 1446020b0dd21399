// SPDX-License-Identifier: MIT
// Replaces vtp.cpp in builds without pugixml or zlib.
#include "formats/point_sink.h"

namespace freshet {

bool reads_vtp() { return false; }

void read_vtp(std::string_view, PointSink& sink) {
  sink.fail(
      "this build reads no VTP files, as pugixml or zlib was missing; convert it to *.ply or "
      "*.csv");
}

}  // namespace freshet
