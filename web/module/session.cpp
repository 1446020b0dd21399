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

/// Appends a position of `dimension` numbers as three.
template <class T> void append(std::vector<float>& all, const T* x, int dimension) {
  for (int d = 0; d < 3; ++d) all.push_back(d < dimension ? float(x[d]) : 0);
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
      rest_densities_(rest_densities(sim_.scene())) {
  sort_walls();
}

void Session::sort_walls() {
  const int dimension = sim_.scene().dimension();
  const BoundaryForces all = sim_.boundary_forces();
  const int walls = int(sim_.scene().wall_names().size());
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all.part[i] >= 2 * dimension && all.part[i] < walls)
      append(walls_, &all.x[i * std::size_t(dimension)], dimension);
}

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

void Session::update_bodies() {
  drawn_.bodies.clear();
  if (sim_.scene().body.empty()) return;
  const int dimension = sim_.scene().dimension();
  const int walls = int(sim_.scene().wall_names().size());
  const BoundaryForces all = sim_.boundary_forces();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all.part[i] >= walls) append(drawn_.bodies, &all.x[i * std::size_t(dimension)], dimension);
}

void Session::update_foam(const WhitewaterFrame& foam) {
  drawn_.foam.clear();
  const int dimension = sim_.scene().dimension();
  for (std::size_t i = 0; i < foam.size(); ++i)
    append(drawn_.foam, &foam.x[i * std::size_t(dimension)], dimension);
}

const Session::Drawn& Session::update(ColorBy quantity) {
  const Scene& scene = sim_.scene();
  const Frame frame = sim_.frame();
  drawn_.x.clear();
  drawn_.values.clear();
  for (std::size_t i = 0; i < frame.size(); ++i) {
    append(drawn_.x, &frame.x[i * std::size_t(frame.dimension)], frame.dimension);
    drawn_.values.push_back(quantity_value(quantity, rest_densities_, frame, i));
  }
  include(ranges_, percentiles_of(scene, frame));
  ColorRange range;
  if (scene.is_article()) range = picture_limits(quantity, drawn_.values);
  else if (quantity == ColorBy::liquid)
    range = {0, float(std::max<std::size_t>(1, scene.liquids().size() - 1))};
  else {
    Scene shown = scene;
    shown.picture.color_by = quantity;
    range = color_limits(shown, ranges_[std::size_t(quantity)]);
  }
  drawn_.low = range.low;
  drawn_.high = range.high > range.low ? range.high : range.low + 1;
  update_bodies();
  update_foam(frame.whitewater);
  return drawn_;
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
