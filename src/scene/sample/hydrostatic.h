// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "core/vec.h"
#include "freshet/scene.h"

namespace freshet {

/// A column of a liquid under its own weight and a load: where its layers come to rest, and how
/// dense. With the pressure p = rho0 g s below a depth s of material (so much of it if it were
/// uncompressed; the load counts as material):
///   mueller2003        rho/rho0 = 1 + g s/k
///   wcsph, delta_sph   rho/rho0 = (1 + 7 p/(rho_ref c²))^(1/7)   [Tait's equation]
///   pcisph, iisph, dfsph, pbf   rho = rho0
/// rho_ref is the rest density of the densest liquid. A layer stands above the bottom by the
/// integral of rho0/rho ds up to it.
class HydrostaticColumn {
 public:
  HydrostaticColumn(const Scene& s, double rest_density, double height, double load);

  double pressure(double depth) const { return load_ + rest_density_ * (gravity_ * depth); }
  double compression(double depth) const;
  double height_above_bottom(double depth) const;

 private:
  double q(double depth) const { return 1 + per_depth_ * (depth + load_depth_); }
  bool rigid_, tait_;
  double rest_density_, gravity_, height_, load_, load_depth_, per_depth_;
};

/// The fluids that start hydrostatic, each with the weight of those that stand on it.
template <int D> class Hydrostatic {
 public:
  explicit Hydrostatic(const Scene& s);

  /// How dense the fluid is at a place, over its rest density, and its pressure [Pa].
  struct State {
    double compression = 1, pressure = 0;
  };
  /// Moves x, of the k-th fluid, to where its layer comes to rest; the bottom of the lowest fluid
  /// stays where it is.
  State settle(std::size_t k, Vec<D>& x) const;

 private:
  struct Layer {
    Vec<D, double> low{}, high{};  ///< the box around it
    double top, bottom;            ///< depths [m]
    double rest_density;
    double load = 0;   ///< what stands on it [Pa]
    double sinks = 0;  ///< how far, as those below it are compressed [m]
    std::optional<HydrostaticColumn> column{};
    double height() const { return bottom - top; }
  };
  std::optional<Layer> layer_of(const Scene::Fluid& f) const;
  /// Whether b stands on a.
  bool stands_on(const Layer& b, const Layer& a) const;

  const Scene& s_;
  Vec<D, double> down_;
  double gravity_;
  std::vector<std::optional<Layer>> layers_;  ///< by fluid; none of what is not hydrostatic
};

}  // namespace freshet
