// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>

#include "backend/cpu/append.h"
#include "backend/cpu/cell_grid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// A grid to search, and the offset of its sorted indices in the lists.
template <int D> struct Source {
  const CpuCellGrid<D>* grid;
  int offset;
};

/// Consecutive targets that are close together in one row of cells. They share one search for
/// candidates.
template <int D> struct Group {
  int first, last;
  Vec<D> low, high;  // the bounding box
  Cell<D> cell;      // the first cell along x
  int cells;         // number of cells along x

  /// Takes targets from `first` on while they are close together. A group does not cross a seam of
  /// the torus, where a search around both ends would find particles twice. A target closer than
  /// 1e-3 of a cell to a border along y or z, or lost, is a group alone.
  FRESHET_HD Group(const CpuCellGrid<D>& targets, int first, int end) : first(first) {
    const Cells<D>& cells_of = targets.cells();
    low = high = targets.position(first);
    cell = cells_of(low);
    unsigned near = (1u << (end - first)) - 1;
    for (int d = 0; d < D; ++d) {
      const double from = d == 0 ? cell.c[0] : cell.c[d] + 1e-3;
      const double to = d == 0 ? from + most_cells : cell.c[d] + 1 - 1e-3;
      const Pack x = load(targets.component(d) + first);
      near &= bits(Pack(Real(cells_of.begin(from, d))) < x) &
              bits(x < Pack(Real(cells_of.begin(to, d))));
    }
    last = first + std::max(1, std::countr_one(near));
    for (int i = first + 1; i < last; ++i) {
      const Vec<D> x = targets.position(i);
      low = each(low, x, [](Real a, Real b) { return min(a, b); });
      high = each(high, x, [](Real a, Real b) { return max(a, b); });
    }
    cell.c[0] = Cells<D>::floor(cells_of.along(low.x, 0));
    cells = Cells<D>::floor(cells_of.along(high.x, 0)) - cell.c[0] + 1;
  }

 private:
  /// A small number means many searches, a large number many candidates that are near other targets
  /// only. With the cells around the group it must stay below 16, the shortest row that wraps.
  static constexpr int most_cells = 6;
};

