// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "backend/cpu/append.h"
#include "backend/cpu/candidates.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Sliced neighbour lists. Slice s holds the `lanes` consecutive targets from s * lanes on. Entry k
/// of lane l is index[k * lanes + l]. Short lanes are padded with the far particle, whose index is
/// one more than that of the last source.
template <int D> class SlicedLists {
 public:
  static constexpr int slices_per_chunk = 1024 / lanes;

  struct Slice {
    const int* index;
    int length;  // entries per lane
  };
  Slice operator[](int s) const {
    const int chunk = s / slices_per_chunk;
    return {index_[std::size_t(chunk)].get() + begin_.get()[s], length_.get()[s]};
  }
  static int slices(int n) { return (n + lanes - 1) / lanes; }
  static int chunks(int n) { return (slices(n) + slices_per_chunk - 1) / slices_per_chunk; }

  /// Lists, for every target, the sources closer than h [m]: by grid, by cell, ascending in a cell.
  void build(const Threads& threads, Real h, const CpuCellGrid<D>& targets,
             std::span<const Source<D>> sources) {
    const int n = targets.n();
    begin_.reserve(std::size_t(slices(n)));
    length_.reserve(std::size_t(slices(n)));
    if (index_.size() < std::size_t(chunks(n))) index_.resize(std::size_t(chunks(n)));
    workers_.resize(std::size_t(threads.count()));
    far_ = 0;
    for (const Source<D>& s : sources) far_ = std::max(far_, s.offset + s.grid->n());
    threads.parts(chunks(n), [&](int chunk) {
      build_chunk(chunk, h * h, targets, sources, workers_[std::size_t(Threads::current())]);
    });
  }

 private:
  /// The memory of a thread that builds a chunk. It grows to the maximum number of candidates.
  struct Worker {
    Candidates<D> candidates;
    Buffer<int> rows;
    int row = 0;
    int* row_of(int lane) const { return rows.get() + std::size_t(lane) * std::size_t(row); }
  };

  void build_chunk(int chunk, Real h2, const CpuCellGrid<D>& targets,
                   std::span<const Source<D>> sources, Worker& w) {
    const int last = std::min(slices(targets.n()), (chunk + 1) * slices_per_chunk);
    auto& out = index_[std::size_t(chunk)];
    std::size_t at = 0;
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

  /// Builds one row of neighbours per lane, padded to the longest. Returns the longest length.
  int build_rows(int s, Real h2, const CpuCellGrid<D>& targets, std::span<const Source<D>> sources,
                 Worker& w) {
    int count[lanes] = {};
    const int begin = s * lanes, end = std::min(begin + lanes, targets.n());
    for (int first = begin; first < end;) {
      const Group<D> group(targets, first, end);
      w.candidates.find(group, h2, sources);
      if (w.row < w.candidates.count() + 2 * lanes) widen(w, first - begin);
      for (int i = first; i < group.last; ++i)
        count[i - begin] = w.candidates.near(targets, i, h2, w.row_of(i - begin));
      first = group.last;
    }
    const int longest = *std::max_element(count, count + lanes);
    for (int l = 0; l < lanes; ++l) {  // pads in whole packs; rows have room for one more
      int k = count[l];
      do fill(w.row_of(l) + k, far_);
      while ((k += lanes) < longest);
    }
    return longest;
  }

  /// Lengthens the rows and keeps the first `used`. A length of 2^n bytes is avoided, because such
  /// rows would share cache sets.
  static void widen(Worker& w, int used) {
    const int row = (w.candidates.count() * 3 / 2 + 255) / 256 * 256 + 2 * lanes;
    Buffer<int> wider;
    wider.reserve(std::size_t(row) * lanes);
    for (int l = 0; l < used; ++l)
      std::copy_n(w.row_of(l), w.row, wider.get() + std::size_t(l) * std::size_t(row));
    w.rows = std::move(wider);
    w.row = row;
  }

  /// Makes room for `more` entries after the first `used`, which are kept.
  static void reserve(Buffer<int>& out, std::size_t used, std::size_t more) {
    if (out.size() >= used + more) return;
    Buffer<int> larger;
    larger.reserve((used + more) * 3 / 2);
    if (used) std::memcpy(larger.get(), out.get(), used * sizeof(int));
    out = std::move(larger);
  }

  std::vector<Buffer<int>> index_;  // one per chunk
  std::vector<Worker> workers_;
  Buffer<int> begin_, length_;
  int far_ = 0;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
