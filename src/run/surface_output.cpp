// SPDX-License-Identifier: MIT
#include "run/surface_output.h"

#include <algorithm>
#include <numeric>

#include "freshet/error.h"

namespace freshet {
namespace {

constexpr const char* surface_folder = "surface/";

std::vector<std::int64_t> first_numbers(std::size_t count) {
  std::vector<std::int64_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// The error of a run: a scene that was checked has no errors left. Options become keys.
[[noreturn]] void rethrow_as_run(const Error& error) {
  std::vector<Diagnostic> all = error.diagnostics();
  for (Diagnostic& d : all)
    for (std::string& option : d.options) {
      const std::string quoted = "`" + option + "`";
      option = "surface." + option;
      for (std::size_t at = 0; (at = d.message.find(quoted, at)) != std::string::npos; ++at)
        d.message.replace(at, quoted.size(), "`" + option + "`");
    }
  throw Error(Error::Kind::run, std::move(all));
}

}  // namespace

SurfaceOutput::SurfaceOutput(const RunSite& site)
    : site_(site), names_(*site.sim.scene().surface, site.sim.scene()) {}

std::vector<std::string> SurfaceOutput::files() const {
  std::vector<std::string> all =
      names_.all(first_numbers(std::size_t(site_.schedule.surface_frames())));
  for (std::string& file : all) file.insert(0, surface_folder);
  return all;
}

bool SurfaceOutput::shows_between(double from, double to) const {
  return site_.schedule.surface().frames_between(from, to);
}

bool SurfaceOutput::write(const StepTaken& step) {
  const auto due = site_.schedule.surface().frames_in(step);
  for (const double time : due) add(time);
  return !due.empty() && due.back() == step.after;
}

void SurfaceOutput::add(double time) {
  auto& times = site_.record.series[name()].times;
  times.push_back(time);
  site_.background.add([site = site_, names = names_, times, frame = site_.frames.at(time)] {
    const Scene& scene = site.sim.scene();
    const auto number = std::int64_t(times.size()) - 1;
    const WriteFile write_mesh = [&](const std::string& file, const std::string& bytes) {
      site.folder.write_more(surface_folder + file, bytes);
    };
    try {
      write_surfaces(scene, *scene.surface,
                     {*frame, number, surface_folder + names.mesh(number, 0)}, 1, write_mesh);
    } catch (const Error& error) {
      if (error.kind() == Error::Kind::run) throw;
      rethrow_as_run(error);
    }
    write_surface_times(names, times, first_numbers(times.size()),
                        [&](const std::string& file, const std::string& bytes) {
                          site.folder.write(surface_folder + file, bytes);
                        });
  });
}

}  // namespace freshet
