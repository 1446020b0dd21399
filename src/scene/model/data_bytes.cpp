// SPDX-License-Identifier: MIT
#include "scene/model/data_bytes.h"

#include <algorithm>

namespace freshet {
namespace {

/// Bytes per particle in a format, and of the rest of the file.
struct Cost {
  double particle, file;
};

Cost cost_of(DataFormat format, const Scene& s, double particles) {
  const auto& fields = s.output.fields;
  const auto if_has = [&](DataField field, double bytes) {
    return std::find(fields.begin(), fields.end(), field) == fields.end() ? 0 : bytes;
  };
  const auto sum = [&](double position, double velocity, double density, double pressure,
                       double id) {
    return position + if_has(DataField::velocity, velocity) + if_has(DataField::density, density) +
           if_has(DataField::pressure, pressure) + if_has(DataField::id, id);
  };
  const double d = s.dimension(), real = s.output.precision == Precision::float16 ? 2 : 4;
  switch (format) {
    case DataFormat::vtp:  // plus a cell of 8 bytes, which makes the point visible
      return {sum(12, 12, 4, 4, 8) + 8, 1700};
    case DataFormat::ply:
      return {sum(12, 12, 4, 4, particles > 4294967296.0 ? 8 : 4), 350};
    case DataFormat::csv:  // step and time, then numbers with their commas
      return {sum(11 + 10 * d, 13 * d, 9, 10, 6), 60};
    case DataFormat::bgeo:  // positions with a weight, and pscale
      return {sum(16, 12, 4, 4, 4) + 4, 160};
    case DataFormat::hdf5:
      return {sum(4 * d, real * d, real, real, 8), fields.size() < 2 ? 2048.0 : 4096.0};
  }
  return {};
}

}  // namespace

double data_bytes(const Scene& scene, double particles) {
  const bool liquids = scene.liquids().size() > 1;
  double all = 0;
  for (const DataFormat format : scene.output.data) {
    const Cost cost = cost_of(format, scene, particles);
    const double liquid = !liquids                     ? 0
                          : format == DataFormat::csv  ? 2
                          : format == DataFormat::hdf5 ? 8
                                                       : 4;
    all += (cost.particle + liquid) * particles + cost.file;
  }
  return all;
}

}  // namespace freshet
