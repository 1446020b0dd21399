// SPDX-License-Identifier: MIT
#include "run/body_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/text.h"
#include "freshet/error.h"
#include "freshet/units.h"

namespace freshet {
namespace {

/// Every number of a body, in the order of the columns.
template <class Body, class F> void each_number(Body& b, F f) {
  for (auto& x : b.position) f(x);
  for (auto& x : b.orientation) f(x);
  for (auto* part : {&b.velocity, &b.angular_velocity, &b.force, &b.torque})
    for (auto& x : *part) f(x);
}

/// The names of the columns, with the line end.
std::string header_with(const Units& units) {
  std::string line = "step,time [s],body,x [m],y [m],z [m],qx,qy,qz,qw";
  const auto add = [&line](const char* quantity, const char* unit) {
    for (const char axis : {'x', 'y', 'z'})
      line += fmt::format(",{} {} [{}]", quantity, axis, unit);
  };
  add("velocity", units.speed);
  add("angular velocity", units.angular_velocity);
  add("force", units.force);
  add("torque", units.torque);
  return line + "\n";
}

/// The names that older versions wrote in 2D.
std::string older_header(Units units) {
  units.torque = "N";
  return header_with(units);
}

/// Reads bodies.csv line by line.
class BodyRows {
 public:
  BodyRows(const Scene& scene, const std::string& file) : scene_(scene), file_(file) {}

  void header(std::string_view line) {
    columns_ = body_header(scene_);
    columns_.pop_back();  // the line end
    std::string older = older_header(units_in(scene_.dimension()));
    older.pop_back();
    if (line != columns_ && !(scene_.dimension() == 2 && line == older))
      fail(
          fmt::format("the first line does not name the columns of a table of bodies, which are "
                      "{}",
                      columns_));
  }
  void row(std::string_view line) {
    ++line_;
    const auto given = 1 + std::count(line.begin(), line.end(), ','),
               expected = 1 + std::count(columns_.begin(), columns_.end(), ',');
    if (given != expected)
      fail(fmt::format("this line has {} values, and the first line names {} columns", given,
                       expected));
    rest_ = line;
    column_ = 0;
    const double step = next("step");
    if (!(step >= 0 && double(std::int64_t(step)) == step))
      fail("the step is not a whole number from 0");
    const double time = next("time");
    const std::string name = scene_.body_name(rows_.size());
    if (take_cell() != name)
      fail(
          fmt::format("this row is not of the body \"{}\"; every time has a row for each body, "
                      "in the order of the scene",
                      name));
    if (rows_.empty() && !times_.empty() && time <= times_.rbegin()->first)
      fail(fmt::format("the time is {:g}, and must be greater than that before, {:g}", time,
                       times_.rbegin()->first));
    if (!rows_.empty() && time != time_)
      fail(
          fmt::format("the time is {:g}, and the row before is of the time {:g}, which lacks a row "
                      "of the body \"{}\"",
                      time, time_, name));
    time_ = time;
    BodyState body;
    each_number(body, [&](double& x) { x = next("value"); });
    const double norm2 = std::inner_product(body.orientation.begin(), body.orientation.end(),
                                            body.orientation.begin(), 0.0);
    if (!(std::abs(norm2 - 1) < 1e-3)) fail("qx, qy, qz and qw are not a unit quaternion");
    rows_.push_back(body);
    if (rows_.size() == scene_.body.size()) times_[time_] = std::exchange(rows_, {});
  }
  std::map<double, std::vector<BodyState>> take() { return std::move(times_); }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Error(Error::Kind::scene, fmt::format("{}:{}", file_, line_),
                why + "; put the table back as the run wrote it, or run the scene again");
  }
  std::string_view take_cell() {
    const auto end = std::min(rest_.find(','), rest_.size());
    const std::string_view cell = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++column_;
    return cell;
  }
  double next(const char* what) {
    const auto number = number_in(take_cell());
    if (!number || !(std::abs(*number) <= 3e38))  // the largest float; true for NaN as well
      fail(fmt::format("the {} in column {} is not a finite number", what, column_));
    return *number;
  }

  const Scene& scene_;
  const std::string& file_;
  std::string columns_;
  std::size_t line_ = 1, column_ = 0;
  std::string_view rest_;  // of the line
  double time_ = 0;
  std::vector<BodyState> rows_;  // of the time that is being read
  std::map<double, std::vector<BodyState>> times_;
};

}  // namespace

std::string body_header(const Scene& s) {
  return s.body.empty() ? "" : header_with(units_in(s.dimension()));
}

std::string body_lines(const Frame& frame, const Scene& scene) {
  std::string lines;
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    lines += fmt::format("{},{:.9g},{}", frame.step, frame.time, scene.body_name(k));
    each_number(frame.bodies[k],
                [&](double x) { lines += fmt::format(",{:.9g}", x == 0 ? 0.0 : x); });
    lines += '\n';
  }
  return lines;
}

std::map<double, std::vector<BodyState>> read_bodies(std::string_view table, const Scene& scene,
                                                     const std::string& file) {
  BodyRows rows(scene, file);
  table = table.substr(0, table.rfind('\n') + 1);  // a last line without its end is not complete
  rows.header(take_line(table));
  while (!table.empty()) rows.row(take_line(table));
  return rows.take();
}

}  // namespace freshet
