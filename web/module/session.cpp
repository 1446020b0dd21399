// SPDX-License-Identifier: MIT
#include "web/module/session.h"

#include <emscripten/emscripten.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "render/dots.h"
#include "web/module/json.h"

namespace freshet::web {
namespace {

std::vector<Override> overrides_in(const std::string& changes) {
  std::vector<Override> all;
  std::istringstream lines(changes);
  for (std::string line; std::getline(lines, line);) {
    const auto equal = line.find('=');
    if (line.empty()) continue;
    if (equal == std::string::npos) all.emplace_back(line, std::nullopt);
    else all.emplace_back(line.substr(0, equal), line.substr(equal + 1));
  }
  return all;
}

}  // namespace

Scene scene_of(const Request& request, std::vector<Diagnostic>& warnings) {
  std::vector<Override> overrides = overrides_in(request.changes);
  if (!request.solver.empty()) {
    const std::filesystem::path file = request.name;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << request.text;
    SceneChange change = change_solver(file, request.solver, overrides);
    overrides = std::move(change.overrides);
    warnings = std::move(change.dropped);
  }
  Scene scene = parse_scene(request.text, request.name, overrides);
  for (Diagnostic& d : scene_warnings(scene)) warnings.push_back(std::move(d));
  return scene;
}

std::string lines_of(const std::vector<Diagnostic>& diagnostics) {
  std::string lines;
  for (const Diagnostic& d : diagnostics) lines += d.text() + "\n";
  return lines;
}

Session::Session(const Request& request)
    : sim_(scene_of(request, warnings_), {1, ""}),
      derived_(derive(sim_.scene())),
      coloring_scene_(sim_.scene()),
      stage_(view::stage_of(sim_.scene())),
      packed_stage_(view::packed(stage_)) {}

void Session::step(int steps, double milliseconds, bool past_end) {
  const double end = emscripten_get_now() + milliseconds;
  int done = 0;
  while (done < steps && (past_end || !sim_.finished())) {
    sim_.step();
    ++done;
    if (emscripten_get_now() > end) break;
  }
  if (done) picture_.reset();
}

void Session::take_particles(const Session& other) {
  const ParticleView from = other.sim_.fluid();
  const ParticleView to = sim_.fluid();
  if (from.dimension != to.dimension || from.size() != to.size()) return;
  const std::size_t d = std::size_t(to.dimension);
  std::vector<std::size_t> place(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from.id[i] >= place.size()) return;
    place[from.id[i]] = i;
  }
  const std::vector<std::uint64_t> ids(to.id.begin(), to.id.end());
  const auto written = sim_.edit_fluid();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] >= place.size()) return;
    std::copy_n(&from.x[place[ids[i]] * d], d, &written.x[i * d]);
    std::copy_n(&from.v[place[ids[i]] * d], d, &written.v[i * d]);
  }
}

void Session::push(const Push& push) {
  double size2 = 0;
  for (const double a : push.acceleration) size2 += a * a;
  if (size2 == 0) return sim_.set_force({});
  sim_.set_force([push](const ParticleView& fluid, double, std::span<double> acceleration) {
    const std::size_t dimension = std::size_t(fluid.dimension);
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      double r2 = 0;
      for (std::size_t d = 0; d < dimension; ++d) {
        const double away = double(fluid.x[i * dimension + d]) - push.place[d];
        r2 += away * away;
      }
      const double share = std::max(0.0, 1 - r2 / (push.radius * push.radius));
      for (std::size_t d = 0; d < dimension; ++d)
        acceleration[i * dimension + d] = share * share * push.acceleration[d];
    }
  });
}

const view::Shown& Session::update(ColorBy quantity) {
  Scene::Picture& picture = coloring_scene_.picture;
  const Scene::Picture& own = sim_.scene().picture;
  const bool is_own = quantity == own.color_by;
  picture.color_by = quantity;
  picture.color_map = is_own ? own.color_map : std::nullopt;
  picture.color_range = is_own ? own.color_range : Vector{};
  const Frame frame = sim_.frame();
  include(ranges_, percentiles_of(sim_.scene(), frame));
  shown_ = view::shown_of(frame, color_particles(coloring_scene_, frame, ranges_), stage_);
  return shown_;
}

