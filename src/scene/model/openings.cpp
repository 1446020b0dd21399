// SPDX-License-Identifier: MIT
#include "scene/model/openings.h"

#include <algorithm>
#include <cmath>

#include "scene/model/setup.h"

namespace freshet {
namespace {

/// The k-th of `count` places, `spacing` apart and symmetric about 0.
double place_of(int k, int count, double spacing) { return (k - (count - 1) / 2.0) * spacing; }

int places_along(double length, double spacing) {
  return int(std::clamp(std::round(length / spacing), 1.0, 1e5));
}

/// The places in a disc, as pairs (along the width, along the height). Of two lattices, one with a
/// place at the centre and one without, it takes the one whose area is closer to that of the disc.
std::vector<Vec<2, double>> in_disc(double radius, double spacing) {
  std::vector<Vec<2, double>> best;
  const double area = 3.14159265358979323846 * radius * radius / (spacing * spacing);
  for (const int odd : {0, 1}) {
    const int n = 2 * (int(std::min(radius / spacing, 1e4)) + 1) + odd;
    std::vector<Vec<2, double>> all;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const Vec<2, double> at{place_of(i, n, spacing), place_of(j, n, spacing)};
        if (norm2(at) <= radius * radius * (1 + 1e-9)) all.push_back(at);
      }
    if (best.empty() || std::abs(double(all.size()) - area) < std::abs(double(best.size()) - area))
      best = std::move(all);
  }
  return best;
}

template <int D> std::vector<double> places_in(const Scene::Opening& o, double spacing) {
  const Opening<D> piece = opening_of<D>(o);
  std::vector<Vec<2, double>> flat;
  if (o.radius) {
    flat = in_disc(*o.radius, spacing);
  } else {
    const int n = places_along(*o.width, spacing);
    const int rows = D == 3 ? places_along(*o.height, spacing) : 1;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < n; ++i)
        flat.push_back({place_of(i, n, spacing), D == 3 ? place_of(j, rows, spacing) : 0});
  }
  std::vector<double> all;
  for (const auto& at : flat) {
    auto x = piece.center + at.x * piece.across + at.y * piece.up;
    for (int k = 0; k < D; ++k) all.push_back(component(x, k));
  }
  return all;
}

}  // namespace

InflowEstimate estimate_inflow(const Scene& s) {
  InflowEstimate all;
  for (const Scene::Inlet& in : s.inlet) {
    const InletPlan plan = inlet_plan(s, in);
    const double layers = plan.layers_until(s.time.end);
    const double zone = std::min(double(plan.layers), plan.layers_until(plan.stop));
    const double each = double(plan.particles());
    if (plan.start == 0) all.at_start += zone * each;
    if (plan.start < s.time.end)
      all.later += (plan.start == 0 ? 0 : zone * each) + (plan.outlet < 0 ? layers * each : 0);
  }
  return all;
}

double room_in_domain(const Scene& s) {
  double room = 1.1;
  for (std::size_t k = 0; k < s.domain.max.size(); ++k)
    room *= (s.domain.max[k] - s.domain.min[k]) / s.particles.spacing;
  return room;
}

InletPlan inlet_plan(const Scene& s, const Scene::Inlet& in) {
  InletPlan plan;
  const bool flat = s.dimension() == 2;
  plan.spacing = s.particles.spacing;
  plan.places = flat ? places_in<2>(in, plan.spacing) : places_in<3>(in, plan.spacing);
  plan.dimension = s.dimension();
  if (flat) {
    const auto d = unit_of<2>(in.direction);
    plan.direction = {d.x, d.y, 0};
  } else {
    const auto d = unit_of<3>(in.direction);
    plan.direction = {d.x, d.y, d.z};
  }
  // Particles just in front of the opening have neighbours in their whole support.
  plan.layers = int(std::min(std::ceil(support_radius(s) / plan.spacing - 1e-9), 1e6)) + 1;
  const double area = double(plan.particles()) * std::pow(plan.spacing, s.dimension() - 1);
  plan.speed = in.speed ? *in.speed : in.flow_rate.value_or(0) / area;
  plan.rate = plan.speed * area;
  const auto liquids = s.liquids();
  const Scene::Liquid liquid = s.inlet_liquid(std::size_t(&in - s.inlet.data()));
  plan.liquid = int(std::find(liquids.begin(), liquids.end(), liquid) - liquids.begin());
  plan.start = in.start;
  plan.stop = in.stop.value_or(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < s.outlet.size(); ++k)
    if (!in.recycle.empty() && s.flow_names()[s.inlet.size() + k] == in.recycle)
      plan.outlet = int(k);
  return plan;
}

}  // namespace freshet