/// The sources near a group: those closer than the support radius to its bounding box, contiguous
/// in memory.
template <int D> class Candidates {
 public:
  int count() const { return count_; }

  void find(const Group<D>& group, Real h2, std::span<const Source<D>> sources) {
    count_ = 0;
    for (const Source<D>& source : sources) search(group, h2, source);
    for (int k = 0; k < lanes; ++k) {  // far positions fill the last pack
      for (int d = 0; d < D; ++d) x_[d].get()[count_ + k] = Real(1e9f);
      index_.get()[count_ + k] = 0;
    }
  }

  /// Writes the candidates closer than h to target i to `to` and returns their number. It may write
  /// up to `lanes` ints more. All tests come before all writes: the address of a write depends on
  /// all tests before it, and processors delay reads after writes to unknown addresses.
  FRESHET_HD int near(const CpuCellGrid<D>& targets, int i, Real h2, int* to) {
    Pack x_i[D];
    const Real* x_j[D];
    for (int d = 0; d < D; ++d) {
      x_i[d] = Pack(targets.component(d)[i]);
      x_j[d] = x_[d].get();
    }
    const Pack limit(h2);
    std::uint16_t* mask = mask_.get();
    const int packs = (count_ + lanes - 1) / lanes;
    for (int t = 0; t < packs; ++t) {
      Pack r2;
      for (int d = 0; d < D; ++d) {
        const Pack dx = x_i[d] - load(x_j[d] + t * lanes);
        r2 = d == 0 ? dx * dx : r2 + dx * dx;
      }
      mask[t] = std::uint16_t(bits(r2 < limit));
    }
    const int* index = index_.get();
    int* out = to;
    for (int t = 0; t < packs; ++t) {
      const Compaction compact(mask[t]);
      compact(index + t * lanes, out);
      out += compact.count();
    }
    return int(out - to);
  }

 private:
  /// Searches the rows of cells around the group; in each the sources are one range. The limit is
  /// larger than h by 5e-5 h, more than the rounding errors, including those of near().
  void search(const Group<D>& group, Real h2, const Source<D>& source) {
    const CpuCellGrid<D>& grid = *source.grid;
    constexpr int around = D == 3 ? 9 : 3;
    constexpr int split = Cells<D>::split;
    const int first = grid.place_in_row(group.cell.c[0]) - split;
    const int last = first + 2 * split + group.cells;
    int begin[3 * around], end[3 * around], ranges = 0, longest = 0;
    for (int k = 0; k < around; ++k) {
      Cell<D> near = group.cell;
      for (int d = 1, part = k; d < D; ++d, part /= 3) near.c[d] += part % 3 - 1;
      const auto row = grid.row(near);
      const int* start = grid.starts() + row.first;
      const int turns = grid.rows_wrap() ? row.cells : 0;
      for (int turn = -turns; turn <= turns; turn += std::max(row.cells, 1)) {  // across the seam
        begin[ranges] = start[std::clamp(first - turn, 0, row.cells)];
        end[ranges] = start[std::clamp(last - turn, 0, row.cells)];
        longest = std::max(longest, end[ranges] - begin[ranges]);
        ranges += begin[ranges] < end[ranges];
      }
    }
    // Every range takes as many packs as the longest: loops of equal length are well predicted.
    const int packs_each = (longest + lanes - 1) / lanes;
    reserve(ranges * packs_each * lanes);
    Pack low[D], high[D];
    const Real* x_j[D];
    for (int d = 0; d < D; ++d) {
      Vec<D> a = group.low, b = group.high;
      low[d] = Pack(component(a, d)), high[d] = Pack(component(b, d));
      x_j[d] = grid.component(d);
    }
    const Pack limit(h2 * Real(1.0001f));
    std::uint16_t* mask = mask_.get();
    int* at = place_.get();
    int packs = 0;
    for (int r = 0; r < ranges; ++r) {
      for (int q = 0; q < packs_each; ++q) {
        const int j = std::min(begin[r] + q * lanes, end[r]);
        Pack r2;
        for (int d = 0; d < D; ++d) {
          const Pack x = load(x_j[d] + j);
          const Pack dx = max(max(low[d] - x, x - high[d]), Pack(Real(0)));
          r2 = d == 0 ? dx * dx : r2 + dx * dx;
        }
        const unsigned in_range = (1u << std::min(end[r] - j, lanes)) - 1;
        const unsigned near = bits(r2 < limit) & in_range;
        at[packs] = j;
        mask[packs] = std::uint16_t(near);
        packs += near != 0;  // keeps the pack only if a lane is near, without a branch
      }
    }
    Real* to[D];
    for (int d = 0; d < D; ++d) to[d] = x_[d].get();
    int* index = index_.get();
    int m = count_;
    for (int t = 0; t < packs; ++t) {
      const Compaction compact(mask[t]);
      for (int d = 0; d < D; ++d) compact(x_j[d] + at[t], to[d] + m);
      compact.count_up(source.offset + at[t], index + m);
      m += compact.count();
    }
    count_ = m;
  }

  /// Makes room for `more` candidates.
  void reserve(int more) {
    const auto room = std::size_t(count_ + more + 2 * lanes);
    if (index_.size() >= room) return;
    for (Buffer<Real>& x : x_) grow(x, room);
    mask_.reserve(x_[0].size());
    place_.reserve(x_[0].size());
    grow(index_, room);  // last: its size means that all have room
  }
  template <class T> void grow(Buffer<T>& buffer, std::size_t room) const {
    Buffer<T> larger;
    larger.reserve(room * 3 / 2);
    std::copy_n(buffer.get(), count_, larger.get());
    buffer = std::move(larger);
  }

  int count_ = 0;
  Buffer<Real> x_[D];
  Buffer<int> index_, place_;
  Buffer<std::uint16_t> mask_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
