#include "eval/pictures/svg_chart.h"

#include <algorithm>
#include <cmath>

#include "eval/pictures/chart_labels.h"
#include "eval/pictures/format.h"
#include "eval/pictures/markup.h"

namespace saccade::eval {
namespace {

constexpr double kWidth = 450, kHeight = 320, kLeft = 64, kRight = 44, kTop = 30, kBottom = 44,
                 kMiddle = (kLeft + kWidth - kRight) / 2, kLegendRow = 20, kLegendChar = 6.6,
                 kParetoEntry = 120;
// Colours that the colour-blind can tell apart (Okabe and Ito).
constexpr const char* kColors[] = {"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                   "#e69f00", "#56b4e9", "#999999"};
constexpr const char* kReferenceColor = "#000000";

// What the legend says of the lines of one name.
struct Key {
  std::string name, color;
};

auto findKey(const std::vector<Key>& keys, const std::string& name) {
  return std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
}

std::string polyline(const std::vector<ChartPoint>& points, const ChartAxis& x, const ChartAxis& y,
                     const std::string& style) {
  std::string text = "<polyline fill=\"none\" " + style + " points=\"";
  for (const ChartPoint& p : points) text += format("%.1f,%.1f ", x(p.x), y(p.y));
  return text + "\"/>\n";
}

std::string drawAxes(const ChartPanel& panel, const ChartAxis& x, const ChartAxis& y) {
  std::string svg =
      format("<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"none\" stroke=\"#888\"/>\n", kLeft,
             kTop, kWidth - kLeft - kRight, kHeight - kTop - kBottom);
  for (double v : x.ticks()) {
    svg += format(
        "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%g\" y2=\"%g\" stroke=\"#ddd\"/><text x=\"%.1f\" y=\"%g\" "
        "text-anchor=\"middle\">%g</text>\n",
        x(v), x(v), kTop, kHeight - kBottom, x(v), kHeight - kBottom + 14, v);
  }
  for (double v : y.ticks()) {
    svg += format(
        "<line x1=\"%g\" x2=\"%g\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/><text x=\"%g\" y=\"%.1f\" "
        "text-anchor=\"end\">%g</text>\n",
        kLeft, kWidth - kRight, y(v), y(v), kLeft - 5, y(v) + 4, v);
  }
  svg += format("<text x=\"%g\" y=\"18\" text-anchor=\"middle\" font-weight=\"bold\">", kMiddle) +
         escapeMarkup(panel.title) + "</text>\n";
  svg += format("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\">", kMiddle, kHeight - 10) +
         escapeMarkup(panel.x_label) + "</text>\n";
  svg += format("<text transform=\"translate(13,%g) rotate(-90)\" text-anchor=\"middle\">", kHeight / 2) +
         escapeMarkup(panel.y_label) + "</text>\n";
  return svg;
}

std::string drawLine(const ChartLine& line, const std::string& color, const ChartAxis& x,
                     const ChartAxis& y) {
  std::string svg;
  if (line.style != LineStyle::kMarks)
    svg += polyline(line.points, x, y, "stroke=\"" + color + "\" stroke-width=\"1.5\"");
  if (line.style == LineStyle::kLine || line.style == LineStyle::kReference) return svg;
  for (const ChartPoint& p : line.points) {
    svg += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\">", x(p.x), y(p.y), color.c_str()) +
           "<title>" + escapeMarkup(line.name + " " + p.label) + "</title></circle>\n";
  }
  return svg;
}

std::string drawLabels(const ChartLine& line, const std::string& color, const ChartAxis& x,
                       const ChartAxis& y, LabelPlaces& places) {
  std::string svg;
  for (const ChartPoint& p : line.points) {
    if (p.label.empty()) continue;
    const double left = x(p.x) + 5;
    if (const auto baseline = places.take(left, y(p.y), p.label)) {
      svg += format("<text x=\"%.1f\" y=\"%.1f\" font-size=\"%g\" fill=\"%s\">", left, *baseline, kLabelSize,
                    color.c_str()) +
             escapeMarkup(p.label) + "</text>\n";
    }
  }
  return svg;
}

std::string drawPanel(const ChartPanel& panel, const std::vector<Key>& keys) {
  ChartAxis x(panel.x_scale, kLeft, kWidth - kRight), y(panel.y_scale, kHeight - kBottom, kTop);
  for (const ChartLine& line : panel.lines) {
    for (const ChartPoint& p : line.points) x.include(p.x), y.include(p.y);
  }
  std::string svg = drawAxes(panel, x, y);
  if (panel.pareto)
    svg += polyline(paretoFront(panel), x, y,
                    "stroke=\"#bbb\" stroke-width=\"7\" stroke-linejoin=\"round\" opacity=\"0.6\"");
  for (auto line = panel.lines.rbegin(); line != panel.lines.rend(); ++line)
    svg += drawLine(*line, findKey(keys, line->name)->color, x, y);
  LabelPlaces places;
  for (const ChartLine& line : panel.lines)
    svg += drawLabels(line, findKey(keys, line.name)->color, x, y, places);
  return svg;
}

// In the order of their first appearance.
std::vector<Key> keysOf(const std::vector<ChartPanel>& panels) {
  std::vector<Key> keys;
  std::size_t colors = 0;
  for (const ChartPanel& panel : panels) {
    for (const ChartLine& line : panel.lines) {
      if (findKey(keys, line.name) != keys.end()) continue;
      const bool reference = line.style == LineStyle::kReference;
      keys.push_back({line.name, reference ? kReferenceColor : kColors[colors++ % std::size(kColors)]});
    }
  }
  return keys;
}

// Rows of at most `width`, from `y` on; leaves there the last of them.
std::string drawLegend(const std::vector<Key>& keys, bool pareto, double width, double& y) {
  std::string svg;
  double x = kLeft;
  const auto startRowUnlessFits = [&](double entry) {
    if (x > kLeft && x + entry > width) x = kLeft, y += kLegendRow;
  };
  for (const Key& key : keys) {
    const double entry = 26 + kLegendChar * static_cast<double>(key.name.size());
    startRowUnlessFits(entry);
    svg += format("<circle cx=\"%g\" cy=\"%g\" r=\"4\" fill=\"%s\"/><text x=\"%g\" y=\"%g\">", x, y,
                  key.color.c_str(), x + 9, y + 4) +
           escapeMarkup(key.name) + "</text>\n";
    x += entry;
  }
  if (!pareto) return svg;
  startRowUnlessFits(kParetoEntry);
  return svg + format(
                   "<line x1=\"%g\" x2=\"%g\" y1=\"%g\" y2=\"%g\" stroke=\"#bbb\" stroke-width=\"7\"/><text "
                   "x=\"%g\" y=\"%g\">Pareto front</text>\n",
                   x, x + 20, y, y, x + 26, y + 4);
}

}  // namespace

std::vector<ChartPoint> paretoFront(const ChartPanel& panel) {
  std::vector<ChartPoint> all, front;
  for (const ChartLine& line : panel.lines) all.insert(all.end(), line.points.begin(), line.points.end());
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  for (const ChartPoint& p : all) {
    if (front.empty() || p.y < front.back().y) front.push_back(p);
  }
  return front;
}

std::string drawCharts(const std::vector<ChartPanel>& panels, int across) {
  const std::vector<Key> keys = keysOf(panels);
  const int count = static_cast<int>(panels.size()), down = (count + across - 1) / across;
  const double width = kWidth * std::min(across, count);
  double legend_end = kHeight * down + 8;
  const std::string legend = drawLegend(keys, panels.front().pareto, width, legend_end);
  const double height = legend_end + kLegendRow - 8;
  std::string svg = format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" "
      "font-family=\"sans-serif\" font-size=\"11\">\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      width, height, width, height);
  for (int i = 0; i < count; ++i) {
    svg += format("<g transform=\"translate(%g,%g)\">\n", kWidth * (i % across), kHeight * (i / across)) +
           drawPanel(panels[static_cast<std::size_t>(i)], keys) + "</g>\n";
  }
  return svg + legend + "</svg>\n";
}

}  // namespace saccade::eval
