// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "scene/setup.h"

namespace freshet {

std::vector<Override> at_resolution(const Scene& s, double particles) {
  double now = 0;
  for (const auto& f : s.fluid) now += lattice_of(f, s.particles.spacing).particles();
  const double factor = std::sqrt(now / particles), spacing = s.particles.spacing * factor;
  const auto number = [](double value) { return fmt::format("{}", value); };
  std::vector<Override> all{{"particles.spacing", number(spacing)},
                            {"particles.jitter", number(s.particles.jitter * factor)},
                            {"time.step", number(s.time.step * factor)}};
  if (const auto h = s.particles.support_radius)
    all.emplace_back("particles.support_radius", number(*h * factor));
  if (const auto m = s.particles.mass)
    all.emplace_back("particles.mass", number(*m * factor * factor));
  for (std::size_t k = 0; k < s.fluid.size(); ++k) {
    const auto& f = s.fluid[k];
    if (f.shape != Shape::lattice) continue;
    const std::string at = s.fluid.size() == 1 ? "fluid." : fmt::format("fluid[{}].", k);
    const double inset = (spacing - s.particles.spacing) / 2;
    all.emplace_back(at + "from", fmt::format("[{}, {}]", f.from[0] + inset, f.from[1] + inset));
    all.emplace_back(at + "count", fmt::format("[{}, {}]", std::round(double(f.count[0]) / factor),
                                               std::round(double(f.count[1]) / factor)));
  }
  return all;
}

}  // namespace freshet
