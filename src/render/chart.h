// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace freshet {

/// Points (x, y) of a panel, joined to a line or marked with small circles. What is no finite
/// number breaks the line.
struct Series {
  enum class Style { solid, dashed, dotted, dash_dot, points };
  std::string name;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  Style style = Style::solid;
  int color = -1;  ///< which of eight; -1: its place in the panel
};

/// A pair of axes. Labels say quantity and unit, as in "speed [m/s]".
struct Panel {
  std::string title, x_label, y_label;  ///< an empty title takes no room
  std::vector<Series> series;
};

/// Panels, one below the other.
struct Chart {
  std::string title;
  /// What each style of line stands for, told below the title.
  std::vector<std::pair<Series::Style, std::string>> styles;
  std::vector<Panel> panels;
  bool shared_x = true;  ///< one range of x for all, its numbers below the last panel only
};

/// The bytes of an SVG file, and of a PNG file of two pixels a point: the same drawing, the same
/// bytes for the same chart. Words are UTF-8. Throws Error (kind run).
std::string chart_svg(const Chart& chart);
std::string chart_png(const Chart& chart);

}  // namespace freshet
