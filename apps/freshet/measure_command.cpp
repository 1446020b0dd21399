// SPDX-License-Identifier: MIT
#include "freshet/measure.h"

#include <fmt/format.h>

#include "command.h"
#include "interrupts.h"
#include "print.h"
#include "progress.h"

namespace freshet::cli {
namespace {

struct MeasureArguments {
  std::string run, probes, output;
  KeyArguments keys;
  int threads = 0;
  bool forces = false, surfaces = false, overwrite = false, quiet = false;
};

int measure_run(const MeasureArguments& a) {
  MeasureOptions options;
  options.run = a.run;
  options.probes = a.probes;
  options.output = a.output;
  options.forces = a.forces;
  options.surfaces = a.surfaces;
  options.overwrite = a.overwrite;
  options.execution.threads = a.threads;
  options.overrides = a.keys.overrides();
  const Count count(a.quiet, "frames");
  options.after_frame = count;
  if (!a.quiet) options.warn = print_diagnostics;
  catch_interrupts();
  const MeasureReport r = measure(options);
  count.finish();
  if (!a.quiet) {
    print_out("{}{} frames in {}\n", r.interrupted ? "interrupted after " : "", r.frames,
              duration(r.seconds));
    print_out("wrote {}\n", printable(r.files.front().lexically_normal().string()));
    if (r.files.size() > 1)
      print_out("and {} files in {}\n", r.files.size() - 1,
                printable(r.files.front().lexically_normal().replace_extension().string()));
  }
  return r.interrupted ? interrupted : done;
}

}  // namespace

void add_measure(Program& program) {
  const auto a = std::make_shared<MeasureArguments>();
  const Command measure = program.add(
      "measure", "Measure a finished run: new probes, flows, forces and loads on surfaces");
  measure.option("DIR", a->run, "the folder of a run").required();
  measure
      .option(
          "--probes", a->probes,
          "a scene, or a TOML file with its [[probe]] and [[counter]] tables only (default: those "
          "of the run's scene)")
      .value("FILE");
  a->keys.add_to(measure, "a key of probe or counter");
  measure.flag("--forces", a->forces, "the force on each wall and body");
  measure.flag("--surfaces", a->surfaces,
               "pressure and traction on walls and bodies, as VTP files, and the forces");
  measure
      .option("--output", a->output,
              "FILE.csv (default: DIR/measured.csv, or measured-2.csv, ... if it exists)")
      .value("FILE");
  measure.flag("--overwrite", a->overwrite, "replace an existing table and its files");
  measure.option("--threads", a->threads, "threads (default: by the number of particles)")
      .at_least(1);
  measure.flag("--quiet", a->quiet, "print nothing but errors");
  measure.footer(
      "Examples:\n  freshet measure runs/dam_break_2d --probes gauges.toml\n"
      "  freshet measure runs/dam_break_2d --set \"probe.at=[0.5, 0.1]\"\n"
      "  freshet measure runs/water_wheel --surfaces");
  measure.action([a] { return measure_run(*a); });
}

}  // namespace freshet::cli
