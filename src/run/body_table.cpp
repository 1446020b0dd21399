// SPDX-License-Identifier: MIT
#include "run/body_table.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace freshet {
namespace {

/// Every number of a body, in the order of the columns.
template <class Body, class F> void each_number(Body& b, F f) {
  for (auto& x : b.position) f(x);
  for (auto& x : b.orientation) f(x);
  for (auto* part : {&b.velocity, &b.angular_velocity, &b.force, &b.torque})
    for (auto& x : *part) f(x);
}

}  // namespace

std::string body_header(const Scene& s) {
  if (s.body.empty()) return "";
  const bool flat = s.dimension() == 2;
  const char *force = flat ? "N/m" : "N", *torque = flat ? "N" : "N m";
  std::string line = "step,time [s],body,x [m],y [m],z [m],qx,qy,qz,qw";
  for (const char* what : {"velocity", "angular velocity"})
    for (const char axis : {'x', 'y', 'z'})
      line += fmt::format(",{} {} [{}]", what, axis, what[0] == 'v' ? "m/s" : "rad/s");
  for (const char axis : {'x', 'y', 'z'}) line += fmt::format(",force {} [{}]", axis, force);
  for (const char axis : {'x', 'y', 'z'}) line += fmt::format(",torque {} [{}]", axis, torque);
  return line + "\n";
}

std::string body_lines(const Simulation& s) {
  std::string lines;
  const std::vector<BodyState> bodies = s.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    lines += fmt::format("{},{:.9g},{}", s.steps_done(), s.time(), s.scene().body_name(k));
    each_number(bodies[k], [&](double x) { lines += fmt::format(",{:.9g}", x == 0 ? 0.0 : x); });
    lines += '\n';
  }
  return lines;
}

std::map<std::int64_t, std::vector<BodyState>> read_bodies(std::string_view table,
                                                           const Scene& scene) {
  std::map<std::int64_t, std::vector<BodyState>> steps;
  std::istringstream in{std::string(table)};
  std::string line, cell;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::getline(cells, cell, ',');
    auto& bodies = steps[std::strtoll(cell.c_str(), nullptr, 10)];
    std::getline(cells, cell, ',');  // time
    std::getline(cells, cell, ',');  // name: the order tells
    BodyState body;
    each_number(body, [&](double& x) {
      std::getline(cells, cell, ',');
      x = std::strtod(cell.c_str(), nullptr);
    });
    bodies.push_back(body);
  }
  std::erase_if(steps, [&](const auto& step) { return step.second.size() != scene.body.size(); });
  return steps;
}

}  // namespace freshet
