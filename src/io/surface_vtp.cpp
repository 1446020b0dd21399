// SPDX-License-Identifier: MIT
#include "io/surface_vtp.h"

#include "io/vtp_points.h"

namespace freshet {

std::string encode_surface(const SurfacePoints& surface, double time, std::int64_t step) {
  VtpPoints file(surface.size(), time, step, surface.dimension);
  file.add("pressure", surface.pressure);
  file.add_vectors("traction", surface.traction);
  file.add_vectors("normal", surface.normal);
  file.add("area", std::vector<float>(surface.size(), float(surface.area)));
  file.add("part", surface.part);
  return std::move(file).bytes_at(surface.x);
}

}  // namespace freshet
