// SPDX-License-Identifier: MIT
#include "scene/sample/relax.h"

#include <algorithm>
#include <cmath>

#include "scene/sample/point_grid.h"

namespace freshet {
namespace {

template <int D> class Relaxation {
 public:
  using Point = Vec<D, double>;

  Relaxation(std::vector<Point>& places, const std::vector<Face<D>>& faces, double spacing,
             const std::function<bool(Point)>& allowed)
      : x_(places), faces_(faces), spacing_(spacing), allowed_(allowed) {}

  /// Returns the density of the densest place that moves, over that of a lattice.
  double run(const std::vector<Face<D>>& walls) {
    choose(walls);
    for (int k = 0; k < iterations; ++k) {
      if (k % per_list == 0) list_neighbors();
      mirror();
      step();
    }
    list_neighbors();
    mirror();
    double densest = 0;
    for (std::size_t k = 0; k < moving_; ++k) densest = std::max(densest, density(k));
    return densest;
  }

 private:
  // All lengths are in spacings.
  static constexpr double reach = 2;      // of the repulsion
  static constexpr double skin = 0.5;     // by which the lists of neighbours reach farther
  static constexpr double depth = 3;      // of the places that move
  static constexpr double stride = 0.2;   // maximum step
  static constexpr double closest = 0.3;  // to a face
  static constexpr int iterations = 40, per_list = 8;

  /// The places that move come first in near_; the places that they see follow.
  void choose(const std::vector<Face<D>>& walls) {
    std::vector<int> seen;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      double least = INFINITY;
      for (const auto& wall : walls) least = std::min(least, wall.distance(x_[i]));
      if (least < depth * spacing_) near_.push_back(int(i));
      else if (least < (depth + reach + skin) * spacing_) seen.push_back(int(i));
    }
    moving_ = near_.size();
    near_.insert(near_.end(), seen.begin(), seen.end());
  }
  Point& at(std::size_t k) { return x_[std::size_t(near_[k])]; }

  void list_neighbors() {
    PointGrid<D> grid((reach + skin) * spacing_);
    for (std::size_t k = 0; k < near_.size(); ++k) grid.add(at(k));
    neighbors_.assign(moving_, {});
    for (std::size_t k = 0; k < moving_; ++k) neighbors_[k] = grid.near(at(k));
  }
  /// The images of each place behind the faces near it, and behind corners of them. Of faces that
  /// almost coincide, the nearest has an image.
  void mirror() {
    images_.assign(near_.size(), {});
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const Point x = at(k);
      std::vector<std::pair<double, Point>> behind;  // distances, and vectors to images
      for (const auto& face : faces_)
        if (const double d = face.distance(x); d < reach * spacing_)
          behind.emplace_back(d, face.normal(x));
      std::stable_sort(behind.begin(), behind.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      std::vector<Point> normals, to;
      for (const auto& [d, n] : behind) {
        const Point normal = n;
        if (normals.size() == D || std::any_of(normals.begin(), normals.end(), [&](Point other) {
              return dot(normal, other) > 0.7;
            }))
          continue;
        normals.push_back(n);
        to.push_back(-2 * d * n);
      }
      for (unsigned corner = 1; corner < 1u << to.size(); ++corner) {
        Point image = x;
        for (std::size_t f = 0; f < to.size(); ++f)
          if (corner >> f & 1) image += to[f];
        images_[k].push_back(image);
      }
    }
  }
  Point repulsion(Point from) const {
    const double r = norm(from), q = r / (reach * spacing_);
    if (q >= 1 || r < 1e-6 * spacing_) return {};
    return q * (1 - q) * (1 - q) * (1 - q) * spacing_ / r * from;
  }
  /// The density by a cubic spline with a support of two spacings, over that of a lattice.
  double density(std::size_t k) {
    const auto weight = [](double r) {
      const double far = std::max(2 - r, 0.0), near = std::max(1 - r, 0.0);
      return far * far * far - 4 * near * near * near;
    };
    double sum = 0, lattice = 0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = D == 3 ? -1 : 0; z <= (D == 3 ? 1 : 0); ++z)
          lattice += weight(std::sqrt(double(x * x + y * y + z * z)));
    const auto add = [&](Point other) { sum += weight(norm(at(k) - other) / spacing_); };
    for (const int j : neighbors_[k]) {
      add(at(std::size_t(j)));
      for (const Point& image : images_[std::size_t(j)]) add(image);
    }
    return sum / lattice;
  }
  void step() {
    std::vector<Point> moves(moving_);
    for (std::size_t k = 0; k < moving_; ++k) {
      const Point x = at(k);
      Point move{};
      for (const int j : neighbors_[k]) {
        if (std::size_t(j) != k) move += repulsion(x - at(std::size_t(j)));
        for (const Point& image : images_[std::size_t(j)]) move += repulsion(x - image);
      }
      const double length = norm(move);
      moves[k] = std::min(1.0, stride * spacing_ / std::max(length, 1e-300)) * move;
    }
    for (std::size_t k = 0; k < moving_; ++k) {
      Point x = at(k) + moves[k];
      for (const auto& face : faces_)
        if (const double d = face.distance(x); d < closest * spacing_)
          x += (closest * spacing_ - d) * face.normal(x);
      if (allowed_(x)) at(k) = x;
    }
  }

  std::vector<Point>& x_;
  const std::vector<Face<D>>& faces_;
  double spacing_;
  const std::function<bool(Point)>& allowed_;
  std::vector<int> near_;
  std::size_t moving_ = 0;
  std::vector<std::vector<int>> neighbors_;
  std::vector<std::vector<Point>> images_;
};

}  // namespace

template <int D>
double relax(std::vector<Vec<D, double>>& places, const std::vector<Face<D>>& faces,
             const std::vector<Face<D>>& walls, double spacing,
             const std::function<bool(Vec<D, double>)>& allowed) {
  return Relaxation<D>(places, faces, spacing, allowed).run(walls);
}

template double relax<2>(std::vector<Vec<2, double>>&, const std::vector<Face<2>>&,
                         const std::vector<Face<2>>&, double,
                         const std::function<bool(Vec<2, double>)>&);
template double relax<3>(std::vector<Vec<3, double>>&, const std::vector<Face<3>>&,
                         const std::vector<Face<3>>&, double,
                         const std::function<bool(Vec<3, double>)>&);

}  // namespace freshet
