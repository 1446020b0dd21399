// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

#include "backend/copies.h"
#include "backend/cpu/neighbor_lists.h"
#include "backend/fixed_point.h"
#include "backend/timings.h"
#include "core/over.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Threads and SIMD: a lane is a particle. A particle's sum has one order, the reference's,
/// whatever the threads and the instruction set; so have its bits.
template <int D> class CpuBackend {
 public:
  explicit CpuBackend(int threads) : threads_(threads) {}

  /// Gives the set its number; fields follow. The rules say which copies its particles have.
  void add_set(Particles<D>& set, int n, typename Copies<D>::Rules rules = {}) {
    set.n = n;
    set.set = int(sets_.size());
    sets_.push_back(std::make_unique<Set>(std::move(rules)));
  }
  /// Memory for one T a particle and copy, all zeros; the backend owns it and sorts what is kept.
  template <class T> void allocate(const Particles<D>& set, Keep keep, Field<T>& field) {
    auto& memory = memory_.emplace_back();
    const std::size_t room = std::size_t(set.n) * std::size_t(of(set).copies.room()) + lanes;
    field.data = reinterpret_cast<T*>(memory.reserve(room * sizeof(T)));
    threads_.blocks(set.n + lanes, [&](int b, int e) {  // the pages go to the threads that use them
      std::memset(static_cast<void*>(field.data + b), 0, std::size_t(e - b) * sizeof(T));
    });
    if (keep == Keep::kept)
      of(set).kept.push_back({reinterpret_cast<std::byte*>(field.data), sizeof(T), {}});
  }
  const std::vector<VerbTiming>& timings() const { return timings_.list(); }

  /// Copies of what is kept, for a step that may be taken back.
  void save(const char* name, const Particles<D>& p) { copy_kept(name, p, true); }
  void restore(const char* name, const Particles<D>& p) { copy_kept(name, p, false); }

  /// Sorts `moving` (and, the first time, the sets that stand still), then lists for each of its
  /// particles the neighbours in every set.
  template <class... Fixed>
  void find_neighbors(const char* name, Real support_radius, Particles<D>& moving,
                      const Fixed&... fixed) {
    const auto timer = timings_.time(name, moving.n);
    sort(support_radius, moving);
    copy(support_radius, moving);
    (sort_once(support_radius, fixed), ...);
    list(support_radius, moving, moving);
    (list(support_radius, moving, fixed), ...);
  }
  /// Lists for `targets` that stand still the neighbours among `sources`, which have been sorted.
  void list_neighbors(const char* name, Real support_radius, const Particles<D>& targets,
                      const Particles<D>& sources) {
    const auto timer = timings_.time(name, targets.n);
    sort_once(support_radius, targets);
    list(support_radius, targets, sources);
  }

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

  template <class... Fields> void share(const char*, const Particles<D>& p, Fields... fields) {
    (of(p).copies.share(p, fields), ...);
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

 private:
  struct KeptField {
    std::byte* data;
    std::size_t bytes;  // a particle
    Buffer<std::byte> saved;
  };
  struct Set {
    explicit Set(typename Copies<D>::Rules rules) : copies(std::move(rules)) {}
    Copies<D> copies;
    std::vector<KeptField> kept;
    CpuCellGrid<D> grid, copy_grid;
    bool sorted = false;
    std::vector<std::unique_ptr<SlicedLists<D>>> lists;  // by number of the source set
  };
  void copy_kept(const char* name, const Particles<D>& p, bool save) {
    const auto timer = timings_.time(name, p.n);
    for (KeptField& field : of(p).kept) {
      std::byte* saved = field.saved.reserve(std::size_t(p.n) * field.bytes);
      threads_.blocks(p.n, [&](int b, int e) {
        const std::size_t first = std::size_t(b) * field.bytes;
        std::memcpy((save ? saved : field.data) + first, (save ? field.data : saved) + first,
                    std::size_t(e - b) * field.bytes);
      });
    }
  }
  Set& of(const Particles<D>& p) { return *sets_[std::size_t(p.set)]; }

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

  void sort(Real h, const Particles<D>& p) {
    Set& set = of(p);
    set.grid.build(threads_, h, p);
    set.grid.write(threads_, p);
    for (const KeptField& field : set.kept) {
      if (field.data == static_cast<void*>(p.x.data) || field.data == static_cast<void*>(p.id.data))
        continue;             // written by the grid
      switch (field.bytes) {  // copies of a known size are single moves
        case 4:
          permute<4>(set.grid.order(), p.n, field.data);
          break;
        case 8:
          permute<8>(set.grid.order(), p.n, field.data);
          break;
        case 12:
          permute<12>(set.grid.order(), p.n, field.data);
          break;
        case 16:
          permute<16>(set.grid.order(), p.n, field.data);
          break;
        default:
          permute<24>(set.grid.order(), p.n, field.data);
          break;
      }
    }
    set.sorted = true;
  }
  /// Copies stand behind the particles, sorted like them.
  void copy(Real h, Particles<D>& p) {
    Set& set = of(p);
    if (set.copies.none()) return;
    set.copies.make(p, h);
    set.copies.place(p);
    const Particles<D> all{set.copies.size(), 0, p.set, {p.id.data + p.n}, {p.x.data + p.n}, {}};
    set.copy_grid.build(threads_, h, all);
    set.copies.permute(set.copy_grid.order());
    set.copies.place(p);
  }
  void sort_once(Real h, const Particles<D>& p) {
    if (!of(p).sorted) sort(h, p);
  }

  template <std::size_t bytes> void permute(const int* order, int n, std::byte* data) {
    struct Value {
      std::byte b[bytes];
    };
    auto* field = reinterpret_cast<Value*>(data);
    auto* spare = reinterpret_cast<Value*>(spare_.reserve(std::size_t(n) * bytes));
    threads_.blocks(n, [&](int b, int e) {
      for (int i = b; i < e; ++i) spare[i] = field[order[i]];
    });
    threads_.blocks(
        n, [&](int b, int e) { std::memcpy(field + b, spare + b, std::size_t(e - b) * bytes); });
  }

  void list(Real h, const Particles<D>& targets, const Particles<D>& sources) {
    if (targets.n == 0 || sources.n == 0) return;
    auto& lists = of(targets).lists;
    if (lists.size() < sets_.size()) lists.resize(sets_.size());
    auto& one = lists[std::size_t(sources.set)];
    if (!one) one = std::make_unique<SlicedLists<D>>();
    const Set& set = of(sources);
    const Source<D> all[] = {{&set.grid, 0}, {&set.copy_grid, sources.n}};
    one->build(threads_, h, of(targets).grid,
               std::span(all, sources.copies > 0 ? std::size_t(2) : std::size_t(1)));
  }

  /// The sources' records, and behind them the far one: the values of the first, so that a term
  /// computes with sound numbers what its kernel then takes times zero.
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
    const auto slice = (*of(targets).lists[std::size_t(over.set.set)])[s];
    if (slice.length == 0) return;
    const Term term = over.term;
    const At at_i = pack_of<At>(base, count, [&](int i) { return term.at(i); });
    Pack j[stride];
    Sum local = sum;
    for (const int *k = slice.index, *end = k + slice.length * lanes; k != end; k += lanes) {
      load_transposed<stride>(records, k, j);
      local += term(Pair<D, Pack>(x_i - position<D>(j)), at_i, values<D, Neighbor>(j));
    }
    sum = local;
  }

  /// The values of `count` particles, one a lane; the last fills what is left.
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

  Threads threads_;
  Timings timings_;
  std::vector<std::unique_ptr<Set>> sets_;
  std::vector<Buffer<std::byte>> memory_;
  Buffer<std::byte> spare_;
  Buffer<Real> records_[4];
  Buffer<double> parts_;
  Buffer<std::int64_t> whole_parts_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
