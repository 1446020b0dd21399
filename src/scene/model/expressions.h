// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace freshet {

/// Whether this build reads functions, which needs muParser.
bool reads_expressions();

/// The error of the first invalid function, with a remedy; empty if all are valid. `variables` are
/// the letters of those that the functions may have, such as "xz"; if empty: the axes, one per
/// function, and t.
std::optional<std::string> fault_in(const std::vector<std::string>& functions,
                                    std::string_view variables = {});

/// Functions of x, y, z [m] and t [s], one per axis. All must be valid: fault_in() finds no error.
class Expressions {
 public:
  explicit Expressions(const std::vector<std::string>& functions, std::string_view variables = {});
  Expressions(Expressions&&) noexcept;
  ~Expressions();

  bool empty() const;
  /// Whether one of them depends on x, y or z.
  bool depends_on_place() const;
  /// Whether one of them depends on t.
  bool depends_on_time() const;
  /// Writes the value of each function to `values`. Not thread-safe.
  void operator()(const double (&x)[3], double t, double* values);

 private:
  friend std::optional<std::string> fault_in(const std::vector<std::string>&, std::string_view);
  struct Parsers;
  std::unique_ptr<Parsers> parsers_;
};

/// The error of the first of these values of functions that is NaN, or infinite as a Real, at a
/// finite place. The functions of `key` have no time if `t` is empty. There are `dimension`
/// coordinates, or if it is 0 as many as functions.
std::optional<std::string> not_finite(const std::vector<std::string>& functions,
                                      const std::string& key, const double (&x)[3],
                                      std::optional<double> t, const double* values,
                                      int dimension = 0);

}  // namespace freshet
