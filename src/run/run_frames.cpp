// SPDX-License-Identifier: MIT
#include "freshet/run_frames.h"

#include "run/finished_run.h"

namespace freshet {

struct RunFrames::Parts {
  explicit Parts(const std::filesystem::path& folder)
      : scene(scene_of_run(folder, {}, {{}, ""})), run(folder, scene, "read") {}
  Scene scene;
  FinishedRun run;
};

RunFrames::RunFrames(const std::filesystem::path& run) : parts_(std::make_unique<Parts>(run)) {}
RunFrames::~RunFrames() = default;
RunFrames::RunFrames(RunFrames&&) noexcept = default;
RunFrames& RunFrames::operator=(RunFrames&&) noexcept = default;

const Scene& RunFrames::scene() const { return parts_->scene; }
std::size_t RunFrames::size() const { return parts_->run.files().size(); }
std::filesystem::path RunFrames::file(std::size_t k) const {
  return parts_->run.files().at(k).path;
}
Frame RunFrames::read(std::size_t k) const { return parts_->run.read(parts_->run.files().at(k)); }

}  // namespace freshet
