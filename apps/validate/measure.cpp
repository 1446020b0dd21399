// SPDX-License-Identifier: MIT
#include "validate/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "freshet/error.h"
#include "render/axis.h"
#include "render/chart.h"
#include "validate/formula.h"

namespace freshet {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(const std::string& place, const std::string& why) {
  throw Error(Error::Kind::scene, place, why);
}
/// The run has left nothing to measure.
[[noreturn]] void miss(const std::string& place, const std::string& why) {
  throw Error(Error::Kind::run, place, why);
}

const std::vector<double>& times_of(const Table& table, const std::string& place) {
  const Column* time = table.find("time");
  if (!time) refuse(place, "a table has no time column; `beside` and `since` need one");
  return time->numbers;
}

/// Adds the columns that another table alone has, as they are at this one's times.
void put_beside(Table& table, const Table& other, const std::string& place) {
  const std::vector<double> times = times_of(table, place);
  for (const Column& c : other.columns) {
    if (c.of_words() || table.find(c.name)) continue;
    Column added{c.name, c.unit, {}, {}};
    const Curve curve{times_of(other, place), c.numbers};
    for (const double t : times) added.numbers.push_back(at(curve, t));
    table.columns.push_back(std::move(added));
  }
}

/// Counts a table's time from where a formula first holds in another.
void count_from(Table& table, const Table& other, const std::string& when,
                const std::string& place) {
  const auto holds = evaluate(when, other, place);
  const auto first = std::find_if(holds.begin(), holds.end(), [](double h) { return h != 0; });
  if (first == holds.end()) miss(place, fmt::format("{} never holds; is the run too short?", when));
  const double start = times_of(other, place)[std::size_t(first - holds.begin())];
  for (Column& c : table.columns)
    if (c.name == "time")
      for (double& t : c.numbers) t -= start;
}

/// What a table tells by two formulas: the rows that count.
Curve curve_of(const Table& table, const std::string& x, const std::string& y,
               const std::string& when, const std::string& place) {
  const auto xs = evaluate(x, table, place), ys = evaluate(y, table, place);
  const auto counts =
      when.empty() ? std::vector<double>(table.rows, 1) : evaluate(when, table, place);
  Curve curve;
  for (std::size_t i = 0; i < table.rows; ++i) {
    if (counts[i] == 0 || !std::isfinite(xs[i]) || !std::isfinite(ys[i])) continue;
    curve.x.push_back(xs[i]);
    curve.y.push_back(ys[i]);
  }
  return curve;
}

/// Shifts x so that y first reaches a value at the same x as the other curve.
void align(Curve& curve, const Curve& other, double value, const std::string& place) {
  const auto reaches = [&](const Curve& c) {
    for (std::size_t k = 1; k < c.x.size(); ++k)
      if (c.y[k - 1] < value && c.y[k] >= value)
        return c.x[k - 1] + (value - c.y[k - 1]) / (c.y[k] - c.y[k - 1]) * (c.x[k] - c.x[k - 1]);
    miss(place, fmt::format("both curves must reach y = {}, where they are aligned", value));
  };
  const double shift = reaches(other) - reaches(curve);
  for (double& x : curve.x) x += shift;
}

void cut(Curve& curve, const ValidationMeasure& m) {
  Curve kept;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    if (m.from && curve.x[k] < *m.from) continue;
    if (m.to && curve.x[k] > *m.to) continue;
    kept.x.push_back(curve.x[k]);
    kept.y.push_back(curve.y[k]);
  }
  curve = std::move(kept);
}

double mean(const std::vector<double>& y) {
  return std::accumulate(y.begin(), y.end(), 0.0) / double(y.size());
}

struct Line {
  double slope, offset;
};
Line least_squares(const std::vector<double>& x, const std::vector<double>& y) {
  const double mx = mean(x), my = mean(y);
  double xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xx += (x[k] - mx) * (x[k] - mx);
    xy += (x[k] - mx) * (y[k] - my);
  }
  return {xy / xx, my - xy / xx * mx};
}

