// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "core/vec.h"
#include "freshet/scene.h"
#include "scene/model/free_surface.h"

namespace freshet {

/// A column of a liquid under its own weight and a load: the positions and densities of its layers
/// at rest. s is the depth of material above a layer, measured uncompressed; the load counts as
/// material. The pressure is p = rho0 g s, and the density is
///   mueller2003        rho/rho0 = 1 + g s/k
///   wcsph, delta_sph   rho/rho0 = (1 + 7 p/(rho_ref c²))^(1/7)   [Tait's equation]
///   pcisph, iisph, dfsph, pbf   rho = rho0
/// rho_ref is the rest density of the densest liquid. The height of a layer above the bottom is the
/// integral of rho0/rho ds over the material below it.
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

/// The density at a place, over the rest density, and the pressure [Pa].
struct HydrostaticState {
  double compression = 1, pressure = 0;
};

/// The density of a fluid at a pressure [Pa], over its rest density: 1 of the pressure solvers. Not
/// above 0 if the pressure is so far below 0 that no density has it.
double compression_at(const Scene& s, double pressure);

/// The fluids that start hydrostatic, each with the weight of the fluids above it.
template <int D> class Hydrostatic {
 public:
  explicit Hydrostatic(const Scene& s);

  /// Moves x, a place of the k-th fluid, to the position of its layer at rest. The bottom of the
  /// lowest fluid does not move. Below a free surface each column is at rest by itself.
  HydrostaticState settle(std::size_t k, Vec<D>& x) const;

 private:
  struct Layer {
    Vec<D, double> low{}, high{};  ///< the box around the fluid
    double top, bottom;            ///< depths [m]
    double rest_density;
    std::optional<FreeSurface> surface{};
    double load = 0;   ///< weight of the fluids above [Pa]
    double sinks = 0;  ///< displacement by the compression of the fluids below [m]
    std::optional<HydrostaticColumn> column{};
    double height() const { return bottom - top; }
  };
  HydrostaticState settle_below(const Layer& layer, Vec<D>& x) const;
  std::optional<Layer> layer_of(const Scene::Fluid& f) const;
  /// Whether the bottom of b touches the top of a.
  bool stands_on(const Layer& b, const Layer& a) const;

  const Scene& s_;
  Vec<D, double> down_;
  double gravity_;
  std::vector<std::optional<Layer>> layers_;  ///< by fluid; empty if it is not hydrostatic
};

}  // namespace freshet
