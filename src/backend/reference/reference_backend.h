// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <span>

#include "backend/copies.h"
#include "backend/edit.h"
#include "backend/group_sums.h"
#include "backend/reference/neighbor_lists.h"
#include "backend/timings.h"
#include "core/over.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The truth that every other backend is tested against: scalar, one thread, neighbours in one
/// order. Particles stay in the order of their ids.
template <int D> class ReferenceBackend {
 public:
  explicit ReferenceBackend(Search search = Search::grid, NeighborOrder order = NeighborOrder::cell)
      : search_(search), order_(order) {}

  /// Gives the set its number; fields follow. The rules say which copies its particles have.
  void add_set(Particles<D>& set, int n, typename Copies<D>::Rules rules = {}) {
    set.n = n;
    set.set = int(copies_.size());
    copies_.emplace_back(std::move(rules));
    room_.push_back(n);
  }
  /// Memory for one T a particle and copy, all zeros; the backend owns it. Where the set will be
  /// edited, `field` must stay where it is.
  template <class T> void allocate(const Particles<D>& set, Keep keep, Field<T>& field) {
    Memory memory{set.set, FieldOfSet::of(keep, field), {}, {}};
    memory.data = room_for(room_[std::size_t(set.set)], memory);
    memory.field.point(&field, memory.data.get());
    memory_.push_back(std::move(memory));
  }
  const std::vector<VerbTiming>& timings() const { return timings_.list(); }

  /// Copies of what is kept, for a step that may be taken back.
  void save(const char*, const Particles<D>& p) {
    for (Memory& m : memory_)
      if (m.set == p.set && m.field.keep == Keep::kept)
        m.saved.assign(m.data.get(), m.data.get() + std::size_t(p.n) * m.field.bytes);
  }
  void restore(const char*, const Particles<D>& p) {
    for (Memory& m : memory_)
      if (m.set == p.set && m.field.keep == Keep::kept)
        std::copy(m.saved.begin(), m.saved.end(), m.data.get());
  }
  /// Between steps: takes away the particles at the places `gone` (ascending), and puts `more` new
  /// ones, all zeros, behind the others, which keep all their fields. Copies and lists are void
  /// until the next search.
  void edit(const char* name, Particles<D>& p, std::span<const int> gone, int more) {
    const auto timer = timings_.time(name, p.n);
    const int left = p.n - int(gone.size()), n = left + more;
    int& room = room_[std::size_t(p.set)];
    const bool grows = n > room;
    room = roomier(n, room);
    for (Memory& m : memory_) {
      if (m.set != p.set) continue;
      const std::size_t bytes = m.field.bytes;
      close_gaps(m.data.get(), bytes, gone, p.n);
      if (grows) {
        auto larger = room_for(room, m);
        std::copy_n(m.data.get(), std::size_t(left) * bytes, larger.get());
        m.data = std::move(larger);
        m.field.point(m.field.field, m.data.get());
      }
      std::fill_n(m.data.get() + std::size_t(left) * bytes, std::size_t(more) * bytes,
                  std::byte(0));
    }
    p.n = n;
    p.copies = 0;
    copies_[std::size_t(p.set)].forget();
  }

  template <class... Sets>
  void find_neighbors(const char* name, Real support_radius, Particles<D>& moving,
                      const Sets&... fixed) {
    const auto timer = timings_.time(name, moving.n);
    Copies<D>& copies = copies_[std::size_t(moving.set)];
    copies.make(moving, support_radius);
    copies.place(moving);
    searched_.resize(copies_.size());
    searched_[std::size_t(moving.set)].assign(moving.x.data,
                                              moving.x.data + moving.n + moving.copies);
    list(support_radius, moving, moving);
    (list(support_radius, moving, static_cast<const Particles<D>&>(fixed)), ...);
  }
  void list_neighbors(const char* name, Real support_radius, const Particles<D>& targets,
                      const Particles<D>& sources) {
    const auto timer = timings_.time(name, targets.n);
    Particles<D> as_found = sources;
    as_found.x.data = searched_.at(std::size_t(sources.set)).data();
    list(support_radius, targets, as_found);
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
    for (int i = 0; i < p.n; ++i) visit(i);
  }

  template <class... Fields> void share(const char*, const Particles<D>& p, Fields... fields) {
    (copies_[std::size_t(p.set)].share(p, fields), ...);
  }

  template <class Map> double max(const char* name, const Particles<D>& p, const Map& map) {
    const auto timer = timings_.time(name, p.n);
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < p.n; ++i) most = std::max(most, double(map(i)));
    return most;
  }

  template <class Map> double sum(const char* name, const Particles<D>& p, const Map& map) {
    if (p.n == 0) return 0;
    const FixedPoint fixed(max(name, p, [&](int i) { return std::abs(double(map(i))); }), p.n);
    std::int64_t total = 0;
    for (int i = 0; i < p.n; ++i) total += fixed.whole(map(i));
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
    int set;
    FieldOfSet field;
    std::unique_ptr<std::byte[]> data;
    std::vector<std::byte> saved;
  };
  std::unique_ptr<std::byte[]> room_for(int particles, const Memory& m) const {
    const std::size_t each = std::size_t(copies_[std::size_t(m.set)].room()) * m.field.bytes;
    return std::make_unique<std::byte[]>(std::size_t(particles) * each);
  }

  void list(Real h, const Particles<D>& targets, const Particles<D>& sources) {
    if (targets.n == 0 || sources.n == 0) return;
    lists_[{targets.set, sources.set}].build(search_, order_, h, targets, sources);
  }

  template <class Finish, class First, class... More>
  void sum_over(const char* name, const Particles<D>& targets, const Finish& finish,
                const First& first, const More&... more) {
    const auto timer = timings_.time(name, targets.n);
    using Sum = typename First::template Sum<Real>;
    Sum* sums = scratch<Sum>(sum_memory_, std::size_t(targets.n));
    std::fill_n(sums, targets.n, Sum{});
    add(targets, first, sums);
    (add(targets, more, sums), ...);
    for (int i = 0; i < targets.n; ++i) finish(i, sums[i]);  // after all sums: they see old fields
  }

  template <class Term, class Sum>
  void add(const Particles<D>& targets, const Over<D, Term>& sources, Sum* sums) {
    using Neighbor = typename Term::template Neighbor<Real>;
    if (sources.set.n == 0) return;
    const auto& lists = lists_.at({targets.set, sources.set.set});
    const int n = sources.set.n + sources.set.copies;
    Neighbor* neighbor = scratch<Neighbor>(neighbor_memory_, std::size_t(n));
    for (int j = 0; j < n; ++j) neighbor[j] = sources.term.neighbor(j);
    for (int i = 0; i < targets.n; ++i) {
      const auto at_i = sources.term.at(i);
      Sum sum = sums[i];
      for (const int j : lists[i]) {
        if (!counts(sources, j)) continue;
        sum += sources.term(Pair<D, Real>(targets.x[i] - sources.set.x[j]), at_i, neighbor[j]);
      }
      sums[i] = sum;
    }
  }

  template <class Term> bool counts(const Over<D, Term>& over, int j) const {
    if (over.only_copies_of < 0) return true;
    const int k = j - over.set.n;
    return k >= 0 && copies_[std::size_t(over.set.set)].due_to(k, over.only_copies_of);
  }

  template <class T> static T* scratch(std::vector<std::byte>& memory, std::size_t n) {
    if (memory.size() < n * sizeof(T)) memory.resize(n * sizeof(T));
    return reinterpret_cast<T*>(memory.data());
  }

  Search search_;
  NeighborOrder order_;
  std::vector<Copies<D>> copies_;              // by set
  std::vector<std::vector<Vec<D>>> searched_;  // by set: positions when neighbours were found
  std::map<std::pair<int, int>, NeighborLists<D>> lists_;  // by targets and sources
  std::vector<int> room_;                                  // by set: for so many particles
  std::vector<std::byte> neighbor_memory_, sum_memory_;
  std::vector<Memory> memory_;
  GroupSums group_sums_;
  Timings timings_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
