// SPDX-License-Identifier: MIT
#include "scene/model/free_surface.h"

#include <cmath>

namespace freshet {

FreeSurface::FreeSurface(const std::string& function, int dimension, double spacing)
    : function_(std::make_shared<Expressions>(std::vector{function}, surface_variables(dimension))),
      dimension_(dimension),
      step_(spacing / 8) {}

double FreeSurface::height_at(double x, double z) const {
  if (function_->empty()) return -INFINITY;  // a build without muParser
  double y = 0;
  (*function_)({x, 0, z}, 0, &y);
  return std::isfinite(y) ? y : -INFINITY;
}

Vec<3, double> FreeSurface::upward(double x, double z) const {
  const auto slope = [&](double dx, double dz) {
    const double rise = height_at(x + dx, z + dz) - height_at(x - dx, z - dz);
    return std::isfinite(rise) ? rise / (2 * step_) : 0;
  };
  const Vec<3, double> up{-slope(step_, 0), 1, dimension_ == 3 ? -slope(0, step_) : 0};
  return 1 / norm(up) * up;
}

}  // namespace freshet
