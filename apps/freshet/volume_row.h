// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "freshet/derived.h"
#include "freshet/units.h"

namespace freshet::cli {

/// The name of the k-th fluid's volume: "volume", or of several fluids "volume of fluid[k]".
inline std::string volume_name(const Derived& d, std::size_t k) {
  return d.fluids.size() == 1 ? "volume" : fmt::format("volume of fluid[{}]", k);
}

/// "0.9 m² filled of 0.909 m² (-0.99 %)"; the volume asked is missing for points.
inline std::string volume_row(const Scene& s, const DerivedFluid& f) {
  const std::string unit = raised_unit(units_in(s.dimension()).volume);
  const double percent = std::abs(f.error()) < 5e-5 ? 0 : 100 * f.error();  // no -0.00
  return fmt::format(
      "{:.4g} {} filled{}", f.filled, unit,
      f.asked ? fmt::format(" of {:.4g} {} ({:+.2f} %)", *f.asked, unit, percent) : "");
}

}  // namespace freshet::cli