double scatter(const Curve& c) {
  const Line line = least_squares(c.x, c.y);
  const double my = mean(c.y);
  double left = 0, all = 0;
  for (std::size_t k = 0; k < c.x.size(); ++k) {
    left += std::pow(c.y[k] - line.offset - line.slope * c.x[k], 2);
    all += std::pow(c.y[k] - my, 2);
  }
  return left / all;
}

/// Where y goes up through its mean: the x there, and the number of the first point after it.
struct Period {
  double x;
  std::size_t first;
};
std::vector<Period> periods(const Curve& c) {
  const double middle = mean(c.y);
  std::vector<Period> ups;
  for (std::size_t k = 1; k < c.y.size(); ++k)
    if (c.y[k - 1] < middle && c.y[k] >= middle)
      ups.push_back(
          {c.x[k - 1] + (middle - c.y[k - 1]) / (c.y[k] - c.y[k - 1]) * (c.x[k] - c.x[k - 1]), k});
  return ups;
}

double period(const Curve& c) {
  const auto ups = periods(c);
  if (ups.size() < 2) return no_number;
  return (ups.back().x - ups.front().x) / double(ups.size() - 1);
}

/// The greatest y of each whole period, at its x.
Curve crests(const Curve& c) {
  Curve tops;
  const auto ups = periods(c);
  for (std::size_t n = 1; n < ups.size(); ++n) {
    const auto top = std::max_element(c.y.begin() + std::ptrdiff_t(ups[n - 1].first),
                                      c.y.begin() + std::ptrdiff_t(ups[n].first));
    tops.x.push_back(c.x[std::size_t(top - c.y.begin())]);
    tops.y.push_back(*top);
  }
  return tops;
}

double height(const Curve& c) {
  Curve upside_down = c;
  for (double& y : upside_down.y) y = -y;
  const Curve tops = crests(c), bottoms = crests(upside_down);
  return tops.y.empty() || bottoms.y.empty() ? no_number : mean(tops.y) + mean(bottoms.y);
}

double rate(const Curve& c) {
  std::vector<double> logs;
  for (const double y : c.y) logs.push_back(std::log(y));
  return least_squares(c.x, logs).slope;
}

/// The title of an axis: the name and unit of a column, of its negative too, or else the formula.
std::string title_of(const std::string& formula, const Table& table) {
  const bool negative = formula.starts_with('-');
  for (const Column& c : table.columns)
    if (variable_of(c.name) == formula.substr(negative))
      return axis_title((negative ? "−" : "") + c.name, c.unit);
  return formula;
}

std::string plot_of(const ValidationCase& c, const ValidationMeasure& m, const Table& table,
                    const Curve& curve, const Curve& expected) {
  Chart chart;
  chart.title = fmt::format("{}: {}", c.name, m.name);
  Panel panel{"", title_of(m.x, table), title_of(m.y, table), {}};
  const bool points = !m.reference.empty() && m.reference != "finest";
  panel.series.push_back({"simulation", curve.x, curve.y, Series::Style::solid, -1});
  if (!expected.x.empty())
    panel.series.push_back({points ? "reference" : "expected", expected.x, expected.y,
                            points ? Series::Style::points : Series::Style::dashed, -1});
  chart.panels.push_back(std::move(panel));
  return chart_svg(chart);
}

/// A statistic as a line beside the curve: a level, or a slope through its middle.
Curve line_of(const std::string& statistic, const Curve& curve, double value) {
  const auto [first, last] = std::minmax_element(curve.x.begin(), curve.x.end());
  if (statistic == "mean" || statistic == "last" || statistic == "min" || statistic == "max")
    return {{*first, *last}, {value, value}};
  if (statistic != "slope") return {};
  const double mx = mean(curve.x), my = mean(curve.y);
  return {{*first, *last}, {my + value * (*first - mx), my + value * (*last - mx)}};
}

/// What is expected at the places of the curve: a file's points, or a formula in x.
Curve expected_of(const ValidationCase& c, const ValidationMeasure& m, const Curve& curve,
                  const std::filesystem::path& finest, const std::string& place) {
  if (m.reference == "finest")
    return curve_of(read_table(finest / m.table), m.x, m.y, m.when, place);
  if (!m.reference.empty())
    return curve_of(read_table(c.folder / m.reference), m.rx, m.ry, "", place);
  if (m.expected.empty()) return {};
  return {curve.x, evaluate(m.expected, "x", curve.x, place)};
}

}  // namespace

