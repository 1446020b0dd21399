// SPDX-License-Identifier: MIT
#include "view/played_run.h"

#include <algorithm>
#include <limits>

#include "run/table.h"
#include "scene/model/setup.h"

namespace freshet::view {
namespace {

/// The numbers of observables.csv; null without a table that can be read.
std::shared_ptr<const SeriesOverTime> read_observables(const std::filesystem::path& folder) {
  try {
    const Table table = read_table(folder / "observables.csv");
    const Column* time = table.find("time");
    if (!time) return nullptr;
    auto all = std::make_shared<SeriesOverTime>();
    all->times.assign(time->numbers.begin(), time->numbers.end());
    for (const Column& c : table.columns) {
      if (c.of_words() || c.name == "time" || c.name == "step") continue;
      const std::string unit = c.unit.empty() ? "" : " [" + c.unit + "]";
      all->series.push_back({c.name + unit, {c.numbers.begin(), c.numbers.end()}});
    }
    return all;
  } catch (const Error&) {
    return nullptr;
  }
}

}  // namespace

PlayedRun::PlayedRun(const std::filesystem::path& folder)
    : scene_(std::make_shared<Scene>(scene_of_run(folder, {}, {{}, ""}))),
      run_(folder, *scene_, "show"),
      recorded_(read_observables(folder)),
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
  s.recorded = recorded_;
  s.ended = ended();
  s.support_radius = support_radius(*scene_);
}

}  // namespace freshet::view
