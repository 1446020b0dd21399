// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <memory>
#include <tuple>
#include <vector>

#include "backend/copies.h"
#include "backend/cpu/neighbor_lists.h"
#include "backend/edit.h"
#include "backend/group_sums.h"
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
    sets_.back()->room = n;
  }
  /// Memory for one T a particle and copy, all zeros; the backend owns it and sorts what is kept.
  /// Where the set will be edited, `field` must stay where it is.
  template <class T> void allocate(const Particles<D>& set, Keep keep, Field<T>& field) {
    Memory& m = of(set).memory.emplace_back();
    m.field = FieldOfSet::of(keep, field);
    reserve(of(set), m);
    clear(m, 0, set.n + lanes);
  }
  const std::vector<VerbTiming>& timings() const { return timings_.list(); }

  /// Copies of what is kept, for a step that may be taken back.
  void save(const char* name, const Particles<D>& p) { copy_kept(name, p, true); }
  void restore(const char* name, const Particles<D>& p) { copy_kept(name, p, false); }

  /// Between steps: takes away the particles at the places `gone` (ascending), and puts `more` new
  /// ones, all zeros, behind the others, which keep all their fields. Copies and lists are void
  /// until the next search.
  void edit(const char* name, Particles<D>& p, std::span<const int> gone, int more) {
    const auto timer = timings_.time(name, p.n);
    Set& set = of(p);
    const int left = p.n - int(gone.size()), n = left + more;
    const bool grows = n > set.room;
    set.room = roomier(n, set.room);
    for (Memory& m : set.memory) {
      fill_gaps(m.data.get(), m.field.bytes, gone, p.n);
      if (grows) {
        const Buffer<std::byte> before = std::exchange(m.data, {});
        reserve(set, m);
        threads_.blocks(left, [&](int b, int e) {
          const std::size_t first = std::size_t(b) * m.field.bytes;
          std::memcpy(m.data.get() + first, before.get() + first,
                      std::size_t(e - b) * m.field.bytes);
        });
      }
      clear(m, left, n + lanes);
    }
    p.n = n;
    p.copies = 0;
    set.copies.forget();
  }

  /// Sorts `moving` (and other sets that move; the first time those that stand still as well), then
  /// lists for each of its particles the neighbours in every set.
  template <class... Fixed>
  void find_neighbors(const char* name, Real support_radius, Particles<D>& moving,
                      const Fixed&... fixed) {
    const auto timer = timings_.time(name, moving.n);
    sort(support_radius, moving);
    copy(support_radius, moving);
    (sort_if_needed(support_radius, fixed), ...);
    list(support_radius, moving, moving);
    (list(support_radius, moving, fixed), ...);
  }
  /// Lists for `targets` the neighbours among `sources`, which have been sorted.
  void list_neighbors(const char* name, Real support_radius, const Particles<D>& targets,
                      const Particles<D>& sources) {
    const auto timer = timings_.time(name, targets.n);
    sort_if_needed(support_radius, targets);
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

  /// The sums of map(i).value by map(i).group, one number a group and component, by fixed point.
  template <class Map, class Sum>
  void sum_groups(const char* name, const Particles<D>& p, int groups, const Map& map, Sum* sums) {
    const auto timer = timings_.time(name, p.n);
    group_sums_.add(p.n, groups, map, sums);
  }

 private:
  struct Memory {
    FieldOfSet field;
    Buffer<std::byte> data, saved;
  };
  struct Set {
    explicit Set(typename Copies<D>::Rules rules) : copies(std::move(rules)) {}
    Copies<D> copies;
    int room = 0;  // for so many particles there is memory
    std::vector<Memory> memory;
    CpuCellGrid<D> grid, copy_grid;
    bool sorted = false;
    std::vector<std::unique_ptr<SlicedLists<D>>> lists;  // by number of the source set
  };
  void copy_kept(const char* name, const Particles<D>& p, bool save) {
    const auto timer = timings_.time(name, p.n);
    for (Memory& m : of(p).memory) {
      if (m.field.keep != Keep::kept) continue;
      const std::size_t bytes = m.field.bytes;
      std::byte *saved = m.saved.reserve(std::size_t(p.n) * bytes), *data = m.data.get();
      threads_.blocks(p.n, [&](int b, int e) {
        const std::size_t first = std::size_t(b) * bytes;
        std::memcpy((save ? saved : data) + first, (save ? data : saved) + first,
                    std::size_t(e - b) * bytes);
      });
    }
  }
  Set& of(const Particles<D>& p) { return *sets_[std::size_t(p.set)]; }

  void reserve(const Set& set, Memory& m) {
    const std::size_t room = std::size_t(set.room) * std::size_t(set.copies.room()) + lanes;
    m.field.point(m.field.field, m.data.reserve(room * m.field.bytes));
  }
  /// Zeros; the pages go to the threads that use them.
  void clear(Memory& m, int begin, int end) {
    threads_.blocks(end - begin, [&](int b, int e) {
      std::memset(m.data.get() + std::size_t(begin + b) * m.field.bytes, 0,
                  std::size_t(e - b) * m.field.bytes);
    });
  }

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
    for (const Memory& m : set.memory) {
      std::byte* data = m.data.get();
      if (m.field.keep != Keep::kept || data == static_cast<void*>(p.x.data) ||
          data == static_cast<void*>(p.id.data))
        continue;               // the grid writes x and id
      switch (m.field.bytes) {  // copies of a known size are single moves
        case 4:
          permute<4>(set.grid.order(), p.n, data);
          break;
        case 8:
          permute<8>(set.grid.order(), p.n, data);
          break;
        case 12:
          permute<12>(set.grid.order(), p.n, data);
          break;
        case 16:
          permute<16>(set.grid.order(), p.n, data);
          break;
        default:
          permute<24>(set.grid.order(), p.n, data);
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
  void sort_if_needed(Real h, const Particles<D>& p) {
    if (p.moves || !of(p).sorted) sort(h, p);
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
  Buffer<std::byte> spare_;
  Buffer<Real> records_[4];
  Buffer<double> parts_;
  Buffer<std::int64_t> whole_parts_;
  GroupSums group_sums_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
