// SPDX-License-Identifier: MIT
#include "sim/check_restored.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/check_checkpoint.h"
#include "engine/inlet_clock.h"
#include "scene/model/openings.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

const Checkpoint::Array* array_of(const Checkpoint& c, const std::string& name) {
  const auto it = std::find_if(c.arrays.begin(), c.arrays.end(),
                               [&](const StateArray& a) { return a.name == name; });
  return it == c.arrays.end() ? nullptr : &*it;
}

/// Fails if a number of this array, if there is one, is not an index below `end`.
void check_indices(const Checkpoint& c, const char* name, std::int64_t end) {
  const Checkpoint::Array* a = array_of(c, name);
  for (std::int64_t k = 0; a && k < a->count; ++k) {
    const auto index = number_at<std::int32_t>(*a, std::size_t(k));
    if (index < 0 || index >= end)
      fail_for_checkpoint(fmt::format("{} has {}, not 0 to {}", name, index, end - 1));
  }
}

/// Fails if the clock of an inlet is not one of this time: it would not end, or reach beyond its
/// layers.
void check_inlet(const Checkpoint& c, std::size_t k, InletClock clock) {
  const Checkpoint::Array* layers = array_of(c, fmt::format("flows/inlet_{}_layers", k));
  if (!layers || layers->count != 3) return;
  const auto born = number_at<std::uint64_t>(*layers, 0),
             through = number_at<std::uint64_t>(*layers, 1),
             waiting = number_at<std::uint64_t>(*layers, 2);
  const auto most = std::uint64_t(most_counted);
  if (born > most || through > born || born - through > std::uint64_t(clock.slots()) ||
      waiting > most)
    fail_for_checkpoint(
        fmt::format("inlet {} has {} layers, {} of them past its opening, and {} "
                    "waiting particles",
                    k, born, through, waiting));
  const Checkpoint::Array* crossings = array_of(c, fmt::format("flows/inlet_{}_crossings", k));
  if (!crossings || std::size_t(crossings->count) != clock.crossings().size()) return;
  clock.state = {born, through, waiting};
  for (std::size_t slot = 0; slot < clock.crossings().size(); ++slot)
    clock.crossings()[slot] = number_at<double>(*crossings, slot);
  const double overdue = c.time > clock.plan().start ? clock.overdue(c.time) : 0;
  if (clock.plan().outlet < 0 && overdue > 1)
    fail_for_checkpoint(fmt::format("inlet {} has {} layers, and {} have passed it by {} s", k,
                                    born, double(born) + std::floor(overdue) + 1, c.time));
}

/// Fails if the next id of a set is not above all of its ids.
void check_ids(const Checkpoint& c, const char* next_id, const char* ids_of_set) {
  const Checkpoint::Array *next = array_of(c, next_id), *ids = array_of(c, ids_of_set);
  if (!next || next->count != 1) return;
  const auto end = number_at<std::uint64_t>(*next, 0);
  std::uint64_t least = 0;
  for (std::int64_t k = 0; ids && k < ids->count; ++k)
    least = std::max(least, number_at<std::uint64_t>(*ids, std::size_t(k)) + 1);
  if (end < least || end > std::uint64_t(most_counted))
    fail_for_checkpoint(fmt::format("the next id is {}, not {} to 2^53", end, least));
}

/// Counts of outlets are not negative; counters also count backwards.
void check_counts(const Checkpoint& c, std::size_t outlets) {
  const Checkpoint::Array* counts = array_of(c, "flows/counts");
  for (std::size_t k = 0; counts && k < std::size_t(counts->count); ++k) {
    const auto n = number_at<std::int64_t>(*counts, k);
    if (n > most_counted || n < (k < outlets ? 0 : -most_counted))
      fail_for_checkpoint(fmt::format("a count of an outlet or counter is {}", n));
  }
}

/// Fails if positions are relative to another origin than those of the scene.
void check_origin(const Checkpoint& c, const Scene& scene) {
  const Checkpoint::Array* origin = array_of(c, "fluid/origin");
  const Triple here = origin_of(scene);
  for (std::size_t k = 0; origin && k < here.size() && k < std::size_t(origin->count); ++k)
    if (number_at<double>(*origin, k) != here[k])
      fail_for_checkpoint("its positions are relative to another origin");
}

}  // namespace

void check_restored(const Checkpoint& c, const Scene& scene) {
  check_indices(c, "fluid/kind", std::int64_t(scene.liquids().size()));
  std::int64_t held = 0;
  for (std::size_t k = 0; k < scene.inlet.size(); ++k) {
    const InletClock clock(inlet_plan(scene, scene.inlet[k]));
    held += std::int64_t(clock.slots()) * std::int64_t(clock.plan().particles());
    check_inlet(c, k, clock);
  }
  check_indices(c, "fluid/held", held + 1);
  check_ids(c, "flows/next_id", "fluid/id");
  check_indices(c, "whitewater/kind", 3);
  check_ids(c, "whitewater_clock/next_id", "whitewater/id");
  if (const auto* elapsed = array_of(c, "whitewater_clock/elapsed"))
    if (const double since = elapsed->count == 1 ? number_at<double>(*elapsed, 0) : 0;
        !(since >= 0 && since <= c.time * (1 + 1e-6)))
      fail_for_checkpoint(fmt::format(
          "the time since the whitewater was advanced is {} s, not 0 to {}", since, c.time));
  check_counts(c, scene.outlet.size());
  check_origin(c, scene);
}

}  // namespace freshet
