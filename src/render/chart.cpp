// SPDX-License-Identifier: MIT
#include "render/chart.h"

#include <cairo/cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

#include "core/utf8.h"
#include "freshet/error.h"
#include "render/axis.h"
#include "render/font.h"
#include "render/png.h"

namespace freshet {
namespace {

using Style = Series::Style;

// All lengths are in points (1/72 inch).
constexpr double width = 720, chart_margin = 12, gap = 12, least_height = 118;
constexpr double line_height = 15, title_height = 26, numbers_height = 20, label_height = 16;
constexpr double font_size = 10, sample_length = 22, tick_length = 4, most_of_legend = 170;
constexpr double pixels_a_point = 2;

/// Colours that colour-blind readers can distinguish [Okabe, Ito 2008].
constexpr double colors[][3] = {{0.000, 0.447, 0.698}, {0.835, 0.369, 0.000}, {0.000, 0.620, 0.451},
                                {0.800, 0.475, 0.655}, {0.902, 0.624, 0.000}, {0.337, 0.706, 0.914},
                                {0.000, 0.000, 0.000}, {0.550, 0.550, 0.550}};

struct Box {
  double left, top, right, bottom;
};

void require(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw Error(Error::Kind::run, "",
              std::string("cannot draw the chart: ") + cairo_status_to_string(status));
}

/// The height of a panel's axes, at least that of its legend.
double axes_height(const Panel& panel) {
  const auto names = std::count_if(panel.series.begin(), panel.series.end(),
                                   [](const Series& s) { return !s.name.empty(); });
  return std::max(least_height, line_height * double(names) + 4);
}

/// Whether the k-th panel has numbers and a label below it.
bool has_numbers(const Chart& chart, std::size_t k) {
  return !chart.shared_x || k + 1 == chart.panels.size();
}

/// The y coordinate of the first panel's top.
double head_height(const Chart& chart) {
  return chart_margin + (chart.title.empty() ? 0 : title_height) +
         (chart.styles.empty() ? 0 : line_height + 4);
}

double height_of(const Chart& chart) {
  double height = head_height(chart);
  for (std::size_t k = 0; k < chart.panels.size(); ++k)
    height += (chart.panels[k].title.empty() ? 0 : line_height) + axes_height(chart.panels[k]) +
              gap + (has_numbers(chart, k) ? numbers_height + label_height : 0);
  return height;
}

/// Draws a chart on any kind of Cairo surface.
class Drawing {
 public:
  Drawing(cairo_t* c, const Chart& chart) : c_(c), chart_(chart) {
    const std::unique_ptr<cairo_font_options_t, decltype(&cairo_font_options_destroy)> options(
        cairo_font_options_create(), cairo_font_options_destroy);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(c, options.get());
    font(false);
  }
  void draw();

 private:
  enum class Align { left, center, right };

  void font(bool bold);
  void gray(double level) { cairo_set_source_rgb(c_, level, level, level); }
  double text_width(const std::string& text) const;
  std::string fitted(std::string text, double most) const;
  void text(double x, double y, const std::string& words, Align align = Align::left);
  void upright(double x, double y, const std::string& words, double most);
  void stroke_style(const Series& s, std::size_t place);
  void circle(double x, double y);
  void sample(double x, double y, const Series& s, std::size_t place);

  void head();
  void measure();
  Range x_range(const Panel& panel) const;
  void panel(const Panel& p, bool numbers, const Box& box);
  void x_axis(const Panel& p, bool numbers, const Box& box);
  void y_axis(const Panel& p, const Box& box);
  void legend(const Panel& p, const Box& box);
  void series(const Series& s, std::size_t place, const Box& box);
  void line(const std::vector<double>& x, const std::vector<double>& y);

