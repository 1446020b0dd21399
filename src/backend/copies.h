// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "boundary/copy_rule.h"
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The copies of one set: the source particle and the rules of each.
template <int D> class Copies {
 public:
  using Rules = std::vector<CopyRule<D>>;
  struct Copy {
    int source;
    std::uint32_t rules;  ///< bit mask of the rules that made it; several near edges and corners
  };

  explicit Copies(Rules rules = {}) : rules_(std::move(rules)) {}
  bool none() const { return rules_.empty(); }
  int size() const { return int(copies_.size()); }
  /// The maximum number of particles and copies over the number of particles.
  int room() const {
    int room = 1, last = -1;
    for (const auto& rule : rules_) {
      if (rule.axis != last) room *= 2;
      last = rule.axis;
    }
    return room;
  }
  /// Whether `rule` is the first of the rules that made copy k.
  bool due_to(int k, int rule) const {
    const std::uint32_t rules = copies_[std::size_t(k)].rules;
    return (rules & -rules) == std::uint32_t(1) << rule;
  }

  /// Removes all copies until the next search, after particles were added or removed.
  void forget() { copies_.clear(); }

  /// Creates the copies of the particles at the positions p.x, in the order of the particles.
  void make(const Particles<D>& p, Real h) {
    const std::size_t most = std::size_t(p.n) * std::size_t(room() - 1);
    copies_.clear();
    if (copies_.capacity() < most) {  // pages that are never written take no memory
      copies_.reserve(most + most / 2);
      sorted_.reserve(most + most / 2);
    }
    for (int i = 0; i < p.n; ++i) {
      const std::size_t first = copies_.size();
      for (std::size_t r = 0; r < rules_.size(); ++r) {
        const std::size_t last = copies_.size();
        if (rules_[r].near(p.x[i], h)) copies_.push_back({i, bit(r)});
        for (std::size_t k = first; k < last; ++k)
          if (!meets_its_axis(copies_[k], r) && rules_[r].near(position(p.x[i], copies_[k]), h))
            copies_.push_back({i, copies_[k].rules | bit(r)});
      }
    }
    if (copies_.size() > most) throw std::length_error("more copies than a corner has");
  }
  /// Sorts the copies: the k-th copy becomes the one that was at order[k].
  void permute(const int* order) {
    sorted_.resize(copies_.size());
    for (std::size_t k = 0; k < sorted_.size(); ++k) sorted_[k] = copies_[std::size_t(order[k])];
    copies_.swap(sorted_);
  }

  /// Writes position, id and velocity of the copies after those of the particles.
  void place(Particles<D>& p) const {
    p.copies = size();
    for (int k = 0; k < size(); ++k) {
      const Copy& copy = copies_[std::size_t(k)];
      p.x[p.n + k] = position(p.x[copy.source], copy);
      p.id[p.n + k] = p.id[copy.source];
    }
    share(p, p.v);
  }
  /// Updates a field at all copies.
  template <class T> void share(const Particles<D>& p, Field<T> field) const {
    share(p, field, 0, size());
  }
  /// Updates a field at the copies begin to end - 1.
  template <class T> void share(const Particles<D>& p, Field<T> field, int begin, int end) const {
    for (int k = begin; k < end; ++k) field[p.n + k] = field[copies_[std::size_t(k)].source];
  }
  void share(const Particles<D>& p, Field<Vec<D>> field, int begin, int end) const {
    const bool velocity = field.data == p.v.data, place = field.data == p.x.data;
    for (int k = begin; k < end; ++k) {
      const Copy& copy = copies_[std::size_t(k)];
      Vec<D> a = field[copy.source];
      for_rules(copy, [&](const CopyRule<D>& rule) {
        a = place ? rule.position(a) : velocity ? rule.velocity(a) : rule.polar(a);
      });
      field[p.n + k] = a;
    }
  }

 private:
  static std::uint32_t bit(std::size_t r) { return std::uint32_t(1) << r; }
  template <class F> void for_rules(const Copy& copy, const F& f) const {
    for (std::size_t r = 0; r < rules_.size(); ++r)
      if (copy.rules & bit(r)) f(rules_[r]);
  }
  bool meets_its_axis(const Copy& copy, std::size_t r) const {
    bool meets = false;
    for_rules(copy, [&](const CopyRule<D>& rule) { meets |= rule.axis == rules_[r].axis; });
    return meets;
  }
  Vec<D> position(Vec<D> x, const Copy& copy) const {
    for_rules(copy, [&](const CopyRule<D>& rule) { x = rule.position(x); });
    return x;
  }

  Rules rules_;
  std::vector<Copy> copies_, sorted_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
