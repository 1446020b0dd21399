// SPDX-License-Identifier: MIT
#include "run/finished_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/input_file.h"
#include "run/body_table.h"
#include "scene/keys/override_place.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// Whether a key is of a table: "camera", "camera.orbit" and "camera[1].orbit" are of "camera".
bool is_of(const std::string& key, const std::string& table) {
  return key == table || key.starts_with(table + ".") || key.starts_with(table + "[");
}

}  // namespace

Scene scene_of_run(const fs::path& folder, const std::vector<Override>& overrides,
                   const ChangeableKeys& keys) {
  for (const Override& change : overrides)
    if (std::none_of(keys.tables.begin(), keys.tables.end(),
                     [&](const std::string& table) { return is_of(change.first, table); }))
      throw Error(Error::Kind::scene, place_of(change), keys.refusal);
  const fs::path file = folder / "scene.toml";
  if (!fs::exists(file))
    throw Error(
        Error::Kind::scene, folder.string(),
        "no run is in this folder (it has no scene.toml); name the folder of a finished run");
  return load_scene(file, overrides);
}

FinishedRun::FinishedRun(const fs::path& folder, const Scene& scene, const char* use)
    : scene_(scene), table_((folder / "bodies.csv").string()), files_(frame_files(folder)) {
  if (files_.empty())
    throw Error(
        Error::Kind::scene, folder.string(),
        fmt::format("this run wrote no data to {} (its folder has no data/); run its scene again "
                    "with output.data = [\"vtp\"]",
                    use));
  if (scene.body.empty()) return;
  std::error_code ec;
  if (!fs::is_regular_file(table_, ec))
    throw Error(Error::Kind::scene, table_,
                "this table is missing or cannot be read, and the bodies of the data files are in "
                "it; put it back, or run the scene again");
  constexpr InputFile table{.may_be_empty = true};
  bodies_ = read_bodies(read_input(table_, table), scene, table_);
}

Frame FinishedRun::read(const FrameFile& file, DataFields* stored) const {
  Frame frame = read_frame(file.path, stored);
  if (frame.dimension != scene_.dimension())
    throw Error(Error::Kind::run, file.path.string(),
                fmt::format("this frame is in {}D and the run's scene in {}D; run it again",
                            frame.dimension, scene_.dimension()));
  put_bodies(frame, file.path);
  return frame;
}

void FinishedRun::put_bodies(Frame& frame, const fs::path& file) const {
  if (scene_.body.empty()) return;
  const double close = 1e-8 * std::abs(frame.time);  // the table has nine digits
  const auto at = bodies_.lower_bound(frame.time - close);
  if (at == bodies_.end() || at->first > frame.time + close)
    throw Error(Error::Kind::scene, table_,
                fmt::format("there is no row for each body at {:g} s, which {} shows; put the "
                            "table back as the run wrote it, or run the scene again",
                            frame.time, file.string()));
  frame.bodies = at->second;
}

}  // namespace freshet
