// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace freshet {

/// Points (x, y) of a panel, joined to a line or marked with small circles. A point that is not
/// finite breaks the line.
struct Series {
  enum class Style { solid, dashed, dotted, dash_dot, points };
  std::string name;  ///< in the legend; empty: no legend entry
  std::vector<double> x, y;
  Style style = Style::solid;
  int color = -1;  ///< index of one of eight colours; -1: by its place in the panel
};

/// A pair of axes. Labels have quantity and unit, as in "speed [m/s]".
struct Panel {
  std::string title, x_label, y_label;  ///< an empty title takes no room
  std::vector<Series> series;
};

/// Panels, one below the other.
struct Chart {
  std::string title;
  /// The meaning of each line style, drawn below the title.
  std::vector<std::pair<Series::Style, std::string>> styles;
  std::vector<Panel> panels;
  bool shared_x = true;  ///< one range of x for all panels, with numbers below the last one only
};

/// The bytes of an SVG file, and of a PNG file with two pixels per point. Equal charts give equal
/// bytes. Text is UTF-8. Throws Error (kind run) if the drawing fails.
std::string chart_svg(const Chart& chart);
std::string chart_png(const Chart& chart);

}  // namespace freshet
