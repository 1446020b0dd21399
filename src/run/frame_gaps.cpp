// SPDX-License-Identifier: MIT
#include "run/frame_gaps.h"

#include <fmt/format.h>

#include <algorithm>

namespace freshet {

std::vector<Diagnostic> gaps_in(const std::vector<FrameFile>& frames,
                                const std::string& consequence, std::int64_t from,
                                std::int64_t every) {
  std::vector<std::string> missing;
  std::int64_t next = from;
  for (const FrameFile& frame : frames) {
    if (frame.number == next + every) missing.push_back(fmt::format("{:04}", next));
    if (frame.number > next + every)
      missing.push_back(fmt::format("{:04} to {:04}", next, frame.number - every));
    next = frame.number + every;
  }
  if (missing.empty()) return {};
  constexpr std::size_t most = 5;
  std::string list;
  for (std::size_t k = 0; k < std::min(missing.size(), most); ++k)
    list += (k == 0 ? "" : ", ") + missing[k];
  if (missing.size() > most) list += " and more";
  return {{Diagnostic::Severity::warning, frames.front().path.parent_path().string(),
           fmt::format("data files are missing: {}; {}; to have all, put the files back or run "
                       "the scene again",
                       list, consequence)}};
}

}  // namespace freshet
