// SPDX-License-Identifier: MIT
#include "render/color_range.h"

#include <algorithm>
#include <cmath>

#include "freshet/units.h"

namespace freshet {
namespace {

constexpr std::size_t most_samples = 2048;
constexpr double low_rank = 0.01, high_rank = 0.99;
constexpr double dimmest_fall = 0.1;        // of the speed of a fall through the domain
constexpr float dimmest_in_picture = 0.1f;  // [m/s]

struct Quantity {
  const char* name;
  const char* Units::*unit;  // none for numbers without a unit
};
constexpr Quantity quantities[] = {{"speed", &Units::speed},
                                   {"velocity x", &Units::speed},
                                   {"velocity y", &Units::speed},
                                   {"velocity z", &Units::speed},
                                   {"density", &Units::density},
                                   {"density error", nullptr},
                                   {"pressure", &Units::pressure},
                                   {"height", &Units::length},
                                   {"id", nullptr},
                                   {"liquid", nullptr}};

float speed_of(const Frame& f, std::size_t i) {
  float sum = 0;
  for (std::size_t d = 0; d < std::size_t(f.dimension); ++d) {
    const float u = f.v[std::size_t(f.dimension) * i + d];
    sum += u * u;
  }
  return std::sqrt(sum);
}

/// The liquid of particle i; 0 for an index beyond `count`, because a file may hold any number.
std::size_t liquid_of(const Frame& f, std::size_t i, std::size_t count) {
  const std::size_t k = f.liquid.empty() ? 0 : std::size_t(f.liquid[i]);
  return k < count ? k : 0;
}

/// Mixes the bits of an id, as neighbours in a lattice have regular ids (SplitMix64).
std::uint64_t mixed(std::uint64_t id) {
  id += 0x9e3779b97f4a7c15u;
  id = (id ^ (id >> 30)) * 0xbf58476d1ce4e5b9u;
  id = (id ^ (id >> 27)) * 0x94d049bb133111ebu;
  return id ^ (id >> 31);
}

std::vector<std::size_t> sampled_particles(const Frame& frame) {
  const std::size_t stride = (frame.size() + most_samples - 1) / most_samples;
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (stride == 1 || mixed(frame.id[i]) % stride == 0) all.push_back(i);
  return all;
}

float value_at(std::vector<float>& values, double rank) {
  const auto at = values.begin() + std::ptrdiff_t(std::llround(rank * double(values.size() - 1)));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

bool is_signed(ColorBy q) {
  return q == ColorBy::velocity_x || q == ColorBy::velocity_y || q == ColorBy::velocity_z ||
         q == ColorBy::density_error;
}

/// A range that is not empty, from a range that may be.
ColorRange whole(ColorBy quantity, ColorRange r) {
  if (r.is_empty()) r.low = r.high = 0;
  if (quantity == ColorBy::speed) r.low = 0;
  if (is_signed(quantity)) {
    r.high = std::max(std::abs(r.low), std::abs(r.high));
    r.low = -r.high;
  }
  if (!(r.high > r.low)) r.high = r.low + std::max(1.0f, std::abs(r.low));
  return r;
}

/// The speed after a fall through the domain [m/s]; 0 without gravity.
double fall_speed(const Scene& s) {
  double g2 = 0;
  for (const double g : s.domain.gravity) g2 += g * g;
  const double height = s.domain.max[1] - (s.domain.min.empty() ? 0 : s.domain.min[1]);
  return std::sqrt(2 * std::sqrt(g2) * height);
}

}  // namespace

void ColorRange::include(const ColorRange& other) {
  low = std::min(low, other.low);
  high = std::max(high, other.high);
}

void include(ColorRanges& all, const ColorRanges& more) {
  for (std::size_t k = 0; k < all.size(); ++k) all[k].include(more[k]);
}

std::string quantity_name(ColorBy quantity) { return quantities[int(quantity)].name; }

std::string quantity_unit(ColorBy quantity, int dimension) {
  const Quantity& q = quantities[int(quantity)];
  return q.unit ? units_in(dimension).*q.unit : "";
}

std::vector<float> rest_densities(const Scene& scene) {
  std::vector<float> all;
  for (const Scene::Liquid& liquid : scene.liquids()) all.push_back(float(liquid.rest_density));
  return all;
}

float quantity_value(ColorBy quantity, const std::vector<float>& rest_density, const Frame& f,
                     std::size_t i) {
  const auto d = std::size_t(f.dimension);
  switch (quantity) {
    case ColorBy::speed:
      return speed_of(f, i);
    case ColorBy::velocity_x:
      return f.v[d * i];
    case ColorBy::velocity_y:
      return f.v[d * i + 1];
    case ColorBy::velocity_z:
      return f.v[d * i + d - 1];
    case ColorBy::density:
      return f.density[i];
    case ColorBy::density_error:
      return f.density[i] / rest_density[liquid_of(f, i, rest_density.size())] - 1;
    case ColorBy::pressure:
      return f.pressure[i];
    case ColorBy::height:
      return f.x[d * i + 1];
    case ColorBy::id:
      return float(f.id[i]);
    case ColorBy::liquid:
      return float(liquid_of(f, i, rest_density.size()));
  }
  return 0;
}

ColorRanges percentiles_of(const Scene& scene, const Frame& frame) {
  const std::vector<float> rest_density = rest_densities(scene);
  const std::vector<std::size_t> particles = sampled_particles(frame);
  ColorRanges all;
  std::vector<float> values;
  for (std::size_t k = 0; k < all.size(); ++k) {
    values.clear();
    for (const std::size_t i : particles)
      if (const float v = quantity_value(ColorBy(k), rest_density, frame, i); std::isfinite(v))
        values.push_back(v);
    if (!values.empty()) all[k] = {value_at(values, low_rank), value_at(values, high_rank)};
  }
  return all;
}

ColorRange color_limits(const Scene& scene, const ColorRange& values) {
  ColorRange r = values;
  if (scene.picture.color_by == ColorBy::speed)
    r.include({0, float(dimmest_fall * fall_speed(scene))});
  return whole(scene.picture.color_by, r);
}

ColorRange picture_limits(ColorBy quantity, const std::vector<float>& values) {
  ColorRange r;
  for (const float v : values)
    if (std::isfinite(v)) r.include({v, v});
  if (quantity == ColorBy::speed) r.include({0, dimmest_in_picture});
  return whole(quantity, r);
}

}  // namespace freshet
