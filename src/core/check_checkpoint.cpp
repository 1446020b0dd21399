// SPDX-License-Identifier: MIT
#include "core/check_checkpoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

#include "freshet/error.h"
#include "freshet/frame.h"

namespace freshet {
namespace {

using Array = Checkpoint::Array;
using Number = StateArray::Number;

constexpr int most_components = 19;  // of a BodyState
constexpr std::size_t body_numbers = sizeof(BodyState) / sizeof(double), orientation_at = 3;

void check_counter(const char* what, std::int64_t n) {
  if (n < 0 || n > most_counted)
    fail_for_checkpoint(std::string(what) + " is " + std::to_string(n) + ", not 0 to 2^53");
}

void check_time(const char* what, double seconds) {
  if (!(seconds >= 0 && std::isfinite(seconds)))
    fail_for_checkpoint(std::string(what) + " is " + std::to_string(seconds) +
                        ", not a finite time from 0 on");
}

/// "SET/FIELD" of letters, digits and underscores.
bool is_name(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  const auto slash = name.find('/');
  return slash != 0 && slash != name.npos && slash + 1 < name.size() &&
         std::all_of(name.begin(), name.begin() + std::ptrdiff_t(slash), plain) &&
         std::all_of(name.begin() + std::ptrdiff_t(slash) + 1, name.end(), plain);
}

/// Whether NaN and infinity are errors in this array. Other fields follow from these.
bool must_be_finite(std::string_view name) {
  return name.starts_with("bodies/") || name.starts_with("flows/") ||
         name.starts_with("whitewater") || name.ends_with("/x") || name.ends_with("/v") ||
         name == "fluid/x_counted" || name == "fluid/bounced";
}

template <class T> void check_finite(const Array& a) {
  for (std::size_t k = 0; k < a.bytes.size() / sizeof(T); ++k)
    if (!std::isfinite(number_at<T>(a, k)))
      fail_for_checkpoint(a.name + " has a number that is NaN or infinite");
}

void check_array(const Array& a) {
  if (!is_name(a.name)) fail_for_checkpoint("an array is not named SET/FIELD");
  if (a.count < 0 || a.count > std::numeric_limits<int>::max() || a.components < 1 ||
      a.components > most_components || int(a.number) < 0 || a.number > Number::float64)
    fail_for_checkpoint(a.name + " has " + std::to_string(a.count) + " entries of " +
                        std::to_string(a.components) +
                        " numbers; 0 to 2^31 of 1 to 19 are allowed");
  if (a.bytes.size() != a.StateArray::bytes())
    fail_for_checkpoint(a.name + " has " + std::to_string(a.bytes.size()) + " bytes, not " +
                        std::to_string(a.StateArray::bytes()));
  if (!must_be_finite(a.name)) return;
  if (a.number == Number::float32) check_finite<float>(a);
  if (a.number == Number::float64) check_finite<double>(a);
}

void check_ids(const Array& a) {
  if (a.number != Number::uint64 || a.components != 1)
    fail_for_checkpoint(a.name + " must be one 64-bit number per particle");
  std::vector<std::uint64_t> ids(std::size_t(a.count));
  std::copy(a.bytes.begin(), a.bytes.end(), reinterpret_cast<std::byte*>(ids.data()));
  std::sort(ids.begin(), ids.end());
  if (std::adjacent_find(ids.begin(), ids.end()) != ids.end())
    fail_for_checkpoint("two particles have one id");
  if (!ids.empty() && ids.back() >= std::uint64_t(most_counted))
    fail_for_checkpoint("a particle has an id of 2^53 or more");
}

void check_bodies(const Array& a) {
  if (a.number != Number::float64 || a.components != 1 || a.count % body_numbers != 0)
    fail_for_checkpoint(a.name + " must be 19 numbers per body");
  for (std::size_t body = 0; body < std::size_t(a.count); body += body_numbers) {
    double norm2 = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const double q = number_at<double>(a, body + orientation_at + k);
      norm2 += q * q;
    }
    if (!(std::abs(norm2 - 1) < 1e-3))
      fail_for_checkpoint("the orientation of a body is not a unit quaternion");
  }
}

void check_watch(const WatchRecord& w) {
  if (w.warnings.size() != w.tracks.size())
    fail_for_checkpoint("it has " + std::to_string(w.warnings.size()) +
                        " warnings and the steps of " + std::to_string(w.tracks.size()));
  for (const Warning& warning : w.warnings) {
    for (const std::int64_t step : {warning.first_step, warning.last_step, warning.worst_step})
      check_counter("a step of a warning", step);
    check_counter("the number of health checks of a warning", warning.looks);
    check_time("the time of a warning", warning.first_time);
  }
  for (const WatchRecord::Track& track : w.tracks)
    check_counter("the number of steps of a warning", track.steps);
  check_counter("the number of checked steps", w.steps_watched);
  check_counter("the first checked step", w.first_step);
  for (const std::int64_t n : w.not_converged) check_counter("a number of solves", n);
}

void check_steps(const Checkpoint& c) {
  check_counter("the number of steps", c.steps);
  check_time("the time", c.time);
  check_time("the last time step", c.time_steps.last);
  check_time("the shortest time step", c.time_steps.min);
  check_time("the longest time step", c.time_steps.max);
  check_counter("the number of halved steps", c.time_steps.retried);
  for (const auto& [bound, steps] : c.time_steps.ruled)
    check_counter("the number of steps of a bound", steps);
  for (const SolveStatistics& s : c.solves)
    for (const std::int64_t n :
         {s.solves, s.iterations, s.most_iterations, s.not_converged, s.last_iterations})
      check_counter("a number of solves or iterations", n);
}

}  // namespace

void fail_for_checkpoint(const std::string& why) {
  throw Error(Error::Kind::run, "",
              "this checkpoint is invalid: " + why + "; use another checkpoint");
}

void check_checkpoint(const Checkpoint& c) {
  check_steps(c);
  check_watch(c.watch);
  std::set<std::string_view> names;
  for (const Array& a : c.arrays) {
    check_array(a);
    if (!names.insert(a.name).second) fail_for_checkpoint(a.name + " is there twice");
    if (a.name == "fluid/id") check_ids(a);
    if (a.name == "bodies/state") check_bodies(a);
  }
}

}  // namespace freshet
