// SPDX-License-Identifier: MIT
#include "scene/check/volume_warnings.h"

#include <algorithm>
#include <cmath>

#include "freshet/units.h"
#include "scene/check/findings.h"
#include "scene/sample/places.h"

namespace freshet {
namespace {

// Of the volume. A lattice that fits its box has no error; that of a small round shape is off by up
// to 2 % anyway.
constexpr double unfit_error = 1e-3, block_error = 0.01, round_error = 0.02;
constexpr double whole = 0.03;  // [spacings]: a length that a whole number of them divides
constexpr double other_spacing_by = 0.25;  // farther from the spacing no remedy is looked for

/// A side of a box that its lattice does not divide.
struct UnfitSide {
  int axis;
  double length, spacings;
};

std::vector<UnfitSide> unfit_sides(const Scene& s, const Scene::Fluid& f) {
  std::vector<UnfitSide> sides;
  for (std::size_t k = 0; k < f.min.size(); ++k) {
    const double length = f.max[k] - f.min[k], spacings = length / s.particles.spacing;
    // a warning about the periodic domain covers a fluid that fills it
    const bool whole_period =
        s.periodic(int(k)) && length >= s.domain.max[k] - s.domain.min[k] - 1e-9 * length;
    if (std::abs(spacings - std::round(spacings)) > whole && !whole_period)
      sides.push_back({int(k), length, spacings});
  }
  return sides;
}

/// The spacing that divides all sides of a box and is nearest to the scene's spacing. Returns 0 if
/// no such spacing is close to it.
double dividing_spacing(const Scene& s, const Scene::Fluid& f) {
  const double spacing = s.particles.spacing, length = f.max[1] - f.min[1];
  const auto divides = [&](double other) {
    for (std::size_t k = 0; k < f.min.size(); ++k)
      if (const double n = (f.max[k] - f.min[k]) / other; std::abs(n - std::round(n)) > whole)
        return false;
    return true;
  };
  double best = 0;
  for (double n = std::ceil(length / spacing / (1 + other_spacing_by));
       n <= length / spacing / (1 - other_spacing_by) && n < 1e6; ++n)
    if (const double other = length / n;
        n > 0 && divides(other) && std::abs(other - spacing) < std::abs(best - spacing))
      best = other;
  return best;
}

std::string remedy_for(const Scene& s, const Scene::Fluid& f, const std::vector<UnfitSide>& sides) {
  const double spacing = s.particles.spacing;
  std::string words = "make it ";
  for (const UnfitSide& side : sides) {
    const double less = std::floor(side.spacings) * spacing;
    words += fmt::format("{}{:.6g} or {:.6g} m long in {}", &side == &sides[0] ? "" : " and ", less,
                         less + spacing, axis_names[side.axis]);
  }
  if (const double other = dividing_spacing(s, f); other > 0)
    words += fmt::format(", or set particles.spacing = {:.6g}", other);
  return words;
}

}  // namespace

std::vector<Diagnostic> volume_warnings(const Scene& s, const Derived& d) {
  std::vector<Diagnostic> list;
  const std::string unit = raised_unit(units_in(s.dimension()).volume);
  for (std::size_t k = 0; k < s.fluid.size(); ++k) {
    const Scene::Fluid& f = s.fluid[k];
    const double error = d.fluids[k].error();
    const bool box = f.shape == Shape::box && is_block(f);
    const auto sides = box ? unfit_sides(s, f) : std::vector<UnfitSide>();
    if (std::abs(error) <= (!sides.empty() ? unfit_error : is_block(f) ? block_error : round_error))
      continue;
    std::string why = "the lattice does not fit the shape",
                remedy = "make its sides whole numbers of spacings, or the spacing smaller";
    if (!sides.empty()) {
      why = "its box is ";
      for (const UnfitSide& side : sides)
        why += fmt::format("{}{:.4g} spacings long in {}", &side == &sides[0] ? "" : " and ",
                           side.spacings, axis_names[side.axis]);
      remedy = remedy_for(s, f, sides);
    }
    list.push_back(
        {Diagnostic::Severity::warning,
         place_of(s, sides.empty() ? "particles.spacing" : fmt::format("fluid[{}].max", k)),
         fmt::format("the particles of fluid[{}] fill {:.4g} {}, {:.2g} % {} than the {:.4g} {} of "
                     "its shape without walls and bodies: {}; {}",
                     k, d.fluids[k].filled, unit, 100 * std::abs(error),
                     error < 0 ? "less" : "more", *d.fluids[k].asked, unit, why, remedy)});
  }
  return list;
}

}  // namespace freshet
