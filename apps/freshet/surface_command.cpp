// SPDX-License-Identifier: MIT
#include "freshet/surface.h"

#include <fmt/format.h>

#include <algorithm>

#include "command.h"
#include "interrupts.h"
#include "print.h"
#include "progress.h"

namespace freshet::cli {
namespace {

const std::vector<std::string> formats{"ply", "obj", "vtp",
                                       "glb"};  // in the order of SurfaceFormat

struct SurfaceArguments {
  std::string run, output, format = "ply";
  SurfaceOptions options;
  std::int64_t to = -1;
  bool quiet = false;
};

int make(const SurfaceArguments& a) {
  SurfaceOptions options = a.options;
  options.run = a.run;
  options.output = a.output;
  options.format =
      SurfaceFormat(std::find(formats.begin(), formats.end(), a.format) - formats.begin());
  if (a.to >= 0) options.to = a.to;
  const Count count(a.quiet, "frames");
  options.after_surface = count;
  if (!a.quiet) options.warn = print_diagnostics;
  catch_interrupts();
  const SurfaceReport r = make_surfaces(options);
  count.finish();
  if (!a.quiet)
    print_out("{}{} surfaces in {}\nwrote {}\n", r.interrupted ? "interrupted after " : "",
              r.files.size(), duration(r.seconds), r.files.empty() ? "" : r.files.back().string());
  return r.interrupted ? interrupted : done;
}

void add_settings(const Command& surface, SurfaceSettings& s) {
  surface.option("--cell", s.cell, "edge of a grid cell in particle spacings (default: 0.5)")
      .range(0.1, 2.0);
  surface
      .option("--radius", s.radius,
              "reach of a particle in particle spacings; larger is rounder (default: 2)")
      .range(1.0, 6.0);
  surface
      .option("--level", s.level,
              "density of the surface, of 1 deep in the fluid; lower is thicker (default: 0.6)")
      .range(0.05, 0.95);
  surface.option("--smooth", s.smooth, "smoothing steps; 0 for none (default: 10)").range(0, 100);
}

}  // namespace

void add_surface(Program& program) {
  const auto a = std::make_shared<SurfaceArguments>();
  const Command surface =
      program.add("surface", "Make closed meshes of the fluid of a finished run in 3D");
  surface.option("DIR", a->run, "the folder of a run").required();
  surface.option("--format", a->format, "format of the meshes (default: ply)").one_of(formats);
  surface.option("--output", a->output, "the folder of the surfaces (default: DIR/surface)")
      .value("FOLDER");
  surface.flag("--overwrite", a->options.overwrite, "replace existing surfaces");
  surface.option("--from", a->options.from, "number of the first data file (default: 0)")
      .at_least(0);
  surface.option("--to", a->to, "number of the last data file (default: all)").at_least(0);
  surface.option("--every", a->options.every, "take every N-th data file (default: 1)")
      .value("N")
      .at_least(1);
  surface.flag("--phases", a->options.phases, "a mesh for each liquid instead of one for all");
  add_settings(surface, a->options.settings);
  surface.option("--threads", a->options.threads, "threads (default: all)").at_least(1);
  surface.flag("--quiet", a->quiet, "print nothing but errors");
  surface.footer(
      "Examples:\n  freshet surface runs/dam_break_3d\n"
      "  freshet surface runs/dam_break_3d --format glb --from 5 --to 5");
  surface.action([a] { return make(*a); });
}

}  // namespace freshet::cli