const Image& Session::picture() {
  if (!picture_) {
    if (sim_.scene().dimension() == 2) picture_ = draw_dots(sim_.scene(), sim_.frame());
    else picture_ = Image(0, 0, {0, 0, 0});
  }
  return *picture_;
}

std::string Session::about() const {
  const Scene& s = sim_.scene();
  Json json;
  json.add("title", s.title).add("dimension", s.dimension()).add("solver", s.method().name);
  json.add("reference", s.solver.backend == BackendName::reference).add("article", s.is_article());
  json.add("glow", s.picture.dots == Dots::glow).add("color_by", int(s.picture.color_by));
  json.add("min", s.domain.min).add("max", s.domain.max).add("window", s.picture.window);
  json.add("end", s.time.end).add("step", s.time.adaptive ? 0 : s.time.step);
  json.add("spacing", derived_.spacing).add("support", derived_.support_radius);
  json.add("mass", derived_.mass).add("rest_density", derived_.rest_density);
  json.add("neighbors", derived_.neighbors).add("lattice_sum", derived_.lattice_sum);
  json.add("density_error", derived_.density_error).add("gradient_error", derived_.gradient_error);
  json.add("stiffness", derived_.stiffness).add("sound_speed", derived_.sound_speed);
  json.add("acoustic_step", derived_.acoustic_step).add("force_step", derived_.force_step);
  json.add("viscous_step", derived_.viscous_step).add("step_bound", derived_.step_bound());
  json.add("step_bound_name", derived_.step_bound_name()).add("fastest", derived_.fastest);
  json.add("gravity", s.domain.gravity).add("restitution", s.walls.restitution);
  if (!s.fluid.empty())
    json.add("viscosity", s.fluid[0].viscosity)
        .add("count", std::vector<double>(s.fluid[0].count.begin(), s.fluid[0].count.end()));
  json.add("particles", derived_.particles).add("wall_particles", derived_.wall_particles);
  json.add("warnings", lines_of(warnings_)).add("source", s.source);
  return json.text();
}

std::string Session::picture_pixels() {
  const PictureStatistics s = picture_statistics(picture());
  return Json()
      .add("pixels", s.pixels)
      .add("bright", s.bright)
      .add("bottom_third", s.bottom_third)
      .text();
}

std::string Session::state() const {
  const Statistics s = sim_.statistics();
  Json json;
  json.add("steps", sim_.steps_done()).add("time", sim_.time()).add("finished", sim_.finished());
  json.add("dt", sim_.time_steps().last).add("ruled", sim_.time_steps().last_ruled);
  json.add("particles", s.particles).add("outside", s.out_of_bounds);
  json.add("density_mean", s.density_mean).add("density_min", s.density_min);
  json.add("density_max", s.density_max).add("density_error", s.density_error_mean);
  json.add("speed_mean", s.speed_mean).add("speed_max", s.speed_max);
  json.add("height_mean", s.height_mean).add("kinetic_energy", s.kinetic_energy);
  json.add("potential_energy", s.potential_energy);
  std::string solves;
  for (const SolveStatistics& v : sim_.solves())
    solves += Json()
                  .add("name", v.name)
                  .add("iterations", v.last_iterations)
                  .add("mean", v.mean_iterations())
                  .add("error", v.last_error)
                  .text() +
              ",";
  json.add_list("solves", solves);
  std::string warnings;
  for (const Warning& w : sim_.warnings())
    warnings += Json()
                    .add("kind", w.kind)
                    .add("message", w.message)
                    .add("severe", w.cannot_be_right)
                    .text() +
                ",";
  json.add_list("warnings", warnings);
  return json.text();
}

}  // namespace freshet::web
