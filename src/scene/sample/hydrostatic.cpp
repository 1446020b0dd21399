// SPDX-License-Identifier: MIT
#include "scene/sample/hydrostatic.h"

#include <algorithm>
#include <cmath>

#include "scene/model/setup.h"
#include "scene/sample/places.h"

namespace freshet {
namespace {

double densest(const Scene& s) {
  double most = 0;
  for (const Scene::Liquid& liquid : s.liquids()) most = std::max(most, liquid.rest_density);
  return most;
}

double gravity_of(const Scene& s) {
  return s.dimension() == 2 ? norm(vec_of<2>(s.domain.gravity)) : norm(vec_of<3>(s.domain.gravity));
}

}  // namespace

HydrostaticColumn::HydrostaticColumn(const Scene& s, double rest_density, double height,
                                     double load)
    : rigid_(s.method().incompressible()),
      tait_(s.method().pressure != PressureFamily::linear),
      rest_density_(rest_density),
      gravity_(gravity_of(s)),
      height_(height),
      load_(load),
      load_depth_(load > 0 ? load / (rest_density * gravity_) : 0),
      per_depth_(rigid_ ? 0
                        : (tait_ ? 7 : 1) * gravity_ / stiffness(s) * (rest_density / densest(s))) {
}

double HydrostaticColumn::compression(double depth) const {
  return tait_ ? std::pow(q(depth), 1.0 / 7) : q(depth);
}

double HydrostaticColumn::height_above_bottom(double depth) const {
  if (rigid_) return height_ - depth;
  if (!tait_) return std::log(q(height_) / q(depth)) / per_depth_;
  return 7 / (6 * per_depth_) * (std::pow(q(height_), 6.0 / 7) - std::pow(q(depth), 6.0 / 7));
}

double compression_at(const Scene& s, double pressure) {
  if (s.method().incompressible()) return 1;
  const double share = pressure / (densest(s) * stiffness(s));
  if (s.method().pressure == PressureFamily::linear) return 1 + share;
  return 1 + 7 * share > 0 ? std::pow(1 + 7 * share, 1.0 / 7) : 0;
}

template <int D>
Hydrostatic<D>::Hydrostatic(const Scene& s)
    : s_(s), down_(unit_of<D>(s.domain.gravity)), gravity_(norm(vec_of<D>(s.domain.gravity))) {
  std::vector<Layer*> order;
  for (const Scene::Fluid& f : s.fluid) layers_.push_back(layer_of(f));
  for (auto& layer : layers_)
    if (layer) order.push_back(&*layer);
  std::sort(order.begin(), order.end(), [](auto* a, auto* b) { return a->top < b->top; });
  for (Layer* below : order)  // from the top: the layers above have their loads already
    for (const Layer* above : order)
      if (stands_on(*above, *below))
        below->load =
            std::max(below->load, above->load + above->rest_density * gravity_ * above->height());
  for (Layer* layer : order)
    layer->column.emplace(s, layer->rest_density, layer->height(), layer->load);
  std::reverse(order.begin(), order.end());
  for (Layer* above : order)
    for (const Layer* below : order)
      if (stands_on(*above, *below))
        above->sinks = std::max(
            above->sinks, below->sinks + below->height() - below->column->height_above_bottom(0));
}

template <int D>
std::optional<typename Hydrostatic<D>::Layer> Hydrostatic<D>::layer_of(
    const Scene::Fluid& f) const {
  if (f.pressure != StartPressure::hydrostatic) return {};
  Layer layer{.top = INFINITY, .bottom = -INFINITY, .rest_density = f.rest_density};
  if (!f.surface.empty()) layer.surface.emplace(f.surface, D, s_.particles.spacing);
  Places<D>(s_, f).each([&](Vec<D> place, std::size_t) {
    Vec<D, double> x = to_double(place);
    const double depth = dot(x, down_);
    const bool first = layer.top > layer.bottom;
    for (int d = 0; d < D; ++d) {
      double &low = component(layer.low, d), &high = component(layer.high, d);
      low = first ? component(x, d) : std::min(low, component(x, d));
      high = first ? component(x, d) : std::max(high, component(x, d));
    }
    layer.top = std::min(layer.top, depth);
    layer.bottom = std::max(layer.bottom, depth);
    return true;
  });
  layer.top -= s_.particles.spacing / 2;
  layer.bottom += s_.particles.spacing / 2;
  return layer;
}

template <int D> bool Hydrostatic<D>::stands_on(const Layer& b, const Layer& a) const {
  const double spacing = s_.particles.spacing;
  if (&a == &b || std::abs(b.bottom - a.top) > spacing / 2) return false;
  for (int d = 0; d < D; ++d) {
    Vec<D, double> low = b.low, high = a.high, low2 = a.low, high2 = b.high;
    if (component(low, d) > component(high, d) + 1.5 * spacing) return false;
    if (component(low2, d) > component(high2, d) + 1.5 * spacing) return false;
  }
  return true;
}

template <int D>
HydrostaticState Hydrostatic<D>::settle_below(const Layer& layer, Vec<D>& x) const {
  const Triple origin = origin_of(s_);
  Vec<D, double> at = to_double(x);
  for (int d = 0; d < D; ++d) component(at, d) += origin[std::size_t(d)];
  const double surface = layer.surface->height(at), bottom = origin[1] - layer.bottom;
  const HydrostaticColumn column(s_, layer.rest_density, std::max(0.0, surface - bottom), 0);
  const double depth = std::clamp(surface - at.y, 0.0, std::max(0.0, surface - bottom));
  x.y -= Real(surface - bottom - depth - column.height_above_bottom(depth));
  return {column.compression(depth), column.pressure(depth)};
}

template <int D> HydrostaticState Hydrostatic<D>::settle(std::size_t k, Vec<D>& x) const {
  if (!layers_[k]) return {};
  const Layer& layer = *layers_[k];
  if (layer.surface) return settle_below(layer, x);
  const HydrostaticColumn& column = *layer.column;
  const double depth = std::clamp(dot(to_double(x), down_) - layer.top, 0.0, layer.height());
  const double sinks = layer.height() - depth - column.height_above_bottom(depth) + layer.sinks;
  for (int d = 0; d < D; ++d) {
    auto step = sinks * down_;
    component(x, d) += Real(component(step, d));
  }
  return {column.compression(depth), column.pressure(depth)};
}

template class Hydrostatic<2>;
template class Hydrostatic<3>;

}  // namespace freshet
