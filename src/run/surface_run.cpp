// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <limits>

#include "freshet/scene.h"
#include "freshet/simulation.h"
#include "freshet/surface.h"
#include "io/frame_data.h"
#include "io/frame_files.h"
#include "io/surface_files.h"
#include "run/frame_gaps.h"
#include "run/frame_surface.h"
#include "run/result_folder.h"
#include "surface/liquid_part.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

void check_options(const SurfaceOptions& options) {
  check_surface_settings(options.settings);
  thread_count(options.threads);  // throws for too many
  if (options.from < 0)
    throw Error(Error::Kind::scene, fmt::format("option from {}", options.from),
                "it must be from 0 on");
  if (options.every < 1)
    throw Error(Error::Kind::scene, fmt::format("option every {}", options.every),
                "it must be from 1 on");
}

/// The data files that the options choose.
std::vector<FrameFile> chosen_frames(const SurfaceOptions& options) {
  const std::vector<FrameFile> all = frame_files(options.run);
  if (all.empty())
    throw Error(Error::Kind::scene, options.run.string(),
                "this run wrote no data to make surfaces of (its folder has no data/); run its "
                "scene again with output.data = [\"vtp\"]");
  const std::int64_t to = options.to.value_or(std::numeric_limits<std::int64_t>::max());
  std::vector<FrameFile> chosen;
  for (const FrameFile& frame : all)
    if (frame.number >= options.from && frame.number <= to &&
        (frame.number - options.from) % options.every == 0)
      chosen.push_back(frame);
  if (chosen.empty())
    throw Error(Error::Kind::scene, all.front().path.parent_path().string(),
                fmt::format("the options choose no data file; the numbers of the data files are "
                            "{} to {}; change `from`, `to` or `every`",
                            all.front().number, all.back().number),
                {"from", "to", "every"});
  return chosen;
}

/// Makes the surfaces of frames, one at a time.
class SurfaceSeries {
 public:
  SurfaceSeries(const SurfaceOptions& options, const Scene& scene,
                const std::vector<FrameFile>& frames)
      : options_(options),
        scene_(scene),
        liquids_(options.phases ? int(scene.liquids().size()) : 1),
        folder_(options.run, options.output, "surface") {
    std::vector<std::string> names;
    for (const FrameFile& frame : frames)
      for (int liquid = 0; liquid < liquids_; ++liquid) names.push_back(name(frame, liquid));
    for (int liquid = 0; liquid < liquids_ && has_times(); ++liquid)
      names.push_back(times_name(liquid));
    if (!options.overwrite) folder_.refuse_existing(names, "surfaces");
  }

  void add(const FrameFile& file, SurfaceReport& report) {
    const Frame frame = read_frame(file.path);
    times_.push_back(frame.time);
    for (int liquid = 0; liquid < liquids_; ++liquid) {
      const SurfaceMesh mesh =
          surface_of_frame(scene_, options_.phases ? liquid_part(frame, liquid) : frame, file.path,
                           options_.settings, options_.threads);
      const std::string bytes = encode_surface(options_.format, mesh, {frame.time, frame.step});
      report.files.push_back(folder_.write(name(file, liquid), bytes));
    }
  }
  /// Writes the times of the surfaces for ParaView.
  void finish(const std::vector<FrameFile>& frames) const {
    for (int liquid = 0; liquid < liquids_ && has_times(); ++liquid) {
      std::vector<std::string> names;
      for (const FrameFile& frame : frames) names.push_back(name(frame, liquid));
      folder_.write(times_name(liquid), encode_pvd(times_, names));
    }
  }

 private:
  std::string name(const FrameFile& frame, int liquid) const {
    const std::string phase = options_.phases ? fmt::format("liquid{}_", liquid) : "";
    return fmt::format("surface_{}{:04}{}", phase, frame.number, extension_of(options_.format));
  }
  bool has_times() const { return options_.format == SurfaceFormat::vtp; }
  std::string times_name(int liquid) const {
    return options_.phases ? fmt::format("surfaces_liquid{}.pvd", liquid) : "surfaces.pvd";
  }
  const SurfaceOptions& options_;
  const Scene& scene_;
  int liquids_;
  ResultFolder folder_;
  std::vector<double> times_;
};

}  // namespace

SurfaceReport make_surfaces(const SurfaceOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  check_options(options);
  const Scene scene = scene_in_3d(options.run, {}, {}, "a surface");
  const std::vector<FrameFile> frames = chosen_frames(options);
  if (const auto gaps = gaps_in(frames, "they get no surface, and the others keep their numbers",
                                options.from, options.every);
      options.warn && !gaps.empty())
    options.warn(gaps);
  SurfaceSeries surfaces(options, scene, frames);
  SurfaceReport report;
  for (std::size_t k = 0; k < frames.size() && !report.interrupted; ++k) {
    surfaces.add(frames[k], report);
    report.interrupted = options.after_surface && !options.after_surface(k + 1, frames.size());
  }
  surfaces.finish(frames);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace freshet
