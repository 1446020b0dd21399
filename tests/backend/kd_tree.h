// SPDX-License-Identifier: MIT
/// The KD-tree of nanoflann, since the article searches with a KD-tree. Tests and benchmarks
/// compare the grids with it. It is not part of the library.
#pragma once
#include <nanoflann.hpp>
#include <vector>

#include "core/field.h"

namespace freshet {

template <int D> class KdTree {
 public:
  /// Builds the tree; the positions must outlive it.
  explicit KdTree(const Particles<D>& p, int leaf = 10)
      : points_{p}, tree_(D, points_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf)) {}

  /// Appends all j with |x - x_j|^2 < h2, in the tree's order.
  void find(const Vec<D>& x, Real h2, std::vector<int>& out) const {
    Found found{h2, out};
    tree_.radiusSearchCustomCallback(&x.x, found, nanoflann::SearchParams(0, 0, false));
  }

 private:
  struct Points {
    Particles<D> p;
    std::size_t kdtree_get_point_count() const { return std::size_t(p.n); }
    Real kdtree_get_pt(std::size_t j, std::size_t d) const { return (&p.x[int(j)].x)[d]; }
    template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
  };
  struct Found {  // nanoflann's own result set stores distances, which nobody needs here
    Real h2;
    std::vector<int>& out;
    Real worstDist() const { return h2; }
    bool full() const { return true; }
    std::size_t size() const { return out.size(); }
    bool addPoint(Real r2, std::size_t j) {
      if (r2 < h2) out.push_back(int(j));
      return true;
    }
  };

  Points points_;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<Real, Points>, Points, D> tree_;
};

}  // namespace freshet
