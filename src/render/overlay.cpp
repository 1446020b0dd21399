// SPDX-License-Identifier: MIT
#include "render/overlay.h"

#include <cairo/cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "render/axis.h"
#include "render/font.h"
#include "scene/model/picture_layout.h"

namespace freshet {
namespace {

constexpr double longest_bar = 0.25;  // fraction of the picture's width
constexpr double ground_opacity = 0.6;
constexpr double color_bar_height = 0.75;  // fraction of the picture's height

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/// A transparent layer over the picture.
class Sheet {
 public:
  Sheet(Image& image, Color ground, double font_size)
      : size(font_size),
        image_(image),
        surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height),
                 cairo_surface_destroy),
        context_(cairo_create(surface_.get()), cairo_destroy),
        ground_(ground),
        ink_(is_light(ground) ? Color{20, 20, 24} : Color{240, 240, 245}) {
    cairo_set_font_face(c(), font_.get());
    cairo_set_font_size(c(), size);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(c(), options);
    cairo_font_options_destroy(options);
  }

  double width_of(const std::string& words) {
    cairo_text_extents_t e;
    cairo_text_extents(c(), words.c_str(), &e);
    return e.x_advance;
  }
  /// Writes text from x on, with its baseline at y.
  void write(double x, double y, const std::string& words) {
    ink();
    cairo_move_to(c(), x, y);
    cairo_show_text(c(), words.c_str());
  }
  /// Writes text upwards, with its middle at y and its baseline at x.
  void write_upwards(double x, double y, const std::string& words) {
    cairo_save(c());
    cairo_translate(c(), x, y + width_of(words) / 2);
    cairo_rotate(c(), -std::acos(0.0));
    write(0, 0, words);
    cairo_restore(c());
  }
  void fill(double x, double y, double width, double height, Color color, double opacity = 1) {
    cairo_set_source_rgba(c(), color.r / 255.0, color.g / 255.0, color.b / 255.0, opacity);
    cairo_rectangle(c(), x, y, width, height);
    cairo_fill(c());
  }
  void scale_font(double factor) { cairo_set_font_size(c(), factor * size); }
  /// Draws a translucent background for text.
  void panel(double x, double y, double width, double height) {
    fill(x, y, width, height, ground_, ground_opacity);
  }
  Color ink_color() const { return ink_; }

  /// Blends the layer over the picture.
  void lay() {
    cairo_surface_flush(surface_.get());
    const unsigned char* rows = cairo_image_surface_get_data(surface_.get());
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < image_.height; ++y)
      for (int x = 0; x < image_.width; ++x) {
        std::uint32_t argb;  // premultiplied
        std::copy_n(rows + y * stride + 4 * x, 4, reinterpret_cast<unsigned char*>(&argb));
        const unsigned through = 255 - (argb >> 24);
        if (through == 255) continue;
        const auto over = [&](std::uint8_t below, unsigned above) {
          return std::uint8_t(std::min(255u, above + (below * through + 127) / 255));
        };
        Color& p = image_.at(x, y);
        p = {over(p.r, argb >> 16 & 255), over(p.g, argb >> 8 & 255), over(p.b, argb & 255)};
      }
  }

  const double size;  ///< font size [px]

 private:
  cairo_t* c() { return context_.get(); }
  void ink() { cairo_set_source_rgb(c(), ink_.r / 255.0, ink_.g / 255.0, ink_.b / 255.0); }

  Image& image_;
  Surface surface_;
  Context context_;
  Font font_ = load_font(false);
  Color ground_, ink_;
};

/// The horizontal scale of a 2D picture [px/m].
double metre_in(const Scene& s, const PictureLayout& layout) {
  const PictureRegion region = picture_region(s);
  const double across = (layout.view.width - 2 * picture_margin) / region.extent(0);
  const double up = (layout.view.height - 2 * picture_margin) / region.extent(1);
  return s.picture.stretch ? across : std::min(across, up);
}

/// Draws the time stamp on a panel. Returns the panel's bottom.
double draw_time(Sheet& sheet, double top, const std::string& words) {
  const double em = sheet.size;
  sheet.panel(0.8 * em, top, sheet.width_of(words) + em, 1.7 * em);
  sheet.write(1.3 * em, top + 1.2 * em, words);
  return top + 1.7 * em;
}

void draw_scale(Sheet& sheet, double top, double metre, double most) {
  const double em = sheet.size, length = round_length(most / metre), wide = length * metre;
  const std::string words = fmt::format("{:g} m", length);
  sheet.panel(0.8 * em, top, std::max(wide, sheet.width_of(words)) + em, 2.4 * em);
  const double x = 1.3 * em, y = top + 1.9 * em;
  sheet.write(x + std::max(0.0, wide - sheet.width_of(words)) / 2, top + 1.2 * em, words);
  sheet.fill(x, y, wide, 2, sheet.ink_color());
  for (const double end : {x, x + wide - 2}) sheet.fill(end, y - 3, 2, 8, sheet.ink_color());
}

/// Draws the colours, their values and the quantity in the strip right of the view.
void draw_colors(Sheet& sheet, const PictureLayout& layout, const Coloring& c) {
  const double em = sheet.size, tall = std::floor(color_bar_height * layout.height);
  const double y = std::floor((layout.height - tall) / 2);
  const double x = std::ceil(layout.width - layout.color_bar + 0.5 * em), wide = std::ceil(em);
  for (int k = 0; k < int(tall); ++k)
    sheet.fill(x, y + k, wide, 1, c.at(1 - (float(k) + 0.5f) / float(tall)));
  const Ticks ticks =
      ticks_of({double(c.low), double(c.high)}, std::clamp(int(tall / em / 3), 2, 6));
  const double room = layout.color_bar - wide - 2.7 * em;
  double words = room;
  for (const std::string& label : ticks.labels) words = std::max(words, sheet.width_of(label));
  sheet.scale_font(room / words);
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    const double at = (ticks.values[k] - double(c.low)) / double(c.high - c.low);
    sheet.write(x + wide + 0.4 * em, y + tall * (1 - at) + 0.35 * em * room / words,
                ticks.labels[k]);
  }
  const std::string title = with_factor(c.label, ticks.factor);
  sheet.scale_font(std::min(1.0, layout.height / (sheet.width_of(title) * words / room)));
  sheet.write_upwards(layout.width - 0.6 * em, layout.height / 2.0, title);
}

}  // namespace

std::string time_words(double time, double end) {
  const int decimals = std::clamp(2 - int(std::floor(std::log10(end))), 0, 9);
  return fmt::format("t = {:.{}f} s", time, decimals);
}

double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double k : {5, 2})
    if (k * power <= most * (1 + 1e-9)) return k * power;
  return power;
}

void draw_overlays(Image& image, const Scene& scene, double time, const Coloring& colors) {
  const auto& p = scene.picture;
  if (!p.time_stamp && !p.scale_bar && !p.color_bar) return;
  const PictureLayout layout = picture_layout(scene);
  Sheet sheet(image, ground_color(scene), layout.font_size());
  double top = 0.8 * sheet.size;
  if (p.time_stamp)
    top = draw_time(sheet, top, time_words(time, scene.time.end)) + 0.5 * sheet.size;
  if (p.scale_bar) draw_scale(sheet, top, metre_in(scene, layout), longest_bar * image.width);
  if (p.color_bar) draw_colors(sheet, layout, colors);
  sheet.lay();
}

}  // namespace freshet
