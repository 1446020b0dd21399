// SPDX-License-Identifier: MIT
/// What a window shows of a session, and what the user does with it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "draw/painter.h"
#include "freshet/scene_keys.h"
#include "view/history.h"
#include "view/session.h"
#include "window/film.h"

namespace freshet::window {

/// A push that follows the mouse.
struct Drag {
  bool active = false;
  int body = -1;
  Point anchor{};   ///< the plane of the push faces the camera there [m]
  Point grabbed{};  ///< of the body, relative to its centre of mass [m]
  Point lagging{};  ///< follows the cursor [m]
};

class Viewer {
 public:
  Viewer(view::Session& session, bool software);

  /// The part of a window of this size that the panels leave [px].
  gl::Painter::Region region(int width, int height) const;
  /// Takes the newest snapshot; true if it is another than before.
  bool update(const gl::Painter::Region& region);
  /// Whether there is a newer snapshot.
  bool has_news() { return session_.newest() != shown_; }
  /// Handles the mouse and the keys that the panels do not take.
  void handle_input(const gl::Painter::Region& region);
  void draw_panels();
  void draw_color_bar();
  void draw(const gl::Painter::Region& region);
  /// Whether the present picture is one of a film.
  bool wants_record() const { return film_.wants(shown_->frame.time); }
  /// Adds a picture to the film, if one is recorded.
  void record(const Image& image);

  const view::Snapshot& shown() const { return *shown_; }
  std::string title() const;
  /// Takes the name of a picture that should be saved of the next frame; empty: none.
  std::string take_picture_name() { return std::exchange(picture_wanted_, {}); }
  void note(std::string words) { note_ = std::move(words); }
  void complain(const Error& error);

  gl::Look look;
  /// The field that colours show; the scene's if empty.
  void choose_color(std::optional<ColorBy> by) {
    color_by_ = by;
    colors_changed_ = true;
  }
  /// The pace that the panels show; 0: as fast as possible.
  void show_pace(double pace) {
    full_speed_ = pace == 0;
    if (pace > 0) pace_ = float(pace);
  }
  bool panels = true;
  bool closing = false;

 private:
  void show_scene();
  void color_frame();
  // Panels
  void side_panel();
  void run_panel();
  void progress_line();
  void timeline();
  void look_panel();
  void slice_controls();
  void camera_controls();
  void push_controls();
  void keys_panel();
  void key_row(const SceneKey& key);
  bool edit_value(const SceneKey& key, std::string& value);
  void plots_panel();
  void plot(const std::string& name, const std::vector<float>& times,
            const std::vector<float>& values) const;
  void particle_panel();
  void files_panel();
  void problems_panel();
  // Input
  void handle_keys();
  void fit();
  void drag_push(double x, double y, double aspect);
  void begin_push(double x, double y, double aspect);
  void end_push();
  void click(double x, double y, double aspect);

  view::Session& session_;
  gl::Painter painter_;
  std::shared_ptr<const view::Snapshot> shown_;
  std::shared_ptr<const Scene> scene_;  // of the painter
  view::Stage stage_;
  Scene coloring_scene_;  // with the colours that are chosen
  std::string name_;
  view::Camera camera_;
  view::History history_;
  std::optional<ColorBy> color_by_;
  ColorRanges ranges_;
  std::uint64_t ranges_run_ = 0;
  Coloring coloring_;
  std::optional<std::uint64_t> selected_;  // id of a particle
  std::vector<std::size_t> neighbors_;
  std::vector<SceneKey> keys_;
  std::string key_filter_;
  std::string edited_key_, edited_value_;
  double last_change_ = 0;
  std::vector<std::string> plotted_;
  Drag drag_;
  float push_radius_ = 0, push_strength_ = 0;
  float panel_width_ = 0;  // [pixels of the window]; 0: not drawn yet
  double aspect_ = 1;
  bool moved_ = false;  // the camera, by the user
  float pace_ = 1;
  bool full_speed_ = false, background_of_scene_ = true;
  std::optional<int> map_;  // a ColorMap
  bool fixed_range_ = false;
  float range_[2] = {0, 1};
  double pressed_x_ = 0, pressed_y_ = 0;
  std::string scene_file_ = "changed.toml", checkpoint_file_ = "view.checkpoint",
              log_file_ = "actions.toml", picture_file_ = "view.png", film_file_ = "view.webp",
              open_file_;
  std::string picture_wanted_, note_;
  std::uint64_t notices_ = 0;
  std::vector<Diagnostic> own_problems_;
  Film film_;
  bool colors_changed_ = false;
};

}  // namespace freshet::window
