// SPDX-License-Identifier: MIT
#include "scene/sample/ball_layer.h"

#include <cmath>

#include "kernels/lattice_sum.h"
#include "kernels/scene_kernel.h"
#include "scene/model/setup.h"
#include "scene/sample/point_grid.h"
#include "scene/sample/surface.h"

namespace freshet {
namespace {

class BallLayer {
 public:
  using Point = Vec<3, double>;

  BallLayer(const Scene& s, const Solid<3, double>& ball)
      : ball_(ball),
        spacing_(s.particles.spacing),
        support_(support_radius(s)),
        flat_distance_(single_layer_distance(s)),
        kernel_(Real(support_), s.solver.kernel) {
    const std::vector<Point> around = half_a_spacing_outside();
    const std::size_t stride = around.size() / most_probes + 1;
    for (std::size_t k = 0; k < around.size(); k += stride) {
      probes_.push_back(around[k]);
      wanted_ += integral(around[k], ball_);
    }
    wanted_ *= density_of_flat_layer() / integral({spacing_ / 2, 0, 0}, half_space());
  }

  /// The layer at the depth where its density is the wanted one.
  std::vector<Point> best() const {
    double high = 0, low = std::min(flat_distance_, 0.9 * ball_.radius);
    for (int step = 0; step < 20; ++step) {
      const double middle = (high + low) / 2;
      (density(middle) > wanted_ ? high : low) = middle;
    }
    return layer(low);
  }

 private:
  static constexpr double cell = 0.1;  // spacings: of the midpoint rule
  static constexpr double fine = 0.5;  // spacings between body particles: an even surface
  static constexpr std::size_t most_probes = 60;

  static Solid<3, double> half_space() {
    Solid<3, double> solid;
    solid.kind = SolidKind::plane;
    solid.axis.x = 1;
    return solid;
  }
  double W(Point r) const {
    return norm2(r) < support_ * support_
               ? double(kernel_(Pair<3, Real>(Vec<3>{Real(r.x), Real(r.y), Real(r.z)})))
               : 0;
  }
  /// The density, over the rest density, that a flat layer has half a spacing outside.
  double density_of_flat_layer() const {
    return layer_sum<3>(kernel_, spacing_, support_, flat_distance_ / spacing_) /
           layer_sum<3>(kernel_, spacing_, support_, 0);
  }
  /// The integral of the kernel around x over the inside of a solid, by the midpoint rule.
  double integral(Point x, const Solid<3, double>& solid) const {
    const double d = cell * spacing_;
    const int m = int(support_ / d) + 1;
    double sum = 0;
    for (int c = -m; c < m; ++c)
      for (int b = -m; b < m; ++b)
        for (int a = -m; a < m; ++a) {
          const Point r{(a + 0.5) * d, (b + 0.5) * d, (c + 0.5) * d};
          if (solid.distance(x + r) < 0) sum += W(r);
        }
    return sum * d * d * d;
  }
  /// A layer at a depth.
  std::vector<Point> layer(double depth) const {
    std::vector<Point> x = Surface<3>(ball_, fine * spacing_, 1).points({}, {}, {});
    const double scale = (ball_.radius - depth) / (ball_.radius - fine * spacing_ / 2);
    for (Point& a : x) a = ball_.center + scale * (a - ball_.center);
    return x;
  }
  std::vector<Point> half_a_spacing_outside() const {
    Solid<3, double> larger = ball_;
    larger.radius += spacing_;
    return Surface<3>(larger, spacing_, 1).points({}, {}, {});
  }
  /// The density of a layer, over the rest density, summed over the probes.
  double density(double depth) const {
    const std::vector<Point> x = layer(depth);
    PointGrid<3> grid(support_);
    for (const Point& a : x) grid.add(a);
    std::vector<double> volume;
    for (const Point& a : x) {
      double sum = 0;
      for (const int j : grid.near(a)) sum += W(a - x[std::size_t(j)]);
      volume.push_back(1 / sum);
    }
    double all = 0;
    for (const Point& a : probes_)
      for (const int j : grid.near(a)) all += volume[std::size_t(j)] * W(a - x[std::size_t(j)]);
    return all;
  }

  Solid<3, double> ball_;
  double spacing_, support_, flat_distance_;
  SceneKernel<3> kernel_;
  std::vector<Point> probes_;  // half a spacing outside
  double wanted_ = 0;          // density summed over the probes
};

}  // namespace

bool has_ball_layer(const Scene& s, const Scene::Region& body) {
  const double radius = body.radius / s.particles.spacing;
  return s.dimension() == 3 && body.shape == Shape::sphere && body.side == Side::outside &&
         s.method().incompressible() && radius >= 1 && radius < 12;
}

std::vector<Vec<3, double>> ball_layer(const Scene& s, const Solid<3, double>& ball) {
  return BallLayer(s, ball).best();
}

}  // namespace freshet
