// SPDX-License-Identifier: MIT
#include "scene/model/body_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/input_file.h"
#include "core/table_text.h"
#include "scene/model/body_shape.h"
#include "scene/model/expressions.h"

namespace freshet {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double little = 1e-4;  // [s]: step of the finite differences

constexpr InputFile path_file{.noun = "motion file",
                              .remedy = "name a CSV file of times and places"};

/// The index of a column among time, x, y, z and angle. A unit after the name is ignored.
std::optional<std::size_t> column_of(std::string_view name) {
  static constexpr std::string_view names[] = {"time", "x", "y", "z", "angle"};
  const std::string plain = plain_name(name);
  if (plain == "t") return 0;
  const auto* it = std::find(std::begin(names), std::end(names), plain);
  if (it == std::end(names)) return {};
  return std::size_t(it - names);
}

class PathReader {
 public:
  PathReader(const std::filesystem::path& file, int dimension)
      : file_(file.string()), dimension_(std::size_t(dimension)) {}

  std::vector<Scene::Body::Key> read() {
    const std::string bytes = read_input(file_, path_file);
    TableText table(bytes);
    line_ = table.line();
    auto row = table.next();
    if (!table.names().empty()) read_names(table.names());
    else if (!row.empty()) columns_without_names(row.size());
    for (; !row.empty(); row = table.next()) {
      line_ = table.line();
      read_row(row, table);
      if (keys_.size() > 1000000) fail("has more than a million key frames; remove some");
    }
    if (keys_.size() < 2) fail("has fewer than two key frames; write one per line");
    return std::move(keys_);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    const bool whole = line_ == 0 || keys_.size() < 2;
    throw Error(Error::Kind::scene,
                whole && line_ == 0 ? file_ : fmt::format("{}:{}", file_, line_), why);
  }
  /// Messages do not quote the file: it may be any file, and none of its contents may leak.
  void read_names(const std::vector<std::string_view>& names) {
    for (const std::string_view cell : names) {
      const auto column = column_of(cell);
      if (!column || (*column == 3 && dimension_ == 2))
        fail(
            fmt::format("the name of column {} is unknown; the first line may name time, x, y{} "
                        "and angle, as in \"time,x,y\"; remove the column or rename it",
                        columns_.size() + 1, dimension_ == 3 ? ", z" : ""));
      columns_.push_back(*column);
    }
    if (std::find(columns_.begin(), columns_.end(), 0u) == columns_.end())
      fail("the first line has no column time; name the columns there, including time");
  }
  /// The columns of a file that begins with numbers.
  void columns_without_names(std::size_t count) {
    if (count != dimension_ + 1 && count != dimension_ + 2)
      fail(fmt::format(
          "the first line has {} number{} and no names; name the columns there, such as "
          "time,x,angle",
          count, count == 1 ? "" : "s"));
    for (std::size_t k = 0; k <= dimension_; ++k) columns_.push_back(k);
    if (count == dimension_ + 2) columns_.push_back(4);
  }
  void read_row(const std::vector<std::string_view>& cells, const TableText& table) {
    if (cells.size() != columns_.size())
      fail(fmt::format(
          "this line has {} numbers, and the first line names {} columns; write one number "
          "per column",
          cells.size(), columns_.size()));
    double value[5] = {};
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double v = value[columns_[k]] = table.number(cells[k]).value_or(NAN);
      if (!std::isfinite(v))
        fail(
            fmt::format("the value in column {} is not a finite number; write numbers like 0.5 "
                        "or 1e-3",
                        k + 1));
    }
    if (!keys_.empty() && !(value[0] > keys_.back().time))
      fail(fmt::format(
          "the time {:g} s is not after that of the previous line, {:g} s; sort the lines "
          "by time",
          value[0], keys_.back().time));
    keys_.push_back({value[0], Vector(value + 1, value + 1 + dimension_), value[4]});
  }

  std::string file_;
  std::size_t dimension_;
  std::size_t line_ = 0;
  std::vector<std::size_t> columns_;
  std::vector<Scene::Body::Key> keys_;
};

}  // namespace

std::vector<Scene::Body::Key> read_body_path(const std::filesystem::path& file, int dimension) {
  return PathReader(file, dimension).read();
}

struct PrescribedMotion::Functions {
  Expressions position, angle;
};

