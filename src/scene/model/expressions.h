// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace freshet {

/// Whether this build reads functions: it does where it found muParser.
bool reads_expressions();

/// What is wrong with the first of these functions that cannot be read, with a remedy.
std::optional<std::string> fault_in(const std::vector<std::string>& functions);

/// Functions of place and time, one for each axis, in which x, y, z [m] and t [s] stand. All
/// without a fault.
class Expressions {
 public:
  explicit Expressions(const std::vector<std::string>& functions);
  Expressions(Expressions&&) noexcept;
  ~Expressions();

  bool empty() const;
  /// Whether x, y or z stands in one of them.
  bool depends_on_place() const;
  /// Whether one of them contains t.
  bool depends_on_time() const;
  /// Their values, as many as there are functions. Not for two threads at once.
  void operator()(const double (&x)[3], double t, double* values);

 private:
  friend std::optional<std::string> fault_in(const std::vector<std::string>&);
  struct Parsers;
  std::unique_ptr<Parsers> parsers_;
};

/// The error of the first of these values of functions that is NaN, or infinite as a Real, at a
/// finite place. The functions of `key` have no time if `t` is empty.
std::optional<std::string> not_finite(const std::vector<std::string>& functions,
                                      const std::string& key, const double (&x)[3],
                                      std::optional<double> t, const double* values);

}  // namespace freshet
