// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <vector>

#include "backend/cpu/append.h"
#include "backend/cpu/cell_grid.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Sliced lists: slice s holds the `lanes` consecutive targets from s * lanes on; entry k of lane l
/// is index[k * lanes + l]. Short lanes are padded with the far particle, number `sources`.
template <int D> class SlicedLists {
 public:
  static constexpr int slices_per_chunk = 1024 / lanes;

  struct Slice {
    const int* index;
    int length;  // entries a lane
  };
  Slice operator[](int s) const {
    const int chunk = s / slices_per_chunk;
    return {index_[std::size_t(chunk)].get() + begin_.get()[s], length_.get()[s]};
  }
  static int slices(int n) { return (n + lanes - 1) / lanes; }
  static int chunks(int n) { return (slices(n) + slices_per_chunk - 1) / slices_per_chunk; }

  /// For every target the sources nearer than h, cell by cell, ascending in a cell.
  void build(const Threads& threads, Real h, const CpuCellGrid<D>& targets,
             const CpuCellGrid<D>& sources) {
    const int n = targets.n();
    begin_.reserve(std::size_t(slices(n)));
    length_.reserve(std::size_t(slices(n)));
    if (index_.size() < std::size_t(chunks(n))) index_.resize(std::size_t(chunks(n)));
    workers_.resize(std::size_t(threads.count()));
    threads.parts(chunks(n), [&](int chunk) {
      build_chunk(chunk, h * h, targets, sources, workers_[std::size_t(omp_get_thread_num())]);
    });
  }

 private:
  /// What a thread needs to build a chunk; it grows to what the densest cell asks for.
  struct Worker {
    Buffer<Real> x[D];
    Buffer<int> id, rows;
    int candidates = 0, row = 0;
    Cell<D> cell;
    bool has_cell = false;
  };

  void build_chunk(int chunk, Real h2, const CpuCellGrid<D>& targets, const CpuCellGrid<D>& sources,
                   Worker& w) {
    const int last = std::min(slices(targets.n()), (chunk + 1) * slices_per_chunk);
    auto& out = index_[std::size_t(chunk)];
    std::size_t at = 0;
    w.has_cell = false;
    for (int s = chunk * slices_per_chunk; s < last; ++s) {
      const int longest = build_rows(s, h2, targets, sources, w);
      begin_.get()[s] = int(at);
      length_.get()[s] = longest;
      reserve(out, at, std::size_t(longest + lanes) * lanes);
      for (int k = 0; k < longest; k += lanes)
        transpose_rows(w.rows.get() + k, w.row, out.get() + at + std::size_t(k) * lanes);
      at += std::size_t(longest) * lanes;
    }
  }

  /// One row of neighbours a lane, padded to the longest; returns its length.
  int build_rows(int s, Real h2, const CpuCellGrid<D>& targets, const CpuCellGrid<D>& sources,
                 Worker& w) {
    int count[lanes] = {}, longest = 0;
    for (int l = 0; l < lanes; ++l) {
      const int i = s * lanes + l;
      if (i >= targets.n()) continue;
      if (!w.has_cell || !(targets.cell_of(i) == w.cell)) gather(targets.cell_of(i), sources, w);
      if (w.row < w.candidates + 2 * lanes) widen(w, l);
      count[l] = fill_row(i, h2, targets, w, w.rows.get() + std::size_t(l) * std::size_t(w.row));
      longest = std::max(longest, count[l]);
    }
    for (int l = 0; l < lanes; ++l) {
      int* row = w.rows.get() + std::size_t(l) * std::size_t(w.row);
      for (int k = count[l]; k < longest; ++k) row[k] = sources.n();
    }
    return longest;
  }

  FRESHET_HD int fill_row(int i, Real h2, const CpuCellGrid<D>& targets, const Worker& w,
                          int* row) {
    Pack x_i[D];
    for (int d = 0; d < D; ++d) x_i[d] = Pack(targets.component(d)[i]);
    const int* id = w.id.get();
    int n = 0;
    for (int t = 0; t < w.candidates; t += lanes) {
      Pack r2;
      for (int d = 0; d < D; ++d) {
        const Pack dx = x_i[d] - load(w.x[d].get() + t);
        r2 = d == 0 ? dx * dx : r2 + dx * dx;
      }
      n += append(row + n, r2 < Pack(h2), id + t);
    }
    return n;
  }

  /// The sources in the cells around `cell`, side by side.
  void gather(const Cell<D>& cell, const CpuCellGrid<D>& sources, Worker& w) {
    w.cell = cell;
    w.has_cell = true;
    constexpr int around = D == 3 ? 27 : 9;
    int begin[around], end[around], ranges = 0, total = 0;
    for (int k = 0; k < around; ++k) {
      Cell<D> near = cell;
      for (int d = 0, part = k; d < D; ++d, part /= 3) near.c[d] += part % 3 - 1;
      const int c = sources.index(near);
      if (c < 0 || sources.begin(c) == sources.end(c)) continue;
      if (ranges > 0 && k % 3 != 0 && end[ranges - 1] == sources.begin(c)) {
        end[ranges - 1] = sources.end(c);  // neighbours along x are neighbours in memory
      } else {
        begin[ranges] = sources.begin(c);
        end[ranges++] = sources.end(c);
      }
      total += sources.end(c) - sources.begin(c);
    }
    const auto room = std::size_t(total + 2 * lanes);
    for (int d = 0; d < D; ++d) w.x[d].reserve(room);
    int* id = w.id.reserve(room);
    w.candidates = 0;
    for (int r = 0; r < ranges; ++r) {
      const int m = end[r] - begin[r];
      for (int d = 0; d < D; ++d)
        std::memcpy(w.x[d].get() + w.candidates, sources.component(d) + begin[r],
                    std::size_t(m) * sizeof(Real));
      for (int k = 0; k < m; ++k) id[w.candidates + k] = begin[r] + k;
      w.candidates += m;
    }
    for (int k = 0; k < lanes; ++k) {  // no neighbours, to fill the last pack
      for (int d = 0; d < D; ++d) w.x[d].get()[w.candidates + k] = Real(1e9f);
      id[w.candidates + k] = sources.n();
    }
  }

  /// Longer rows, the first `used` kept. Rows of 2^n bytes would share cache sets.
  static void widen(Worker& w, int used) {
    const int row = w.candidates * 3 / 2 + 4 * lanes + (1024 - w.candidates * 3 / 2 % 1024) / 1024;
    Buffer<int> wider;
    wider.reserve(std::size_t(row) * lanes);
    for (int l = 0; l < used; ++l)
      std::memcpy(wider.get() + std::size_t(l) * std::size_t(row),
                  w.rows.get() + std::size_t(l) * std::size_t(w.row),
                  std::size_t(w.row) * sizeof(int));
    w.rows = std::move(wider);
    w.row = row;
  }

  /// Room for `more` entries after the first `used`, which stay.
  static void reserve(Buffer<int>& out, std::size_t used, std::size_t more) {
    if (out.size() >= used + more) return;
    Buffer<int> larger;
    larger.reserve((used + more) * 3 / 2);
    if (used) std::memcpy(larger.get(), out.get(), used * sizeof(int));
    out = std::move(larger);
  }

  std::vector<Buffer<int>> index_;  // one a chunk
  std::vector<Worker> workers_;
  Buffer<int> begin_, length_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
