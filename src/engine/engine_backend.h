// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "backend/copies.h"
#include "freshet/report.h"
#include "solvers/backend.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// All that an engine asks of a backend: the verbs of the solvers, and the memory of the particles.
/// A new backend has these operations, and EngineOf needs no other.
template <class B, int D>
concept EngineBackend = Backend<B, D> &&
    requires(B b, Particles<D> p, Particles<D> wall, Field<Real> field, std::span<const int> gone,
             AnyTerm term, AnyFinish finish, typename Copies<D>::Rules rules, AnyMap map,
             double* sums) {
  /// Adds a set of n particles; the rules define its copies. Fields follow, zeroed.
  b.add_set(p, 1, rules);
  b.allocate(p, Keep::kept, field);
  /// Copies the kept fields of p, and puts them back.
  b.save("", p);
  b.restore("", p);
  /// Between steps: removes particles and appends new ones, zeroed.
  b.edit("", p, gone, 1);
  /// Between steps: moves a field to other memory and leaves it that of before.
  { b.keep(p, nullptr) } -> std::same_as<std::shared_ptr<const void>>;
  /// Calls finish(i, sum over the copies j that one rule makes).
  b.sum_pairs("", p, over_copies(0, p, term), finish);
  /// sums[g] += the map of each particle, by the group that it belongs to.
  b.sum_groups("", p, 1, map, sums);
  { b.timings() } -> std::convertible_to<const std::vector<VerbTiming>&>;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
