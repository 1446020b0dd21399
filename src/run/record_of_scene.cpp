// SPDX-License-Identifier: MIT
#include "run/record_of_scene.h"

#include <algorithm>

#include "core/check_checkpoint.h"

namespace freshet {
namespace {

bool has_vectors(const std::vector<Vector>& vectors, std::size_t count, std::size_t dimension) {
  return vectors.empty() || (vectors.size() == count &&
                             std::all_of(vectors.begin(), vectors.end(),
                                         [=](const Vector& v) { return v.size() == dimension; }));
}

}  // namespace

void check_record_of_scene(const RunRecord& record, const Scene& scene) {
  const auto walls = scene.wall_names().size(), flows = scene.flow_names().size(),
             dimension = std::size_t(scene.dimension());
  if (!has_vectors(record.wall_forces, walls, dimension) ||
      !has_vectors(record.observed.impulses, walls, dimension))
    fail_for_checkpoint("its forces are not those on the walls of its scene");
  const auto& passed = record.observed.passed;
  if ((!record.flows.empty() && record.flows.size() != flows) ||
      (!passed.empty() && passed.size() < flows))
    fail_for_checkpoint("its flows are not those of its scene");
}

}  // namespace freshet
