// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <limits>

#include "freshet/scene.h"
#include "freshet/simulation.h"
#include "freshet/surface.h"
#include "io/frame_files.h"
#include "run/frame_gaps.h"
#include "run/frame_surface.h"
#include "run/result_folder.h"
#include "run/surface_series.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

void check_options(const SurfaceOptions& options) {
  check_surface_settings(options.settings);
  thread_count(options.threads);  // throws for too many
  if (options.from < 0)
    throw Error(Error::Kind::scene, fmt::format("option from {}", options.from),
                "it must be from 0 on");
  if (options.every < 1 || options.every > 1'000'000'000)
    throw Error(Error::Kind::scene, fmt::format("option every {}", options.every),
                "it must be from 1 to 1000000000");
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

std::vector<std::int64_t> numbers_of(const std::vector<FrameFile>& frames) {
  std::vector<std::int64_t> numbers;
  for (const FrameFile& frame : frames) numbers.push_back(frame.number);
  return numbers;
}

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
  const SurfaceNames names(options, scene);
  if (scene.surface && options.output.empty())
    throw Error(Error::Kind::scene, (options.run / "surface").string(),
                "the run itself wrote these surfaces; choose another `output`", {"output"});
  const ResultFolder folder(options.run, options.output, "surface");
  if (!options.overwrite) folder.refuse_existing(names.all(numbers_of(frames)), "surfaces");
  SurfaceReport report;
  std::vector<double> times;
  for (std::size_t k = 0; k < frames.size() && !report.interrupted; ++k) {
    const Frame frame = read_frame(frames[k].path);
    times.push_back(frame.time);
    write_surfaces(scene, options, {frame, frames[k].number, frames[k].path.string()},
                   options.threads, [&](const std::string& name, const std::string& bytes) {
                     report.files.push_back(folder.write(name, bytes));
                   });
    report.interrupted = options.after_surface && !options.after_surface(k + 1, frames.size());
  }
  std::vector<std::int64_t> numbers = numbers_of(frames);
  numbers.resize(times.size());
  write_surface_times(
      names, times, numbers,
      [&](const std::string& name, const std::string& bytes) { folder.write(name, bytes); });
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace freshet
