// SPDX-License-Identifier: MIT
#include "run/measured_tables.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "core/text.h"
#include "run/observables.h"
#include "run/table.h"

namespace freshet {
namespace {

std::string name_of_probe(const Scene& scene, std::size_t k) {
  return std::filesystem::path(probe_file(scene, k)).stem().string();
}

std::string cell(double value) {
  return std::isnan(value) ? ",nan" : fmt::format(",{:.9g}", value);
}

}  // namespace

MeasuredTables::MeasuredTables(const Scene& scene, const Probes& probes, bool forces)
    : scene_(scene), probes_(probes), table_(header(forces)) {
  for (std::size_t k = 0; k < probes.size(); ++k)
    if (has_places(k)) of_probes_[name_of_probe(scene, k)] = probes.header(k);
}

bool MeasuredTables::has_places(std::size_t k) const {
  const ProbeKind kind = scene_.probe[k].kind;
  return kind == ProbeKind::line || kind == ProbeKind::plane;
}

bool MeasuredTables::is_carried(std::size_t k) const {
  return scene_.probe[k].kind == ProbeKind::point && !scene_.probe[k].body.empty();
}

std::string MeasuredTables::header(bool forces) const {
  std::string line = "frame,time [s]";
  for (std::size_t k = 0; k < probes_.size(); ++k) {
    if (has_places(k)) continue;
    const std::string name = name_of_probe(scene_, k);
    for (int d = 0; is_carried(k) && d < scene_.dimension(); ++d)
      line += fmt::format(",{}: {} [m]", name, axis_letters[d]);
    for (const Probes::Quantity& q : probes_.quantities(k))
      line += fmt::format(",{}: {}{}", name, q.name, q.unit.empty() ? "" : " [" + q.unit + "]");
  }
  const auto flows = scene_.flow_names();
  for (std::size_t c = 0; c < flows.size(); ++c)
    if (scene_.flow_kind(c) == std::string("counter")) line += flow_columns(scene_, flows[c]);
  if (forces) {
    for (const std::string& name : scene_.wall_names()) line += force_columns(scene_, name);
    for (std::size_t b = 0; b < scene_.body.size(); ++b)
      line += force_columns(scene_, scene_.body_name(b));
  }
  return line + "\n";
}

void MeasuredTables::add(const FrameMeasures& frame) {
  table_ += fmt::format("{},{:.9g}", frame.file, frame.time);
  for (std::size_t k = 0; k < frame.probes.size(); ++k) {
    if (has_places(k)) {
      std::string& own = of_probes_[name_of_probe(scene_, k)];
      for (const Probes::Reading& reading : frame.probes[k])
        own += Probes::line(frame.time, reading);
      continue;
    }
    const Probes::Reading& reading = frame.probes[k].front();
    if (is_carried(k))
      for (const double x : reading.place) table_ += cell(x);
    for (const double value : reading.values) table_ += cell(value);
  }
  for (const FrameFlows::Passed& flow : frame.flows) table_ += cell(flow.volume) + cell(flow.rate);
  for (const Vector& force : frame.forces)
    for (const double f : force) table_ += cell(f);
  table_ += '\n';
}

}  // namespace freshet
