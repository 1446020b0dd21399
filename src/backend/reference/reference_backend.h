// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>
#include <map>
#include <memory>

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

  /// Gives the set its number; particles and fields follow.
  void add_set(Particles<D>& set, int n) {
    set.n = n;
    set.set = sets_++;
  }
  /// Memory for one T a particle, all zeros; the backend owns it.
  template <class T> void allocate(const Particles<D>& set, Keep, Field<T>& field) {
    memory_.push_back(std::make_unique<std::byte[]>(sizeof(T) * std::size_t(set.n)));
    field.data = reinterpret_cast<T*>(memory_.back().get());
  }
  const std::vector<VerbTiming>& timings() const { return timings_.list(); }

  template <class... Sets>
  void find_neighbors(const char* name, Real support_radius, const Particles<D>& moving,
                      const Sets&... fixed) {
    const auto timer = timings_.time(name, moving.n);
    list(support_radius, moving, moving);
    (list(support_radius, moving, fixed), ...);
  }

  template <class Term, class Finish>
  void sum_pairs(const char* name, const Particles<D>& targets, const Over<D, Term>& sources,
                 const Finish& finish) {
    sum_over(name, targets, finish, sources);
  }
  template <class TermA, class TermB, class Finish>
  void sum_pairs(const char* name, const Particles<D>& targets, const Over<D, TermA>& a,
                 const Over<D, TermB>& b, const Finish& finish) {
    sum_over(name, targets, finish, a, b);
  }

  template <class Visit>
  void for_each(const char* name, const Particles<D>& p, const Visit& visit) {
    const auto timer = timings_.time(name, p.n);
    for (int i = 0; i < p.n; ++i) visit(i);
  }

  template <class... Fields> void share(const char*, Fields...) {}  // nothing is copied here

  template <class Map> double max(const char* name, const Particles<D>& p, const Map& map) {
    const auto timer = timings_.time(name, p.n);
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < p.n; ++i) most = std::max(most, double(map(i)));
    return most;
  }

 private:
  void list(Real h, const Particles<D>& targets, const Particles<D>& sources) {
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
    const auto& lists = lists_.at({targets.set, sources.set.set});
    Neighbor* neighbor = scratch<Neighbor>(neighbor_memory_, std::size_t(sources.set.n));
    for (int j = 0; j < sources.set.n; ++j) neighbor[j] = sources.term.neighbor(j);
    for (int i = 0; i < targets.n; ++i) {
      const auto at_i = sources.term.at(i);
      Sum sum = sums[i];
      for (const int j : lists[i])
        sum += sources.term(Pair<D, Real>(targets.x[i] - sources.set.x[j]), at_i, neighbor[j]);
      sums[i] = sum;
    }
  }

  template <class T> static T* scratch(std::vector<std::byte>& memory, std::size_t n) {
    if (memory.size() < n * sizeof(T)) memory.resize(n * sizeof(T));
    return reinterpret_cast<T*>(memory.data());
  }

  Search search_;
  NeighborOrder order_;
  int sets_ = 0;
  std::map<std::pair<int, int>, NeighborLists<D>> lists_;  // by targets and sources
  std::vector<std::byte> neighbor_memory_, sum_memory_;
  std::vector<std::unique_ptr<std::byte[]>> memory_;
  Timings timings_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
