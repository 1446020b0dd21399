// SPDX-License-Identifier: MIT
/// Spray, foam and bubbles.
#include "scene/check/findings.h"

namespace freshet {

void check_whitewater(const Scene& s, Findings& out) {
  if (!s.whitewater) return;
  const Scene::Whitewater& w = *s.whitewater;
  const std::pair<const char*, const Vector*> ranges[] = {
      {"trapped_air_limits", &w.trapped_air_limits},
      {"wave_crest_limits", &w.wave_crest_limits},
      {"turbulence_limits", &w.turbulence_limits},
      {"speed_limits", &w.speed_limits}};
  for (const auto& [name, range] : ranges) {
    const std::string key = fmt::format("whitewater.{}", name);
    if (range->size() == 2 && !((*range)[0] >= 0 && (*range)[0] < (*range)[1]))
      out.error(key,
                fmt::format("{} = [{}, {}] is not a range; the first number must be 0 or more, "
                            "and less than the second",
                            key, (*range)[0], (*range)[1]));
  }
  if (w.lifetime.size() == 2 && !(w.lifetime[0] >= 0 && w.lifetime[0] <= w.lifetime[1]))
    out.error(
        "whitewater.lifetime",
        fmt::format("whitewater.lifetime = [{}, {}] is not a range; the first number must be 0 "
                    "or more, and at most the second",
                    w.lifetime[0], w.lifetime[1]));
}

}  // namespace freshet
