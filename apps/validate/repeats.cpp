// SPDX-License-Identifier: MIT
#include "validate/repeats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace freshet {
namespace {

/// A result that could not be measured is the worst.
double rank_of(const ValidationResult& r) {
  return std::isnan(r.value) ? std::numeric_limits<double>::infinity() : r.value;
}

ValidationResult median_result(const std::vector<ValidationRun>& repeats, std::size_t k) {
  std::vector<const ValidationResult*> sorted;
  for (const ValidationRun& r : repeats) sorted.push_back(&r.results[k]);
  std::sort(sorted.begin(), sorted.end(),
            [](auto* a, auto* b) { return rank_of(*a) < rank_of(*b); });
  ValidationResult median = *sorted[sorted.size() / 2];
  for (const ValidationResult* r : sorted) median.repeats.push_back(r->value);
  return median;
}

}  // namespace

std::vector<Override> changed_start(const Scene& scene, int repeat) {
  if (repeat == 0) return {};
  std::vector<Override> all{{"particles.seed", fmt::format("{}", scene.particles.seed + repeat)}};
  if (scene.particles.jitter == 0) all.emplace_back("particles.jitter", "1e-4");
  return all;
}

ValidationRun median_of(std::vector<ValidationRun> repeats) {
  for (ValidationRun& r : repeats)
    if (!r.error.empty()) return std::move(r);
  ValidationRun median = repeats.front();
  if (repeats.size() == 1) return median;
  median.seconds = 0;
  for (const ValidationRun& r : repeats) median.seconds += r.seconds;
  for (std::size_t k = 0; k < median.results.size(); ++k)
    median.results[k] = median_result(repeats, k);
  return median;
}

std::string range_of(const ValidationResult& r) {
  return r.repeats.empty() ? ""
                           : fmt::format("{:.3g} to {:.3g}", r.repeats.front(), r.repeats.back());
}

}  // namespace freshet