PrescribedMotion::PrescribedMotion(const Scene::Body& b, int dimension)
    : linear_(b.interpolation == Interpolation::linear) {
  if (!b.position.empty() || !b.angle.empty()) {
    functions_ = std::make_unique<Functions>(Functions{
        Expressions(b.position),
        Expressions(b.angle.empty() ? std::vector<std::string>() : std::vector{b.angle})});
    return;
  }
  for (const auto& key : b.path.empty() ? b.key : read_body_path(b.path, dimension)) {
    times_.push_back(key.time);
    std::array<double, 4> v{};
    std::copy(key.translation.begin(), key.translation.end(), v.begin());
    v[3] = key.angle * degree;
    values_.push_back(v);
  }
  slopes_.resize(values_.size());
  for (std::size_t k = 1; k + 1 < values_.size(); ++k)
    for (std::size_t d = 0; d < 4; ++d) {
      const double before = times_[k] - times_[k - 1], after = times_[k + 1] - times_[k];
      const double left = (values_[k][d] - values_[k - 1][d]) / before,
                   right = (values_[k + 1][d] - values_[k][d]) / after;
      slopes_[k][d] = (after * left + before * right) / (before + after);
    }
}
PrescribedMotion::PrescribedMotion(PrescribedMotion&&) noexcept = default;
PrescribedMotion::~PrescribedMotion() = default;

std::array<double, 4> PrescribedMotion::functions_at(double time) const {
  std::array<double, 4> v{};
  const double nowhere[3] = {};
  if (!functions_->position.empty()) functions_->position(nowhere, time, v.data());
  if (!functions_->angle.empty()) functions_->angle(nowhere, time, &v[3]);
  v[3] *= degree;
  return v;
}

Displacement PrescribedMotion::at(double time) const {
  if (!functions_) return between_keys(time);
  Displacement d;
  d.value = functions_at(time);
  const bool start = time < 2 * little;  // a function may be undefined before t = 0
  const double weights[2][5] = {{1, -8, 0, 8, -1}, {-25, 48, -36, 16, -3}};
  for (int k = 0; k < 5; ++k) {
    const auto v = functions_at(time + (start ? k : k - 2) * little);
    for (std::size_t j = 0; j < 4; ++j) d.rate[j] += weights[start][k] * v[j] / (12 * little);
  }
  return d;
}

Displacement PrescribedMotion::between_keys(double time) const {
  Displacement d;
  if (times_.empty()) return d;
  const auto next = std::upper_bound(times_.begin(), times_.end(), time);
  if (next == times_.begin()) d.value = values_.front();
  if (next == times_.end()) d.value = values_.back();
  if (next == times_.begin() || next == times_.end()) return d;
  const auto k = std::size_t(next - times_.begin()) - 1;
  const double span = times_[k + 1] - times_[k], s = (time - times_[k]) / span;
  for (std::size_t j = 0; j < 4; ++j) {
    const double a = values_[k][j], b = values_[k + 1][j], rise = (b - a) / span;
    if (linear_) {
      d.value[j] = a + s * (b - a);
      d.rate[j] = rise;
      continue;
    }
    const double m = slopes_[k][j], n = slopes_[k + 1][j];  // Hermite's cubic
    d.value[j] = a + s * span * (m + s * (3 * rise - 2 * m - n + s * (m + n - 2 * rise)));
    d.rate[j] = m + s * (2 * (3 * rise - 2 * m - n) + 3 * s * (m + n - 2 * rise));
  }
  return d;
}

double fastest_point(const Scene::Body& b, int dimension, double end) {
  const PrescribedMotion motion(b, dimension);
  const BodyShape shape = body_shape(b);
  double arm = shape.reach;
  if (!b.pivot.empty()) {
    double off2 = 0;
    const double center[] = {shape.center.x, shape.center.y, shape.center.z};
    for (std::size_t d = 0; d < b.pivot.size(); ++d) off2 += std::pow(b.pivot[d] - center[d], 2);
    arm += std::sqrt(off2);
  }
  double most = 0;
  for (int k = 0; k <= 1000; ++k) {
    const auto rate = motion.at(end * k / 1000).rate;
    most = std::max(most, std::hypot(rate[0], rate[1], rate[2]) + arm * std::abs(rate[3]));
  }
  return most;
}

}  // namespace freshet
