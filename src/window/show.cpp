// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "io/files.h"
#include "render/png.h"
#include "scene/keys/keys.h"
#include "window/context.h"
#include "window/redraw.h"
#include "window/viewer.h"
#include "window/window.h"

namespace freshet::window {
namespace {

using Clock = std::chrono::steady_clock;

void open(view::Session& session, const Options& o) {
  session.set_pace(o.pace);
  if (!o.log.empty()) session.replay(view::read_log(o.log));
  else if (!o.path.empty()) session.open(o.path, o.overrides);
  if (o.steps > 0 && !o.panels) session.step(o.steps);
  if (o.play) session.play(true);
}

void set_look(Viewer& viewer, const Options& o) {
  if (!o.screenshot.empty()) viewer.look.water_detail = 1;
  viewer.show_pace(o.pace);
  if (o.water) viewer.look.style = gl::Style::water;
  for (std::size_t k = 0; k < std::size(color_by_words); ++k)
    if (o.color_by == color_by_words[k]) viewer.choose_color(ColorBy(k));
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A window, what it shows, and the time that its pictures take.
class Loop {
 public:
  Loop(view::Session& session, const Options& options)
      : options_(options),
        context_(options.width, options.height, options.screenshot.empty()),
        viewer_(session, context_.is_software()) {}

  Context& context() { return context_; }
  Viewer& viewer() { return viewer_; }
  const std::vector<double>& seconds() const { return seconds_; }
  /// How long to wait for the mouse and the keys before the next look for a snapshot [s]. Between
  /// snapshots, and after 30 pictures a second by software, the processor belongs to the
  /// simulation.
  double rest() const {
    if (seconds_.empty()) return 0;
    const double since = std::chrono::duration<double>(Clock::now() - begun_).count();
    const double by_software = software_ ? std::max(0.0, 1.0 / 30 - since) : 0;
    const double idle = viewer_.shown().playing ? 0.005 : 0.05;
    return std::max(by_software, idle);
  }

  /// Whether another picture would differ from the last.
  bool needs_picture() {
    const double now = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    const bool event = context_.take_event();
    return redraw_.wanted(viewer_.has_news(), event, now) || options_.pictures > 0;
  }

  /// One picture. `panels`: with what lies over it.
  void draw_picture(bool panels) {
    const auto start = begun_ = Clock::now();
    context_.begin_picture();
    const auto region = viewer_.region(context_.width(), context_.height());
    viewer_.update(region);
    if (!look_set_) set_look(viewer_, options_);
    look_set_ = true;
    viewer_.handle_input(region);
    viewer_.update(region);
    viewer_.draw(region);
    save_picture(region.left);
    if (panels) {
      viewer_.draw_color_bar();
      viewer_.draw_panels();
    }
    context_.draw_panels();
    if (options_.measure) context_.finish();
    if (viewer_.shown().scene)
      seconds_.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }

 private:
  /// Pictures and films are without panels.
  void save_picture(int left) {
    const std::string name = viewer_.take_picture_name();
    if (name.empty() && !viewer_.wants_record()) return;
    const Image image = context_.read(left);
    viewer_.record(image);
    if (name.empty()) return;
    try {
      write_file(name, encode_png(image));
      viewer_.note("wrote " + name);
    } catch (const Error& e) {
      viewer_.complain(e);
    }
  }

  const Options& options_;
  Context context_;
  Viewer viewer_;
  std::vector<double> seconds_;
  Clock::time_point begun_{};  // of the last picture
  Redraw redraw_;
  bool look_set_ = false, software_ = context_.is_software();
};

Result result_of(view::Session& session, Loop& loop) {
  Result r;
  r.renderer = loop.context().renderer();
  r.state_sha256 = session.state_sha256();
  const auto last = session.wait();
  r.steps = last->frame.step;
  r.time = last->frame.time;
  r.particles = last->frame.size();
  r.pictures = std::int64_t(loop.seconds().size());
  r.picture_seconds = median(loop.seconds());
  r.step_seconds = last->step_seconds;
  return r;
}

/// Writes the picture. An error names the option of this command, which has no `output`.
void write_screenshot(const std::string& file, const Image& image) {
  try {
    write_file(file, encode_png(image));
  } catch (const Error& e) {
    std::vector<Diagnostic> all = e.diagnostics();
    for (Diagnostic& d : all) {
      const std::string named = "`output`";
      if (const auto at = d.message.find(named); at != std::string::npos)
        d.message.replace(at, named.size(), "`screenshot`");
      d.options = {"screenshot"};
    }
    throw Error(e.kind(), std::move(all));
  }
}

void take_screenshot(view::Session& session, Loop& loop, const Options& o) {
  const auto ready = session.wait();
  if (!ready->problems.empty()) throw Error(Error::Kind::scene, ready->problems);
  // plots grow from picture to picture, and panels have their size from the second one on
  const std::int64_t parts = o.panels ? std::clamp<std::int64_t>(o.steps, 3, 60) : 1;
  for (std::int64_t k = 0; k < parts; ++k) {
    if (o.panels) session.step(o.steps * (k + 1) / parts - o.steps * k / parts);
    session.wait();
    loop.draw_picture(o.panels);
  }
  const auto last = session.wait();
  if (!last->problems.empty()) throw Error(Error::Kind::run, last->problems);
  const Image image = loop.context().read();
  write_screenshot(o.screenshot, image);
}

}  // namespace

Result show(const Options& o) {
  view::Session session(o.execution);
  Loop loop(session, o);
  open(session, o);
  if (!o.screenshot.empty()) {
    take_screenshot(session, loop, o);
    return result_of(session, loop);
  }
  std::int64_t drawn = 0;
  std::string title;
  while (!loop.context().closed() && !loop.viewer().closing) {
    if (loop.context().minimized()) {
      loop.context().poll(0.2);
      continue;
    }
    loop.context().poll(loop.rest());
    for (const auto& path : loop.context().take_dropped()) session.open(path);
    if (!loop.needs_picture()) continue;
    loop.draw_picture(true);
    loop.context().swap();
    if (const std::string now = loop.viewer().title(); now != title)
      loop.context().set_title(title = now);
    const view::Snapshot& shown = loop.viewer().shown();
    if (shown.scene) ++drawn;
    else if (o.pictures > 0 && !shown.problems.empty())
      throw Error(Error::Kind::scene, shown.problems);
    if (o.pictures > 0 && drawn >= o.pictures) loop.context().close();
  }
  session.play(false);
  return result_of(session, loop);
}

}  // namespace freshet::window
