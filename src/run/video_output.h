// SPDX-License-Identifier: MIT
#pragma once
#include "run/output.h"

namespace freshet {

/// The pictures of a video in the run folder, video/picture_000000.png ..., which are encoded at
/// the end. They stay, so that a resumed run continues its video.
class VideoOutput final : public Output {
 public:
  VideoOutput(const RunSite& site, const VideoOptions& options) : site_(site), options_(options) {}
  const char* name() const override { return "video"; }
  std::vector<std::string> files() const override;
  std::vector<Diagnostic> resume() override;
  bool due(const StepTaken& step) const override;
  void write(const StepTaken& step) override;
  bool writes_the_end() const override { return false; }
  void finish() override;

 private:
  /// The time between two pictures of the video [s].
  double interval() const { return options_.speed / options_.fps; }
  /// The number of pictures of the video up to this time.
  std::int64_t count_by(double time) const;
  std::vector<double>& times() const { return site_.record.series["video"].times; }
  bool can_continue() const;

  RunSite site_;
  VideoOptions options_;
};

/// Throws Error (kind scene) if the video cannot be made, or has too many pictures.
void check_video_of(const Scene& scene, const VideoOptions& options, bool overwrite);

}  // namespace freshet