double at(const Curve& c, double x) {
  const auto next = std::lower_bound(c.x.begin(), c.x.end(), x);
  if (next == c.x.end() || (next == c.x.begin() && *next > x)) return no_number;
  const auto k = std::size_t(next - c.x.begin());
  if (c.x[k] == x) return c.y[k];
  return c.y[k - 1] + (x - c.x[k - 1]) / (c.x[k] - c.x[k - 1]) * (c.y[k] - c.y[k - 1]);
}

double statistic(const std::string& word, const Curve& c, const std::string& place) {
  if (c.y.empty()) miss(place, "no rows to measure in the table of the run; is the run too short?");
  if (word == "mean") return mean(c.y);
  if (word == "max") return *std::max_element(c.y.begin(), c.y.end());
  if (word == "min") return *std::min_element(c.y.begin(), c.y.end());
  if (word == "last") return c.y.back();
  if (word == "slope") return least_squares(c.x, c.y).slope;
  if (word == "scatter") return scatter(c);
  if (word == "period") return period(c);
  if (word == "height") return height(c);
  if (word == "rate") return rate(c);
  if (word == "decay") return rate(crests(c));
  refuse(place,
         fmt::format("unknown statistic \"{}\"; choose mean, min, max, last, slope, scatter, "
                     "rate, decay, period or height",
                     word));
}

double difference(const std::string& norm, const Curve& curve, const Curve& expected,
                  const Curve& points, std::optional<double> scale, const std::string& place) {
  double most = 0, sum = 0, squares = 0, n = 0;
  for (const double x : points.x) {
    const double should = at(expected, x), is = at(curve, x);
    if (std::isnan(should) || std::isnan(is)) continue;
    const double d = std::abs(is - should) / scale.value_or(std::abs(should));
    most = d > most || std::isnan(d) ? d : most;
    sum += d;
    squares += d * d;
    ++n;
  }
  if (n == 0)
    miss(place, "the run and the expected curve have no x in common; is the run too short?");
  if (norm == "max") return most;
  if (norm == "mean") return sum / n;
  if (norm == "rms") return std::sqrt(squares / n);
  refuse(place, fmt::format("unknown norm \"{}\"; choose max, mean or rms", norm));
}

ValidationResult measure(const ValidationCase& c, const ValidationMeasure& m, Table table,
                         const std::filesystem::path& run, const std::filesystem::path& finest) {
  const std::string place = (c.folder / "case.toml").string() + ": measure " + m.name;
  if (!m.beside.empty()) put_beside(table, read_table(run / m.beside), place);
  if (!m.since.empty()) count_from(table, read_table(run / m.since), m.since_when, place);
  Curve curve = curve_of(table, m.x, m.y, m.when, place);
  ValidationResult r;
  r.name = m.name;
  r.bound = m.bound;
  r.reason = m.reason;
  if (!m.statistic.empty()) {
    cut(curve, m);
    r.measured = statistic(m.statistic, curve, place);
    r.value = *r.measured;
    Curve expected;
    if (!m.expected.empty()) {
      const double should = evaluate(m.expected, "x", {0.0}, place)[0];
      r.value = std::abs(*r.measured - should) / m.scale.value_or(std::abs(should));
      expected = line_of(m.statistic, curve, should);
    }
    if (m.x != m.y) r.plot = plot_of(c, m, table, curve, expected);
  } else {
    Curve expected = expected_of(c, m, curve, finest, place);
    if (m.align) align(curve, expected, *m.align, place);
    cut(curve, m);
    // Of measured points each counts once, however finely the simulation was looked at.
    const bool points = !m.reference.empty() && m.reference != "finest";
    if (points) cut(expected, m);
    r.value = difference(m.norm, curve, expected, points ? expected : curve, m.scale, place);
    r.plot = plot_of(c, m, table, curve, expected);
  }
  r.passed = !m.bound || r.value <= *m.bound;
  return r;
}

}  // namespace freshet
