// SPDX-License-Identifier: MIT
/// Interventions between steps: changed keys, pulled bodies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/check_checkpoint.h"
#include "freshet/checkpoint.h"
#include "freshet/scene_keys.h"
#include "scene/model/openings.h"
#include "sim/simulation_impl.h"

namespace freshet {
namespace {

void check_live(const std::vector<Override>& overrides) {
  for (const Override& change : overrides)
    if (!may_change_while_running(change.first))
      throw Error(Error::Kind::scene, "override " + change.first,
                  fmt::format("{} cannot change while the simulation runs; set it in the scene and "
                              "start again",
                              change.first));
}

/// Moves the crossing times of the layers of inlets, so that each layer is where it was at the
/// inlet's new speed.
void keep_layers(Checkpoint& c, const Scene& before, const Scene& after) {
  for (std::size_t k = 0; k < before.inlet.size() && k < after.inlet.size(); ++k) {
    const double ratio =
        inlet_plan(before, before.inlet[k]).speed / inlet_plan(after, after.inlet[k]).speed;
    if (ratio == 1) continue;
    const std::string name = fmt::format("flows/inlet_{}_crossings", k);
    for (Checkpoint::Array& array : c.arrays) {
      if (array.name != name) continue;
      for (std::size_t slot = 0; slot < std::size_t(array.count); ++slot) {
        const double moved = c.time + (number_at<double>(array, slot) - c.time) * ratio;
        std::memcpy(array.bytes.data() + slot * sizeof moved, &moved, sizeof moved);
      }
    }
  }
}

bool sets_gravity(const std::vector<Override>& overrides) {
  return std::any_of(overrides.begin(), overrides.end(),
                     [](const Override& o) { return o.first == "domain.gravity"; });
}

}  // namespace

void Simulation::change(const std::vector<Override>& overrides) {
  Impl& i = *impl_;
  i.refuse_shown("change");
  check_live(overrides);
  const auto file = i.scene.places.find("");
  if (i.scene.source.empty() || file == i.scene.places.end())
    throw Error(Error::Kind::scene, "change",
                "a scene made in code has no keys to change; make it by parse_scene or load_scene");
  Simulation changed(parse_scene(i.scene.source, file->second, overrides), i.execution);
  Checkpoint state = checkpoint();
  state.scene.clear();  // that of the keys before the change
  keep_layers(state, i.scene, changed.scene());
  changed.restore(state);
  if (i.gravity && !sets_gravity(overrides)) changed.set_gravity(*i.gravity);
  if (i.force) changed.set_force(i.force);
  for (std::size_t k = 0; i.bodies && k < i.bodies->size(); ++k)
    changed.impl_->bodies->push(k, i.bodies->pushes()[k]);
  changed.impl_->observers = std::move(i.observers);
  changed.impl_->health->note_intervention();
  *this = std::move(changed);
}

void Simulation::push_body(std::size_t body, const std::array<double, 3>& force,
                           const std::array<double, 3>& torque) {
  Impl& i = *impl_;
  if (body >= i.scene.body.size() || i.scene.body[body].motion != BodyMotion::free)
    throw Error(Error::Kind::scene, "push_body",
                fmt::format("body {} is not a free body of the scene", body));
  SixNumbers load{};
  const bool flat = i.scene.dimension() == 2;
  for (std::size_t d = 0; d < 3; ++d) {
    if (!std::isfinite(force[d]) || !std::isfinite(torque[d]))
      throw Error(Error::Kind::scene, "push_body", "a force must have finite numbers");
    if (!flat || d < 2) load[d] = force[d];
    if (!flat || d == 2) load[3 + d] = torque[d];
  }
  i.health->note_intervention();
  i.bodies->push(body, load);
}

}  // namespace freshet
