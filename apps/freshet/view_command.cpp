// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <filesystem>

#include "command.h"
#include "print.h"
#include "window/window.h"

namespace freshet::cli {
namespace {

struct ViewArguments : ChangeArguments {
  std::string name, solver, log, screenshot, color, style = "balls";
  std::int64_t steps = 0, pictures = 0;
  int width = 0, height = 0;
  double speed = 1;
  bool play = false, panels = false, report = false;
};

/// A finished run and a log of actions bring their own scene. Nothing is ignored silently.
void refuse_changes(const ViewArguments& a, const char* what) {
  if (a.overrides().empty() && a.solver.empty()) return;
  throw Error(Error::Kind::scene, a.solver.empty() ? "--set, --unset" : "--solver",
              fmt::format("these change a scene, not {}; leave them out", what));
}

window::Options options_of(const ViewArguments& a) {
  window::Options o;
  std::error_code ec;
  if (!a.log.empty()) refuse_changes(a, "a log of actions");
  else if (std::filesystem::is_directory(a.name, ec)) refuse_changes(a, "a finished run");
  if (!a.name.empty())
    o.path = std::filesystem::is_directory(a.name, ec) ? std::filesystem::path(a.name)
                                                       : find_scene(a.name);
  o.log = a.log;
  o.overrides = a.overrides();
  if (!a.solver.empty() && !o.path.empty()) {
    const SceneChange change = change_solver(o.path, a.solver, o.overrides);
    print_diagnostics(change.dropped);
    o.overrides = change.overrides;
  }
  o.execution = a.execution();
  o.play = a.play;
  o.pace = a.speed;
  if (a.width > 0) o.width = a.width;
  if (a.height > 0) o.height = a.height;
  o.screenshot = a.screenshot;
  o.steps = a.steps;
  o.panels = a.panels;
  o.water = a.style == "water";
  o.color_by = a.color;
  o.pictures = a.pictures;
  o.measure = a.report;
  return o;
}

int view_run(const ViewArguments& a) {
  const window::Result r = window::show(options_of(a));
  if (!a.screenshot.empty()) print_out("wrote {}\n", printable(a.screenshot));
  if (!a.report) return done;
  print_out("{} particles, step {}, {:.6g} s\n", r.particles, r.steps, r.time);
  print_out("{} pictures, {:.1f} ms each (median); {:.2f} ms a step; {}\n", r.pictures,
            1e3 * r.picture_seconds, 1e3 * r.step_seconds, r.renderer);
  if (!r.state_sha256.empty()) print_out("state_sha256 {}\n", r.state_sha256);
  return done;
}

}  // namespace

void add_view(Program& program) {
  const auto a = std::make_shared<ViewArguments>();
  const Command view = program.add("view", "Show a scene or a finished run in a window");
  const Option scene = view.option(
      "SCENE", a->name, "a scene file, the name of a bundled scene, or the folder of a run");
  view.option("--solver", a->solver,
              "another solver than the scene's; keys that it does not use are dropped")
      .one_of(solver_names());
  a->add_to(view);
  view.flag("--play", a->play, "do not wait for Play");
  view.option("--speed", a->speed,
              "simulated seconds per second at most (default: 1; 0: as fast as possible)")
      .range(0.0, 1e9);
  view.option("--replay", a->log, "repeat the actions that a window has saved, with their scene")
      .value("FILE")
      .excludes(scene);
  view.option("--steps", a->steps, "take so many steps, or show so many frames on, first")
      .at_least(0);
  view.option("--screenshot", a->screenshot, "write a picture, FILE.png, and end without a window")
      .value("FILE");
  view.flag("--panels", a->panels, "with the panels in the screenshot");
  view.option("--style", a->style, "how 3D scenes look first").one_of({"balls", "water"});
  view.option("--color", a->color, "the field that colours show first (default: the scene's)")
      .one_of({"speed", "velocity_x", "velocity_y", "velocity_z", "density", "density_error",
               "pressure", "height", "id", "liquid"});
  view.option("--width", a->width, "of the window [px] (default: 1280)").range(64, 16384);
  view.option("--height", a->height, "of the window [px] (default: 800)").range(64, 16384);
  view.option("--pictures", a->pictures, "close the window after so many pictures").at_least(1);
  view.flag("--report", a->report, "print the state and the times at the end");
  view.footer(
      "Space plays and pauses, S steps, R restarts, F fits the view, W switches to water, H hides "
      "the panels, P saves a picture. Drag to orbit, with the right button to pan; the wheel "
      "zooms. "
      "Drag with Shift to push the liquid or a free body. Click a particle to see its state.\n\n"
      "Examples:\n  freshet view dam_break_2d --play\n  freshet view runs/dam_break_3d --style "
      "water\n  freshet view dam_break_3d --steps 500 --screenshot still.png");
  view.action([a] { return view_run(*a); });
}

}  // namespace freshet::cli