  cairo_t* c_;
  const Chart& chart_;
  Font plain_ = load_font(false), bold_ = load_font(true);
  double left_ = 0, right_ = width;  // ends of the x axes of all panels
  Range shared_x_, x_, y_;           // shared_x_: of all panels; x_, y_: of the current panel
};

void Drawing::font(bool bold) {
  cairo_set_font_face(c_, (bold ? bold_ : plain_).get());
  cairo_set_font_size(c_, bold ? font_size + 2 : font_size);
}

double Drawing::text_width(const std::string& words) const {
  cairo_text_extents_t extents;
  cairo_text_extents(c_, valid_utf8(words).c_str(), &extents);
  return extents.x_advance;
}

/// The text, cut to the width `most`.
std::string Drawing::fitted(std::string words, double most) const {
  if (text_width(words) <= most) return words;
  const auto continues = [&] { return (static_cast<unsigned char>(words.back()) & 0xC0) == 0x80; };
  do {
    while (!words.empty() && continues()) words.pop_back();
    if (!words.empty()) words.pop_back();
  } while (!words.empty() && text_width(words + "…") > most);
  return words + "…";
}

/// Draws text on a baseline at y.
void Drawing::text(double x, double y, const std::string& words, Align align) {
  const double share = align == Align::left ? 0 : align == Align::center ? 0.5 : 1;
  cairo_move_to(c_, x - share * text_width(words), y);
  cairo_show_text(c_, valid_utf8(words).c_str());
}

/// Draws text upwards, centred at (x, y).
void Drawing::upright(double x, double y, const std::string& words, double most) {
  cairo_save(c_);
  cairo_translate(c_, x, y);
  cairo_rotate(c_, -std::acos(0.0));
  text(0, 0, fitted(words, most), Align::center);
  cairo_restore(c_);
}

void Drawing::stroke_style(const Series& s, std::size_t place) {
  static constexpr double dashed[] = {5, 3}, dotted[] = {0.5, 3}, dash_dot[] = {6, 3, 0.5, 3};
  const std::size_t color = s.color < 0 ? place : std::size_t(s.color);
  const double* rgb = colors[color % std::size(colors)];
  cairo_set_source_rgb(c_, rgb[0], rgb[1], rgb[2]);
  cairo_set_line_width(c_, 1.4);
  cairo_set_line_join(c_, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(c_, s.style == Style::dashed ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
  if (s.style == Style::dashed) cairo_set_dash(c_, dashed, 2, 0);
  else if (s.style == Style::dotted) cairo_set_dash(c_, dotted, 2, 0);
  else if (s.style == Style::dash_dot) cairo_set_dash(c_, dash_dot, 4, 0);
  else cairo_set_dash(c_, nullptr, 0, 0);
}

void Drawing::circle(double x, double y) {
  cairo_new_sub_path(c_);
  cairo_arc(c_, x, y, 2.2, 0, 4 * std::acos(0.0));
}

void Drawing::sample(double x, double y, const Series& s, std::size_t place) {
  stroke_style(s, place);
  if (s.style == Style::points) {
    circle(x + sample_length / 2, y);
  } else {
    cairo_move_to(c_, x, y);
    cairo_line_to(c_, x + sample_length, y);
  }
  cairo_stroke(c_);
  cairo_set_dash(c_, nullptr, 0, 0);
}

void Drawing::head() {
  double y = chart_margin;
  gray(0);
  if (!chart_.title.empty()) {
    font(true);
    text(left_, y + 12, fitted(chart_.title, width - left_ - chart_margin));
    font(false);
    y += title_height;
  }
  double x = left_;
  for (const auto& [style, words] : chart_.styles) {
    sample(x, y + 3, {"", {}, {}, style, 7}, 0);
    gray(0);
    const double room = (width - left_ - chart_margin) / double(chart_.styles.size());
    const std::string cut = fitted(words, room - sample_length - 22);
    text(x + sample_length + 6, y + 7, cut);
    x += sample_length + text_width(cut) + 22;
  }
}

/// Measures the room for the numbers on the left and the legend on the right.
void Drawing::measure() {
  double numbers = 0, names = 0;
  for (const Panel& p : chart_.panels) {
    std::vector<double> all;
    for (const Series& s : p.series) {
      all.insert(all.end(), s.y.begin(), s.y.end());
      if (!s.name.empty()) names = std::max(names, sample_length + 6 + text_width(s.name));
    }
    for (const std::string& label : ticks_of(with_margin(range_of(all)), 5).labels)
      numbers = std::max(numbers, text_width(label));
  }
  left_ = chart_margin + label_height + numbers + 10;
  right_ = width - chart_margin - (names > 0 ? std::min(names, most_of_legend) + 12 : 0);
}

Range Drawing::x_range(const Panel& p) const {
  std::vector<double> all;
  for (const Series& s : p.series) all.insert(all.end(), s.x.begin(), s.x.end());
  return range_of(all);
}

void Drawing::draw() {
  gray(1);
  cairo_paint(c_);
  measure();
  head();
  std::vector<double> ends;
  for (const Panel& p : chart_.panels) {
    const Range r = x_range(p);
    ends.insert(ends.end(), {r.min, r.max});
  }
  shared_x_ = range_of(ends);
  double y = head_height(chart_);
  for (std::size_t k = 0; k < chart_.panels.size(); ++k) {
    const Panel& p = chart_.panels[k];
    if (!p.title.empty()) {
      gray(0);
      text(left_, y + 8, fitted(p.title, right_ - left_));
      y += line_height;
    }
    const bool numbers = has_numbers(chart_, k);
    const double bottom = y + axes_height(p);
    panel(p, numbers, {left_, y, right_, bottom});
    y = bottom + gap + (numbers ? numbers_height + label_height : 0);
  }
}

void Drawing::panel(const Panel& p, bool numbers, const Box& box) {
  std::vector<double> all;
  for (const Series& s : p.series) all.insert(all.end(), s.y.begin(), s.y.end());
  y_ = with_margin(range_of(all));
  x_ = chart_.shared_x ? shared_x_ : x_range(p);
  cairo_set_line_cap(c_, CAIRO_LINE_CAP_BUTT);
  x_axis(p, numbers, box);
  y_axis(p, box);
  for (std::size_t k = 0; k < p.series.size(); ++k) series(p.series[k], k, box);
  cairo_set_dash(c_, nullptr, 0, 0);
  gray(0.25);
  cairo_set_line_width(c_, 0.8);
  cairo_rectangle(c_, box.left, box.top, box.right - box.left, box.bottom - box.top);
  cairo_stroke(c_);
  legend(p, box);
}

void Drawing::x_axis(const Panel& p, bool numbers, const Box& box) {
  const Ticks ticks = ticks_of(x_, 8);
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    const double x = box.left + (ticks.values[k] - x_.min) / x_.span() * (box.right - box.left);
    gray(0.88);
    cairo_set_line_width(c_, 0.6);
    cairo_move_to(c_, x, box.top);
    cairo_line_to(c_, x, box.bottom);
    cairo_stroke(c_);
    if (!numbers) continue;
    gray(0.25);
    cairo_move_to(c_, x, box.bottom);
    cairo_line_to(c_, x, box.bottom + tick_length);
    cairo_stroke(c_);
    gray(0);
    text(x, box.bottom + numbers_height - 5, ticks.labels[k], Align::center);
  }
  if (!numbers) return;
  text((box.left + box.right) / 2, box.bottom + numbers_height + label_height - 5,
       with_factor(p.x_label, ticks.factor), Align::center);
}

void Drawing::y_axis(const Panel& p, const Box& box) {
  const Ticks ticks = ticks_of(y_, 5);
  for (std::size_t k = 0; k < ticks.values.size(); ++k) {
    const double y = box.bottom - (ticks.values[k] - y_.min) / y_.span() * (box.bottom - box.top);
    gray(ticks.values[k] == 0 ? 0.6 : 0.88);
    cairo_set_line_width(c_, 0.6);
    cairo_move_to(c_, box.left, y);
    cairo_line_to(c_, box.right, y);
    cairo_stroke(c_);
    gray(0.25);
    cairo_move_to(c_, box.left - tick_length, y);
    cairo_line_to(c_, box.left, y);
    cairo_stroke(c_);
    gray(0);
    text(box.left - tick_length - 3, y + 0.36 * font_size, ticks.labels[k], Align::right);
  }
  gray(0);
  upright(chart_margin + font_size - 2, (box.top + box.bottom) / 2,
          with_factor(p.y_label, ticks.factor), box.bottom - box.top);
}

void Drawing::legend(const Panel& p, const Box& box) {
  double y = box.top + font_size / 2 + 2;
  for (std::size_t k = 0; k < p.series.size(); ++k) {
    if (p.series[k].name.empty()) continue;
    sample(box.right + 12, y, p.series[k], k);
    gray(0);
    text(box.right + 12 + sample_length + 6, y + 0.36 * font_size,
         fitted(p.series[k].name, most_of_legend - sample_length - 6));
    y += line_height;
  }
}

void Drawing::series(const Series& s, std::size_t place, const Box& box) {
  const std::size_t n = std::min(s.x.size(), s.y.size());
  std::vector<double> x(n), y(n);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = box.left + (s.x[k] - x_.min) / x_.span() * (box.right - box.left);
    y[k] = box.bottom - (s.y[k] - y_.min) / y_.span() * (box.bottom - box.top);
  }
  stroke_style(s, place);
  if (s.style != Style::points) return line(x, y);
  for (std::size_t k = 0; k < n; ++k) {
    if (std::isfinite(x[k]) && std::isfinite(y[k])) circle(x[k], y[k]);
  }
  cairo_stroke(c_);
}

void Drawing::line(const std::vector<double>& x, const std::vector<double>& y) {
  bool drawing = false;
  for (const std::size_t k : places_seen(x, y)) {
    const bool finite = std::isfinite(x[k]) && std::isfinite(y[k]);
    if (finite && !drawing) cairo_move_to(c_, x[k], y[k]);
    if (finite) cairo_line_to(c_, x[k], y[k]);  // draws a single point as a dot
    drawing = finite;
  }
  cairo_stroke(c_);
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void draw_on(cairo_surface_t* surface, const Chart& chart, double scale) {
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> c(cairo_create(surface), cairo_destroy);
  require(cairo_status(c.get()));
  cairo_scale(c.get(), scale, scale);
  Drawing(c.get(), chart).draw();
  require(cairo_status(c.get()));
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  std::string bytes;
  const Surface surface(
      cairo_svg_surface_create_for_stream(append, &bytes, width, height_of(chart)),
      cairo_surface_destroy);
  draw_on(surface.get(), chart, 1);
  cairo_surface_finish(surface.get());
  require(cairo_surface_status(surface.get()));
  // Cairo numbers the surfaces of a process, which would make the bytes depend on earlier charts
  const std::string_view name = " id=\"surface";
  if (const auto at = bytes.find(name); at != std::string::npos)
    bytes.erase(at, bytes.find('"', at + name.size()) + 1 - at);
  return bytes;
}

std::string chart_png(const Chart& chart) {
  const int columns = int(pixels_a_point * width),
            rows = int(std::ceil(pixels_a_point * height_of(chart)));
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows),
                        cairo_surface_destroy);
  draw_on(surface.get(), chart, pixels_a_point);
  cairo_surface_flush(surface.get());
  Image image(columns, rows, {255, 255, 255});
  const unsigned char* data = cairo_image_surface_get_data(surface.get());
  const auto stride = std::size_t(cairo_image_surface_get_stride(surface.get()));
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const unsigned char* pixel = data + std::size_t(y) * stride + 4 * std::size_t(x);
      image.at(x, y) = {pixel[2], pixel[1], pixel[0]};  // little-endian xRGB
    }
  return encode_png(image);
}

}  // namespace freshet
