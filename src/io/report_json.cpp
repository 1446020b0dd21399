// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "freshet/report.h"
#include "freshet/version.h"

namespace freshet {
namespace {

using Json = nlohmann::ordered_json;

const char* word(Report::State state) {
  switch (state) {
    case Report::State::done:
      return "done";
    case Report::State::interrupted:
      return "interrupted";
    case Report::State::check_failed:
      return "check failed";
    case Report::State::cannot_be_right:
      return "cannot be right";
  }
  return "";
}

Json json(const Statistics& s) {
  return {{"particles", s.particles},
          {"out_of_bounds", s.out_of_bounds},
          {"density", {{"mean", s.density_mean}, {"min", s.density_min}, {"max", s.density_max}}},
          {"density_error", {{"mean", s.density_error_mean}, {"max", s.density_error_max}}},
          {"speed", {{"mean", s.speed_mean}, {"max", s.speed_max}, {"fastest", s.fastest}}},
          {"height_mean", s.height_mean},
          {"kinetic_energy", s.kinetic_energy},
          {"potential_energy", s.potential_energy},
          {"momentum", s.momentum}};
}

Json json(const TimeSteps& t) {
  Json all{{"last", t.last},
           {"last_ruled", t.last_ruled},
           {"min", t.min},
           {"max", t.max},
           {"retried", t.retried}};
  if (!t.ruled.empty()) all["ruled"] = t.ruled;
  return all;
}

Json json(const SolveStatistics& s) {
  return {{"name", s.name},
          {"tolerance", s.tolerance},
          {"solves", s.solves},
          {"iterations", s.iterations},
          {"mean_iterations", s.mean_iterations()},
          {"most_iterations", s.most_iterations},
          {"not_converged", s.not_converged},
          {"last_iterations", s.last_iterations},
          {"last_error", s.last_error},
          {"worst_error", s.worst_error}};
}

Json json(const Flow& f) {
  return {{"kind", f.kind},       {"name", f.name},     {"particles", f.particles},
          {"waiting", f.waiting}, {"volume", f.volume}, {"rate", f.rate}};
}

Json json(const BodyState& b) {
  return {{"position", b.position}, {"orientation", b.orientation},
          {"velocity", b.velocity}, {"angular_velocity", b.angular_velocity},
          {"force", b.force},       {"torque", b.torque}};
}

Json json(const Warning& w) {
  return {{"kind", w.kind},
          {"cannot_be_right", w.cannot_be_right},
          {"message", w.message},
          {"first_step", w.first_step},
          {"first_time", w.first_time},
          {"last_step", w.last_step},
          {"looks", w.looks},
          {"bound", w.bound},
          {"worst", w.worst},
          {"worst_step", w.worst_step}};
}

}  // namespace

std::string to_json(const Report& r) {
  Json checks = Json::array(), solves = Json::array(), warnings = Json::array(),
       verbs = Json::array();
  for (const CheckResult& c : r.checks)
    checks.push_back({{"name", c.name},
                      {"value", c.value},
                      {"relation", c.relation},
                      {"bound", c.bound},
                      {"passed", c.passed}});
  for (const SolveStatistics& s : r.solves) solves.push_back(json(s));
  for (const Warning& w : r.warnings) warnings.push_back(json(w));
  for (const VerbTiming& v : r.verbs)
    verbs.push_back({{"name", v.name},
                     {"calls", v.calls},
                     {"seconds", v.seconds},
                     {"ns_per_particle", v.targets ? 1e9 * v.seconds / double(v.targets) : 0}});
  Json forces = Json::object();
  for (const auto& [name, force] : r.wall_forces) forces[name] = force;
  Json flows = Json::array();
  for (const Flow& f : r.flows) flows.push_back(json(f));
  Json bodies = Json::object();
  for (const auto& [name, body] : r.bodies) bodies[name] = json(body);
  Json all{{"freshet", FRESHET_VERSION},
           {"state", word(r.state)},
           {"scene", r.scene},
           {"title", r.title},
           {"solver", r.solver},
           {"backend", r.backend},
           {"steps", r.steps},
           {"time", r.time},
           {"seconds", r.seconds},
           {"steps_per_second", r.steps_per_second()},
           {"particle_steps_per_second", r.particle_steps_per_second()},
           {"time_steps", json(r.time_steps)},
           {"solves", solves},
           {"wall_forces", forces},
           {"flows", flows},
           {"statistics", json(r.statistics)},
           {"picture",
            {{"pixels", r.picture.pixels},
             {"bright", r.picture.bright},
             {"bright_fraction", r.picture.bright_fraction()},
             {"bottom_third", r.picture.bottom_third}}},
           {"checks", checks},
           {"warnings", warnings},
           {"verbs", verbs},
           {"state_sha256", r.state_sha256},
           {"kept_sha256", r.kept_sha256}};
  if (!r.bodies.empty()) all["bodies"] = bodies;
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace freshet
