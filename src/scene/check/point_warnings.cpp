// SPDX-License-Identifier: MIT
#include "scene/check/point_warnings.h"

#include <cmath>

#include "core/table_text.h"
#include "scene/check/findings.h"
#include "scene/sample/places.h"
#include "scene/sample/point_spacing.h"

namespace freshet {
namespace {

constexpr double other_spacing = 0.2;  // of the spacing

/// The number of points of a fluid's file that walls, bodies and inlets exclude.
template <int D> std::int64_t excluded(const Scene& s, const Scene::Fluid& f) {
  return Places<D>(s, f).each([](Vec<D>, std::size_t) { return true; });
}

class PointWarnings {
 public:
  explicit PointWarnings(const Scene& scene) : s_(scene) {}

  std::vector<Diagnostic> list() {
    for (std::size_t k = 0; k < s_.fluid.size(); ++k)
      if (const Scene::Fluid& f = s_.fluid[k]; !f.from_run.empty())
        excluded_points(f, points_of(f, s_.dimension()), fmt::format("fluid[{}].from_run", k));
      else if (f.shape == Shape::points) fluid(f, fmt::format("fluid[{}].file", k));
    for (std::size_t k = 0; k < s_.wall.size(); ++k)
      if (s_.wall[k].shape == Shape::points) wall(s_.wall[k], fmt::format("wall[{}].file", k));
    return std::move(list_);
  }

 private:
  void warn(const std::string& key, std::string message) {
    list_.push_back({Diagnostic::Severity::warning, place_of(s_, key), std::move(message)});
  }
  void fluid(const Scene::Fluid& f, const std::string& key) {
    const PointCloud cloud = region_points(f, s_.dimension());
    if (!cloud.unused.empty())
      warn(key, fmt::format("{} has columns that are not used: {}; a fluid reads positions and "
                            "velocities",
                            f.file, listed_names(cloud.unused)));
    spacing(f, cloud, key, true);
    excluded_points(f, cloud, key);
  }
  void excluded_points(const Scene::Fluid& f, const PointCloud& cloud, const std::string& key) {
    const std::int64_t count = s_.dimension() == 2 ? excluded<2>(s_, f) : excluded<3>(s_, f);
    if (count > 0)
      warn(key, fmt::format("{} of the {} points of {} are inside walls, bodies or zones of inlets "
                            "and are excluded; move them out, or move what they are in",
                            count, cloud.x.size() / std::size_t(s_.dimension()), f.file));
  }
  void wall(const Scene::Wall& w, const std::string& key) {
    PointCloud cloud = region_points(w, s_.dimension());
    if (!cloud.v.empty()) cloud.unused.insert(cloud.unused.begin(), "velocities");
    if (!cloud.unused.empty())
      warn(key, fmt::format("{} has columns that are not used: {}; a wall reads positions", w.file,
                            listed_names(cloud.unused)));
    spacing(w, cloud, key, false);
  }
  /// Boundary particles may be denser than the fluid's particles, but not sparser.
  void spacing(const Scene::Region& r, const PointCloud& cloud, const std::string& key,
               bool both_ways) {
    const double measured = median_spacing(cloud.x, s_.dimension()), wanted = s_.particles.spacing;
    const double difference = measured / wanted - 1;
    if (measured == 0 || (both_ways ? std::abs(difference) : difference) <= other_spacing) return;
    const char* first = measured < wanted / 2 ? "remove points that lie on others, " : "";
    warn(key,
         fmt::format("the points of {} are {:.3g} m apart (median distance of nearest "
                     "neighbours), and particles.spacing is {:.3g} m; {}set particles.spacing = "
                     "{:.3g}, or sample the points at the spacing",
                     r.file, measured, wanted, first, measured));
  }

  const Scene& s_;
  std::vector<Diagnostic> list_;
};

}  // namespace

std::vector<Diagnostic> point_warnings(const Scene& scene) { return PointWarnings(scene).list(); }

}  // namespace freshet
