// SPDX-License-Identifier: MIT
#include "surface/liquid_part.h"

namespace freshet {

Frame liquid_part(const Frame& frame, int liquid) {
  if (frame.liquid.empty() && liquid == 0) return frame;
  Frame part;
  part.dimension = frame.dimension;
  const auto d = std::size_t(frame.dimension);
  for (std::size_t i = 0; i < frame.liquid.size(); ++i) {
    if (frame.liquid[i] != liquid) continue;
    part.id.push_back(frame.id[i]);
    part.x.insert(part.x.end(), &frame.x[d * i], &frame.x[d * i] + d);
    part.v.insert(part.v.end(), &frame.v[d * i], &frame.v[d * i] + d);
  }
  return part;
}

}  // namespace freshet
