// SPDX-License-Identifier: MIT
#include "freshet/surface.h"

#include <fmt/format.h>

#include "command.h"
#include "interrupts.h"
#include "print.h"
#include "progress.h"

namespace freshet::cli {
namespace {

struct SurfaceArguments {
  std::string run, output;
  SurfaceOptions options;
  std::int64_t to = -1;
  bool quiet = false;
};

int make(const SurfaceArguments& a) {
  SurfaceOptions options = a.options;
  options.run = a.run;
  options.output = a.output;
  if (a.to >= 0) options.to = a.to;
  const Count count(a.quiet, "frames");
  options.after_surface = count;
  if (!a.quiet) options.warn = print_diagnostics;
  catch_interrupts();
  const SurfaceReport r = make_surfaces(options);
  count.finish();
  if (!a.quiet)
    print_out("{}{} surfaces in {}\nwrote {}\n", r.interrupted ? "interrupted after " : "",
              r.files.size(), duration(r.seconds),
              r.files.empty() ? "" : printable(r.files.back().string()));
  return r.interrupted ? interrupted : done;
}

/// The settings of surfaces as options.
struct SettingOptions {
  const Command& command;
  void number(const std::string& name, double& value, double low, double high, const char* text) {
    add(name, value, fmt::format("{} (default: {:g})", text, value)).range(low, high);
  }
  void count(const std::string& name, int& value, int low, int high, const char* text) {
    add(name, value, fmt::format("{} (default: {})", text, value)).range(low, high);
  }
  template <class E, std::size_t n>
  void choice(const std::string& name, E& value, const char* const (&names)[n], const char* text) {
    command.choice(("--" + name).c_str(), {names, names + n},
                   [&value](int chosen) { value = E(chosen); },
                   fmt::format("{} (default: {})", text, names[int(value)]));
  }
  void flag(const std::string& name, bool& value, const char* text) {
    command.flag(("--" + name).c_str(), value, text);
  }

 private:
  template <class T> Option add(const std::string& name, T& value, const std::string& help) {
    return command.option(("--" + name).c_str(), value, help);
  }
};

}  // namespace

void add_surface(Program& program) {
  const auto a = std::make_shared<SurfaceArguments>();
  const Command surface =
      program.add("surface", "Make closed meshes of the fluid of a finished run in 3D");
  surface.option("DIR", a->run, "the folder of a run").required();
  surface.option("--output", a->output, "the folder of the surfaces (default: DIR/surface)")
      .value("FOLDER");
  surface.flag("--overwrite", a->options.overwrite, "replace existing surfaces");
  surface.option("--from", a->options.from, "number of the first data file (default: 0)")
      .at_least(0);
  surface.option("--to", a->to, "number of the last data file (default: all)").at_least(0);
  surface.option("--every", a->options.every, "take every N-th data file (default: 1)")
      .value("N")
      .at_least(1);
  SettingOptions settings{surface};
  visit_files(settings, a->options);
  surface.option("--threads", a->options.threads, "threads (default: all)").at_least(1);
  surface.flag("--quiet", a->quiet, "print nothing but errors");
  surface.footer(
      "Examples:\n  freshet surface runs/dam_break_3d\n"
      "  freshet surface runs/dam_break_3d --format glb --from 5 --to 5");
  surface.action([a] { return make(*a); });
}

}  // namespace freshet::cli
