// SPDX-License-Identifier: MIT
#include "view/played_run.h"

#include <algorithm>
#include <limits>

#include "scene/model/setup.h"

namespace freshet::view {

PlayedRun::PlayedRun(const std::filesystem::path& folder)
    : scene_(std::make_shared<Scene>(scene_of_run(folder, {}, {{}, ""}))),
      run_(folder, *scene_, "show"),
      times_(run_.files().size(), std::numeric_limits<double>::quiet_NaN()) {
  seek(0);
}

void PlayedRun::seek(std::size_t index) {
  index = std::min(index, run_.files().size() - 1);
  frame_ = run_.read(run_.files()[index]);
  index_ = index;
  times_[index] = frame_.time;
}

void PlayedRun::show(Snapshot& s) const {
  s.scene = scene_;
  s.frame = frame_;
  s.finished_run = true;
  s.frame_index = index_;
  s.frame_count = run_.files().size();
  s.frame_times = times_;
  s.ended = ended();
  s.support_radius = support_radius(*scene_);
}

}  // namespace freshet::view
