// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "freshet/derived.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

std::string number(double value) { return fmt::format("{}", value); }

/// A lattice that fills the same box; the first particle is half of the new spacing inside.
void refine(const Scene::Fluid& f, const std::string& at, double spacing, double factor,
            std::vector<Override>& all) {
  const double inset = (factor - 1) * spacing / 2;
  Vector from = f.from, count;
  for (double& x : from) x += inset;
  for (const auto n : f.count) count.push_back(std::round(double(n) / factor));
  all.emplace_back(at + "from", fmt::format("[{}]", fmt::join(from, ", ")));
  all.emplace_back(at + "count", fmt::format("[{}]", fmt::join(count, ", ")));
}

}  // namespace

std::vector<Override> at_resolution(const Scene& s, double particles) {
  const Derived d = derive(s);
  const double ratio = (s.inlet.empty() ? d.particles : d.most_particles) / particles;
  const double factor = s.dimension() == 3 ? std::cbrt(ratio) : std::sqrt(ratio);
  std::vector<Override> all{{"particles.spacing", number(s.particles.spacing * factor)},
                            {"particles.jitter", number(s.particles.jitter * factor)}};
  if (!s.time.adaptive) all.emplace_back("time.step", number(s.time.step * factor));
  else if (s.time.step_max) all.emplace_back("time.step_max", number(*s.time.step_max * factor));
  if (const auto h = s.particles.support_radius)
    all.emplace_back("particles.support_radius", number(*h * factor));
  if (const auto m = s.particles.mass) all.emplace_back("particles.mass", number(*m * ratio));
  for (std::size_t k = 0; k < s.fluid.size(); ++k) {
    const std::string at = s.fluid.size() == 1 ? "fluid." : fmt::format("fluid[{}].", k);
    if (s.fluid[k].shape == Shape::lattice)
      refine(s.fluid[k], at, s.particles.spacing, factor, all);
    if (s.fluid[k].shape == Shape::points)
      throw Error(Error::Kind::scene, "",
                  fmt::format("fluid[{}] is read from a file of points, whose "
                              "spacing is fixed; keep the number of "
                              "particles",
                              k));
  }
  return all;
}

}  // namespace freshet
