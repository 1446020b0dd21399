// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

#include "sim/frame_flows.h"
#include "sim/probes.h"

namespace freshet {

/// The measurements of a frame of a finished run.
struct FrameMeasures {
  std::int64_t file = 0;  ///< number of the data file
  double time = 0;        ///< [s]
  std::vector<std::vector<Probes::Reading>> probes;
  std::vector<FrameFlows::Passed> flows;  ///< by counter
  std::vector<Vector> forces;             ///< by wall, then by body; empty if not measured
};

/// The tables of a measurement: one with a row per frame, and one for each probe along a line or in
/// a plane, as the run's own.
class MeasuredTables {
 public:
  /// `scene` has the probes and counters. Keeps references.
  MeasuredTables(const Scene& scene, const Probes& probes, bool forces);
  void add(const FrameMeasures& frame);
  const std::string& table() const { return table_; }
  /// By name of the probe.
  const std::map<std::string, std::string>& of_probes() const { return of_probes_; }

 private:
  /// Whether a probe has many places, and therefore a table of its own.
  bool has_places(std::size_t k) const;
  bool is_carried(std::size_t k) const;
  std::string header(bool forces) const;

  const Scene& scene_;
  const Probes& probes_;
  std::string table_;
  std::map<std::string, std::string> of_probes_;
};

}  // namespace freshet
