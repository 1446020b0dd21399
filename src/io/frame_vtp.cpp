// SPDX-License-Identifier: MIT
#include "io/frame_data.h"
#include "io/vtp_points.h"

namespace freshet {

std::string encode_vtp(const Frame& frame, const DataFields& fields) {
  VtpPoints file(frame.size(), frame.time, frame.step, frame.dimension);
  if (fields.velocity) file.add_vectors("velocity", frame.v);
  if (fields.density) file.add("density", frame.density);
  if (fields.pressure) file.add("pressure", frame.pressure);
  if (fields.id) file.add("id", frame.id);
  if (!frame.liquid.empty()) file.add("liquid", frame.liquid);
  return std::move(file).bytes_at(frame.x);
}

}  // namespace freshet
