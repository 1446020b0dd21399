// SPDX-License-Identifier: MIT
#include "run/checks.h"

#include <string>
#include <utility>

namespace freshet {
namespace {

CheckResult compare(std::string name, double value, std::string relation, double bound) {
  const bool passed = relation == ">"   ? value > bound
                      : relation == "<" ? value < bound
                                        : value <= bound;
  return {std::move(name), std::move(relation), value, bound, passed};
}

}  // namespace

std::vector<CheckResult> evaluate(const Scene::Checks& c, const Report& r) {
  std::vector<CheckResult> all;
  const Statistics& s = r.statistics;
  if (c.out_of_bounds_max)
    all.push_back(
        compare("out of bounds", double(s.out_of_bounds), "<=", double(*c.out_of_bounds_max)));
  if (c.density_mean_min)
    all.push_back(compare("density mean", s.density_mean, ">", *c.density_mean_min));
  if (c.speed_mean_max) all.push_back(compare("speed mean", s.speed_mean, "<", *c.speed_mean_max));
  if (c.bright_fraction_min)
    all.push_back(
        compare("bright fraction", r.picture.bright_fraction(), ">", *c.bright_fraction_min));
  if (c.height_mean_max)
    all.push_back(compare("height mean", s.height_mean, "<", *c.height_mean_max));
  return all;
}

}  // namespace freshet
