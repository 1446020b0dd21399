// SPDX-License-Identifier: MIT
#pragma once
#include "run/output.h"
#include "run/surface_series.h"

namespace freshet {

/// surface/surface_0000.*: meshes of the fluid while the run runs, by the scene's [surface].
class SurfaceOutput final : public Output {
 public:
  explicit SurfaceOutput(const RunSite& site);
  const char* name() const override { return "surface"; }
  std::vector<std::string> files() const override;
  bool shows_between(double from, double to) const override;
  bool write(const StepTaken& step) override;
  void write_end() override { add(site_.sim.time()); }

 private:
  void add(double time);

  RunSite site_;
  SurfaceNames names_;
};

}  // namespace freshet
