// SPDX-License-Identifier: MIT
#include "render/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "freshet/error.h"
#include "render/png.h"

namespace freshet {
namespace {

constexpr const char *blue = "stroke:rgb(0%,44.7%,69.8%)", *red = "stroke:rgb(83.5%,36.9%,0%)";

Chart two_series() {
  Chart chart;
  chart.title = "A chart of things";
  chart.panels = {{"",
                   "time [s]",
                   "speed [m/s]",
                   {{"mean", {0, 1, 2, 3, 4}, {0, 1, NAN, 2, 3}},
                    {"measured", {0, 2, 4}, {3, 2, 1}, Series::Style::points}}}};
  return chart;
}

/// The SVG of a chart, parsed.
struct Svg {
  explicit Svg(const Chart& chart) { EXPECT_TRUE(document.load_string(chart_svg(chart).c_str())); }
  pugi::xml_document document;

  /// The paths of a colour: commands and coordinates.
  std::vector<std::string> paths(const std::string& stroke) const {
    std::vector<std::string> all;
    for (const auto& found : document.select_nodes("//*[local-name()='path']")) {
      const std::string style = found.node().attribute("style").value();
      if (style.find(stroke) != std::string::npos)
        all.push_back(found.node().attribute("d").value());
    }
    return all;
  }
  /// The number of letters of each text. Text is drawn as outlines, one <use> per letter.
  std::vector<int> text_lengths() const {
    std::vector<int> all;
    for (const auto& found : document.select_nodes("//*[local-name()='g'][*[local-name()='use']]"))
      all.push_back(int(std::distance(found.node().begin(), found.node().end())));
    return all;
  }
};

struct Mark {
  double x, y;
};

/// The vertices of a path of lines, each with its command.
std::vector<std::pair<char, Mark>> vertices(const std::string& path) {
  std::vector<std::pair<char, Mark>> all;
  std::istringstream in(path);
  char letter = 0;
  Mark p{};
  while (in >> letter >> p.x >> p.y) all.emplace_back(letter, p);
  return all;
}

TEST(Chart, NanBreaksALine) {
  const auto paths = Svg(two_series()).paths(blue);
  ASSERT_EQ(2u, paths.size());  // the curve and its line in the legend
  const auto line = vertices(paths[0]);
  ASSERT_EQ(4u, line.size());
  std::string letters;
  for (const auto& [letter, point] : line) letters += letter;
  EXPECT_EQ("MLML", letters);
  const double left = line[0].second.x, right = line[3].second.x;
  EXPECT_GT(right, left + 500);
  EXPECT_NEAR(left + (right - left) / 4, line[1].second.x, 1e-2);
  EXPECT_NEAR(left + (right - left) * 3 / 4, line[2].second.x, 1e-2);
  const double bottom = line[0].second.y, top = line[3].second.y;
  EXPECT_GT(bottom, top + 100);  // y points down
  EXPECT_NEAR(bottom + (top - bottom) / 3, line[1].second.y, 1e-2);
}

TEST(Chart, DrawsPointsAsDots) {
  const auto paths = Svg(two_series()).paths(red);
  ASSERT_EQ(2u, paths.size());
  EXPECT_EQ(3, std::count(paths[0].begin(), paths[0].end(), 'M'));
  EXPECT_EQ(1, std::count(paths[1].begin(), paths[1].end(), 'M'));
  EXPECT_EQ(0, std::count(paths[1].begin(), paths[1].end(), 'L'));
}

TEST(Chart, HasTitleAxesAndLegend) {
  // the title, 9 numbers below and "time [s]", 4 beside and "speed [m/s]", two names; spaces count
  // as letters
  EXPECT_EQ((std::vector<int>{17, 3, 3, 3, 3, 3, 3, 3, 3, 3, 8, 1, 1, 1, 1, 11, 4, 8}),
            Svg(two_series()).text_lengths());
}

TEST(Chart, LabelsLargeNumbersWithAFactor) {
  Chart chart = two_series();
  for (double& y : chart.panels[0].series[0].y) y *= 1e4;
  const auto lengths = Svg(chart).text_lengths();
  EXPECT_EQ(1, std::count(lengths.begin(), lengths.end(), 15)) << "speed [10³ m/s]";
  EXPECT_EQ(0, std::count(lengths.begin(), lengths.end(), 11));
}

TEST(Chart, SharesOneAxisAmongPanels) {
  Chart chart = two_series();
  chart.panels.push_back({"a title", "time [s]", "speed [m/s]", {{"", {2, 6}, {1, 2}}}});
  const auto numbers = [](const Svg& svg) {
    const auto lengths = svg.text_lengths();
    return std::count(lengths.begin(), lengths.end(), 8);  // "time [s]" and "measured"
  };
  const Svg shared(chart);
  EXPECT_EQ(2, numbers(shared));
  ASSERT_EQ(3u, shared.paths(blue).size());  // the unnamed series is not in the legend
  const auto first = vertices(shared.paths(blue)[0]), second = vertices(shared.paths(blue)[2]);
  EXPECT_NEAR(first[0].second.x + (first[3].second.x - first[0].second.x) / 2, second[0].second.x,
              1e-2);
  EXPECT_NEAR(second[0].second.x + (second[1].second.x - second[0].second.x) / 2, first[3].second.x,
              1e-2);

  chart.shared_x = false;
  const Svg apart(chart);
  EXPECT_EQ(3, numbers(apart));
  const auto own = vertices(apart.paths(blue)[2]);
  EXPECT_NEAR(vertices(apart.paths(blue)[0])[3].second.x, own[1].second.x, 1e-2);
}

TEST(Chart, DrawsDashedSeriesAndALegendOfStyles) {
  Chart chart = two_series();
  chart.panels[0].series[1].style = Series::Style::dashed;
  chart.panels[0].series[1].color = 0;
  chart.styles = {{Series::Style::solid, "run a"}, {Series::Style::dashed, "run b"}};
  const std::string svg = chart_svg(chart);
  std::size_t dashes = 0;
  for (auto at = svg.find("dasharray"); at != std::string::npos; at = svg.find("dasharray", at + 1))
    ++dashes;
  EXPECT_EQ(3u, dashes);  // the curve, its line in the legend, and the legend's line of run b
  EXPECT_EQ(4u, Svg(chart).paths(blue).size());
  EXPECT_TRUE(Svg(chart).paths(red).empty());
}

TEST(Chart, TruncatesLongNames) {
  Chart chart = two_series();
  std::string name;
  for (int k = 0; k < 100; ++k) name += "ü";
  chart.panels[0].series[0].name = name;
  const auto lengths = Svg(chart).text_lengths();
  const int longest = *std::max_element(lengths.begin(), lengths.end());
  EXPECT_GT(longest, 17);
  EXPECT_LT(longest, 30);
}

TEST(Chart, DrawsNamesThatAreNotUtf8) {  // the name of a folder may be of any bytes
  Chart chart = two_series(), marked = two_series();
  chart.panels[0].series[0].name = "\xff\xfe";
  marked.panels[0].series[0].name = "\uFFFD\uFFFD";
  EXPECT_EQ(chart_svg(chart), chart_svg(marked));
  EXPECT_EQ(chart_png(chart), chart_png(marked));
}

TEST(Chart, CanBeEmpty) {
  Chart chart;
  EXPECT_NO_THROW(chart_svg(chart));
  chart.panels.resize(2);
  chart.panels[1].series.push_back({"nothing", {}, {}});
  chart.panels[1].series.push_back({"nowhere", {NAN, 1}, {1, NAN}});
  EXPECT_NO_THROW(chart_svg(chart));
  EXPECT_NO_THROW(chart_png(chart));
}

TEST(Chart, SvgAndPngShowTheSameLine) {
  const Chart chart = two_series();
  const Svg svg(chart);
  const auto root = svg.document.document_element();
  const Image image = decode_png(chart_png(chart));
  EXPECT_EQ(image.width, int(2 * root.attribute("width").as_double()));
  EXPECT_EQ(image.height, int(std::ceil(2 * root.attribute("height").as_double())));
  EXPECT_EQ((Color{255, 255, 255}), image.pixels[0]);
  const auto at = [&](Mark p) {
    return image.pixels[std::size_t(2 * p.y) * std::size_t(image.width) + std::size_t(2 * p.x)];
  };
  const auto line = vertices(svg.paths(blue)[0]);
  const Mark a = line[0].second, b = line[1].second;
  EXPECT_EQ((Color{0, 114, 178}), at({(a.x + b.x) / 2, (a.y + b.y) / 2}));
}

TEST(Chart, HasTheSameBytesEachTime) {
  EXPECT_TRUE(chart_svg(two_series()) == chart_svg(two_series()));
  EXPECT_TRUE(chart_png(two_series()) == chart_png(two_series()));
}

}  // namespace
}  // namespace freshet
