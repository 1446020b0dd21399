// SPDX-License-Identifier: MIT
#include "scene/model/run_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/input_file.h"
#include "formats/point_sink.h"
#include "scene/keys/parse_toml.h"
#include "scene/sample/point_cloud.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

constexpr const char* readable[] = {".vtp", ".ply", ".csv"};  // in the order of preference
constexpr const char* written_too[] = {".h5", ".bgeo"};

struct NumberedFile {
  std::int64_t number;
  fs::path file;
};

/// The files data/frame_NUMBER of an extension, in the order of their numbers.
std::vector<NumberedFile> frames_of(const fs::path& run, const std::string& extension) {
  std::vector<NumberedFile> all;
  std::error_code ec;
  for (const auto& entry : fs::directory_iterator(run / "data", ec)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != extension || !stem.starts_with("frame_")) continue;
    if (const auto number = count_in(stem.substr(6)))
      all.push_back({std::int64_t(*number), entry.path()});
  }
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.number < b.number; });
  return all;
}

std::vector<NumberedFile> frames_of(const fs::path& run) {
  for (const char* extension : readable)
    if (auto all = frames_of(run, extension); !all.empty()) return all;
  std::error_code ec;
  if (!fs::exists(run, ec))
    throw Error(Error::Kind::scene, run.string(),
                "no such run folder or data file; check the path");
  for (const char* extension : written_too)
    if (!frames_of(run, extension).empty())
      throw Error(Error::Kind::scene, run.string(),
                  fmt::format("this run wrote data files of {} only, which no fluid starts from; "
                              "run its scene again with output.data = [\"vtp\"]",
                              extension));
  throw Error(Error::Kind::scene, run.string(),
              fs::exists(run / "scene.toml", ec)
                  ? "this run wrote no data files (its folder has no data/); run its scene again "
                    "with output.data = [\"vtp\"]"
                  : "no run is in this folder (it has no scene.toml); name the folder of a run, or "
                    "one of its data files");
}

double time_of(const NumberedFile& frame) {
  const PointCloud cloud = read_state(frame.file, 0);
  if (!cloud.time)
    throw Error(Error::Kind::scene, frame.file.string(),
                "this data file has no time; choose it by fluid.frame");
  return *cloud.time;
}

/// Searches by halves, as a file must be read for its time.
fs::path at_time(const std::vector<NumberedFile>& all, double time, const fs::path& run) {
  const double close = 1e-6 * std::abs(time);
  std::size_t low = 0, high = all.size();  // the first file that is not before `time`
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (time_of(all[middle]) < time - close) low = middle + 1;
    else high = middle;
  }
  if (low < all.size() && time_of(all[low]) <= time + close) return all[low].file;
  std::string near;
  for (const std::size_t k : {low - 1, low})
    if (k < all.size())
      near += fmt::format("{}{:.6g} s (frame {})", near.empty() ? "" : " and ", time_of(all[k]),
                          all[k].number);
  throw Error(Error::Kind::scene, run.string(),
              fmt::format("this run has no data file at {:.6g} s; the nearest {} at {}; choose one "
                          "by fluid.frame",
                          time, low > 0 && low < all.size() ? "are" : "is", near));
}

fs::path of_number(const std::vector<NumberedFile>& all, std::int64_t number, const fs::path& run) {
  for (const NumberedFile& frame : all)
    if (frame.number == number) return frame.file;
  throw Error(Error::Kind::scene, run.string(),
              fmt::format("this run has no frame {}; its {} data files have the numbers {} to {}",
                          number, all.size(), all.front().number, all.back().number));
}

}  // namespace

fs::path run_frame_of(const Scene::Fluid& f) {
  const fs::path run = f.from_run;
  std::error_code ec;
  if (fs::is_regular_file(run, ec)) return run;
  const auto all = frames_of(run);
  if (f.frame) return of_number(all, *f.frame, run);
  return f.time ? at_time(all, *f.time, run) : all.back().file;
}

void find_run_frame(Scene::Fluid& f) {
  if (f.from_run.empty() || !f.file.empty()) return;
  f.shape = Shape::points;
  try {
    f.file = run_frame_of(f).string();
  } catch (const Error&) {
  }
}

RunScene run_scene_of(const Scene::Fluid& f) {
  std::error_code ec;
  const fs::path run = f.from_run;
  RunScene scene;
  scene.file =
      (fs::is_regular_file(run, ec) ? run.parent_path().parent_path() : run) / "scene.toml";
  if (!fs::is_regular_file(scene.file, ec)) return scene;
  const toml::table table = parse_toml(read_input(scene.file), scene.file.string());
  scene.spacing = table["particles"]["spacing"].value<double>();
  if (const toml::array* max = table["domain"]["max"].as_array())
    scene.dimension = int(max->size());
  return scene;
}

}  // namespace freshet
