// SPDX-License-Identifier: MIT
#include "scene/model/density_ratio.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace freshet {
namespace {

struct Densities {
  double least, most;
};
Densities densities(const Scene& s) {
  Densities d{std::numeric_limits<double>::infinity(), 0};
  for (const Scene::Liquid& liquid : s.liquids()) {
    d.least = std::min(d.least, liquid.rest_density);
    d.most = std::max(d.most, liquid.rest_density);
  }
  return d;
}

}  // namespace

double density_ratio(const Scene& s) {
  const Densities d = densities(s);
  return d.most / d.least;
}

DensityRatioLimits density_ratio_limits(const Scene& s) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!s.method().incompressible()) return {infinity, infinity};
  return {30, 300};
}

std::string key_of_lightest(const Scene& s) {
  const double least = densities(s).least;
  for (std::size_t k = 0; k < s.fluid.size(); ++k)
    if (s.fluid[k].rest_density == least) return fmt::format("fluid[{}].rest_density", k);
  for (std::size_t k = 0; k < s.inlet.size(); ++k)
    if (s.inlet_liquid(k).rest_density == least) return fmt::format("inlet[{}].rest_density", k);
  return "fluid";
}

std::string about_density_ratio(const Scene& s) {
  const double good = density_ratio_limits(s).good;
  return fmt::format(
      "a liquid is {:.4g} times as dense as another, and the pressure of {} holds ratios up to "
      "about {:g}; leave out the light liquid (a free surface needs no air), make its rest_density "
      "at least {:.3g}, or set solver.name = \"wcsph\", whose steps become shorter",
      density_ratio(s), s.method().name, good, densities(s).most / good);
}

}  // namespace freshet
