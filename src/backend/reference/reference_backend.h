// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <chrono>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

#include "backend/reference/neighbor_lists.h"
#include "freshet/report.h"
#include "freshet/scene.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The truth that every other backend is tested against: scalar, one thread, neighbours in one
/// order. Particles stay in the order of their ids.
template <int D> class ReferenceBackend {
 public:
  explicit ReferenceBackend(Search search = Search::grid, NeighborOrder order = NeighborOrder::cell)
      : search_(search), order_(order) {}

  /// Memory for one T a particle, all zeros; the backend owns it.
  template <class T> T* allocate(int n) {
    memory_.push_back(std::make_unique<std::byte[]>(sizeof(T) * std::size_t(n)));
    return reinterpret_cast<T*>(memory_.back().get());
  }
  const std::vector<VerbTiming>& timings() const { return timings_; }

  void find_neighbors(const char* name, Real support_radius, const Particles<D>& p) {
    const Timer timer(*this, name, p.n);
    neighbors_.build(search_, order_, support_radius, p);
  }

  template <class Term, class Finish>
  void sum_pairs(const char* name, const Particles<D>& p, const Term& term, const Finish& finish) {
    const Timer timer(*this, name, p.n);
    using At = typename Term::template At<Real>;
    using Sum = decltype(term(std::declval<Pair<D, Real>>(), At{}, At{}));
    const auto n = std::size_t(p.n);
    At* at = scratch<At>(at_memory_, n);  // every term sees the fields as they were before the pass
    Sum* sums = scratch<Sum>(sum_memory_, n);
    for (int i = 0; i < p.n; ++i) at[i] = term.at(i);
    for (int i = 0; i < p.n; ++i) {
      Sum sum{};
      for (const int j : neighbors_[i]) sum += term(Pair<D, Real>(p.x[i] - p.x[j]), at[i], at[j]);
      sums[i] = sum;
    }
    for (int i = 0; i < p.n; ++i) finish(i, sums[i]);
  }

  template <class Visit>
  void for_each(const char* name, const Particles<D>& p, const Visit& visit) {
    const Timer timer(*this, name, p.n);
    for (int i = 0; i < p.n; ++i) visit(i);
  }

  template <class... Fields> void share(const char*, Fields...) {}  // nothing is copied here

  template <class Map> double sum(const char* name, const Particles<D>& p, const Map& map) {
    const Timer timer(*this, name, p.n);
    double total = 0;
    for (int i = 0; i < p.n; ++i) total += double(map(i));
    return total;
  }
  template <class Map> double max(const char* name, const Particles<D>& p, const Map& map) {
    const Timer timer(*this, name, p.n);
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < p.n; ++i) most = std::max(most, double(map(i)));
    return most;
  }

 private:
  /// Adds the time of a scope to the verb of that name.
  class Timer {
   public:
    Timer(ReferenceBackend& b, const char* name, int n) : b_(b), index_(b.timing(name)) {
      b_.timings_[index_].calls += 1;
      b_.timings_[index_].targets += n;
    }
    Timer(const Timer&) = delete;
    ~Timer() {
      const std::chrono::duration<double> taken = Clock::now() - start_;
      b_.timings_[index_].seconds += taken.count();
    }

   private:
    using Clock = std::chrono::steady_clock;
    ReferenceBackend& b_;
    std::size_t index_;
    Clock::time_point start_ = Clock::now();
  };

  std::size_t timing(const char* name) {
    for (std::size_t k = 0; k < timings_.size(); ++k)
      if (timings_[k].name == name) return k;
    timings_.push_back({name});
    return timings_.size() - 1;
  }

  template <class T> static T* scratch(std::vector<std::byte>& memory, std::size_t n) {
    if (memory.size() < n * sizeof(T)) memory.resize(n * sizeof(T));
    return std::uninitialized_default_construct_n(reinterpret_cast<T*>(memory.data()), n) - n;
  }

  Search search_;
  NeighborOrder order_;
  NeighborLists<D> neighbors_;
  std::vector<std::byte> at_memory_, sum_memory_;
  std::vector<std::unique_ptr<std::byte[]>> memory_;
  std::vector<VerbTiming> timings_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
