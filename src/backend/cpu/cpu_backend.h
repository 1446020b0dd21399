// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <tuple>
#include <vector>

#include "backend/cpu/cpu_sets.h"
#include "backend/cpu/records.h"
#include "backend/group_sums.h"
#include "core/over.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The backend with threads and SIMD, where a lane is a particle. A particle's sum has the order of
/// the reference backend for any number of threads and any instruction set, so it has the same
/// bits.
template <int D> class CpuBackend : public CpuSets<D> {
 public:
  using CpuSets<D>::CpuSets;

  template <class... Args>
  void sum_pairs(const char* name, const Particles<D>& targets, const Args&... sources_finish) {
    with_last_first([&](const auto& finish,
                        const auto&... sources) { sum_over(name, targets, finish, sources...); },
                    sources_finish...);
  }

  template <class Visit>
  void for_each(const char* name, const Particles<D>& p, const Visit& visit) {
    const auto timer = timings_.time(name, p.n);
    threads_.blocks(p.n, [&](int b, int e) {
      const Visit here = visit;
      for (int i = b; i < e; ++i) here(i);
    });
  }

  template <class Map> double max(const char* name, const Particles<D>& p, const Map& map) {
    const auto timer = timings_.time(name, p.n);
    double* parts = parts_.reserve(std::size_t(p.n / Threads::block + 1));
    threads_.blocks(p.n, [&](int b, int e) {
      const Map here = map;
      double most = -std::numeric_limits<double>::infinity();
      for (int i = b; i < e; ++i) most = std::max(most, double(here(i)));
      parts[b / Threads::block] = most;
    });
    double most = -std::numeric_limits<double>::infinity();
    for (int b = 0; b * Threads::block < p.n; ++b) most = std::max(most, parts[b]);
    return most;
  }

  template <class Map> double sum(const char* name, const Particles<D>& p, const Map& map) {
    if (p.n == 0) return 0;
    const FixedPoint fixed(
        max(name, p, [=] FRESHET_LAMBDA(int i) { return std::abs(double(map(i))); }), p.n);
    std::int64_t* parts = whole_parts_.reserve(std::size_t(p.n / Threads::block + 1));
    threads_.blocks(p.n, [&](int b, int e) {
      std::int64_t part = 0;
      for (int i = b; i < e; ++i) part += fixed.whole(double(map(i)));
      parts[b / Threads::block] = part;
    });
    std::int64_t total = 0;
    for (int b = 0; b * Threads::block < p.n; ++b) total += parts[b];
    return fixed.value(total);
  }

  /// sums[g] = the sum of map(i).value over the particles with map(i).group == g, in fixed point.
  template <class Map, class Sum>
  void sum_groups(const char* name, const Particles<D>& p, int groups, const Map& map, Sum* sums) {
    const auto timer = timings_.time(name, p.n);
    group_sums_.add(p.n, groups, map, sums);
  }

 private:
  using CpuSets<D>::of, CpuSets<D>::threads_, CpuSets<D>::timings_;

  template <class Finish, class... Overs>
  void sum_over(const char* name, const Particles<D>& targets, const Finish& finish,
                const Overs&... overs) {
    const auto timer = timings_.time(name, targets.n);
    int k = 0;
    (pack(overs, records_[k++]), ...);
    threads_.parts(SlicedLists<D>::chunks(targets.n), [&](int chunk) {
      constexpr int per_chunk = SlicedLists<D>::slices_per_chunk;
      const int last = std::min(SlicedLists<D>::slices(targets.n), (chunk + 1) * per_chunk);
      const std::tuple local(overs...);  // copies on the stack: no store can alias them
      const Finish finish_here = finish;
      for (int s = chunk * per_chunk; s < last; ++s) sum_slice(s, targets, local, finish_here);
    });
  }

  /// Packs the sources' records, followed by the far particle. It has the values of the first
  /// source, so that a term computes finite numbers, which its kernel multiplies by zero.
  template <class Term> void pack(const Over<D, Term>& over, Buffer<Real>& records) {
    using Rec = Record<D, typename Term::template Neighbor<Real>>;
    const Particles<D>& sources = over.set;
    const int n = sources.n + sources.copies;
    Real* to = records.reserve(std::size_t(n + lanes) * Rec::stride);
    threads_.blocks(n, [&](int b, int e) {
      const Term term = over.term;
      for (int j = b; j < e; ++j)
        Rec::write(to + std::size_t(j) * Rec::stride, sources.x[j], term.neighbor(j));
    });
    if (n == 0) return;
    Vec<D> far{};
    far.x = Real(1e9f);
    if (over.only_copies_of >= 0)
      for (int j = 0; j < n; ++j)
        if (j < sources.n || !of(sources).copies.due_to(j - sources.n, over.only_copies_of))
          Rec::write(to + std::size_t(j) * Rec::stride, far, over.term.neighbor(j));
    for (int j = n; j < n + lanes; ++j)
      Rec::write(to + std::size_t(j) * Rec::stride, far, over.term.neighbor(0));
  }

  template <class Overs, class Finish>
  void sum_slice(int s, const Particles<D>& targets, const Overs& overs, const Finish& finish) {
    using Sum = typename std::tuple_element_t<0, Overs>::template Sum<Pack>;
    const int base = s * lanes, count = std::min(lanes, targets.n - base);
    const Vec<D, Pack> x_i =
        pack_of<Vec<D, Pack>>(base, count, [&](int i) { return targets.x[i]; });
    Sum sum{};
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      (add(s, base, count, targets, std::get<k>(overs), records_[k].get(), x_i, sum), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<Overs>>());
    finish_slice(base, count, sum, finish);
  }

  template <class Term, class Sum>
  FRESHET_HD void add(int s, int base, int count, const Particles<D>& targets,
                      const Over<D, Term>& over, const Real* records, const Vec<D, Pack>& x_i,
                      Sum& sum) {
    using At = typename Term::template At<Pack>;
    using Neighbor = typename Term::template Neighbor<Pack>;
    constexpr int stride = Record<D, typename Term::template Neighbor<Real>>::stride;
    if (over.set.n == 0) return;
    const auto slice = of(targets).lists[std::size_t(over.set.set)]->sliced[s];
    if (slice.length == 0) return;
    const Term term = over.term;
    if constexpr (requires { term.wants(0); })
      if (!any_of(base, count, [&](int i) { return term.wants(i); })) return;
    const At at_i = pack_of<At>(base, count, [&](int i) { return term.at(i); });
    Pack j[stride];
    Sum local = sum;
    for (const int *k = slice.index, *end = k + slice.length * lanes; k != end; k += lanes) {
      load_transposed<stride>(records, k, j);
      local += term(Pair<D, Pack>(x_i - position<D>(j)), at_i, values<D, Neighbor>(j));
    }
    sum = local;
  }

  template <class F> FRESHET_HD static bool any_of(int base, int count, const F& f) {
    bool any = false;
    for (int i = base; i < base + count; ++i) any |= f(i);
    return any;
  }

  /// The values of `count` particles, one per lane; the last particle fills the remaining lanes.
  template <class Packed, class F>
  FRESHET_HD static Packed pack_of(int base, int count, const F& value) {
    Packed out;
    if constexpr (!std::is_empty_v<Packed>) {
      constexpr int n = int(sizeof(Packed) / sizeof(Pack));
      alignas(64) Real lane_of[n][lanes];
      for (int l = 0; l < lanes; ++l) {
        const auto one = value(base + std::min(l, count - 1));
        Real flat[n];
        static_assert(sizeof flat == sizeof one, "a record's members are Reals and Vecs only");
        std::memcpy(flat, &one, sizeof flat);
        for (int c = 0; c < n; ++c) lane_of[c][l] = flat[c];
      }
      std::memcpy(&out, lane_of, sizeof out);
    }
    return out;
  }

  template <class Sum, class Finish>
  FRESHET_HD static void finish_slice(int base, int count, const Sum& sum, const Finish& finish) {
    using One = typename ScalarOf<Sum>::type;
    constexpr int n = int(sizeof(Sum) / sizeof(Pack));
    alignas(64) Real lane_of[n][lanes];
    std::memcpy(lane_of, &sum, sizeof sum);
    for (int l = 0; l < count; ++l) {
      Real flat[n];
      for (int c = 0; c < n; ++c) flat[c] = lane_of[c][l];
      One one;
      std::memcpy(static_cast<void*>(&one), flat, sizeof one);
      finish(base + l, one);
    }
  }

  template <class T> struct ScalarOf { using type = Real; };
  template <template <int, class> class S, int N> struct ScalarOf<S<N, Pack>> {
    using type = S<N, Real>;
  };

  Buffer<Real> records_[4];
  Buffer<double> parts_;
  Buffer<std::int64_t> whole_parts_;
  GroupSums group_sums_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
