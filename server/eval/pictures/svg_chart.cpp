#include "eval/pictures/svg_chart.h"

#include <algorithm>
#include <cmath>

#include "eval/pictures/chart_labels.h"
#include "eval/pictures/chart_legend.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

constexpr double kWidth = 450, kHeight = 320, kLeft = 64, kRight = 44, kTop = 30, kBottom = 44,
                 kMiddle = (kLeft + kWidth - kRight) / 2, kLegendTop = 14, kLegendMargin = 10;
constexpr int kAcross = 3;  // panels in a row

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

// From y - error to y + error, or to the foot of a logarithmic axis.
std::string drawErrorBar(const ChartPoint& p, const std::string& color, const ChartPanel& panel,
                         const ChartAxis& x, const ChartAxis& y) {
  if (!(p.error > 0)) return {};
  const bool hasFoot = panel.y_scale == Scale::kLinear || p.y > p.error;
  return format("<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x(p.x), x(p.x),
                y(p.y + p.error), hasFoot ? y(p.y - p.error) : kHeight - kBottom, color.c_str());
}

bool hasMarks(const ChartLine& line) {
  return line.style == LineStyle::kLineAndMarks || line.style == LineStyle::kMarks;
}

std::string drawLine(const ChartLine& line, const std::string& color, const ChartPanel& panel,
                     const ChartAxis& x, const ChartAxis& y) {
  std::string svg;
  if (line.style != LineStyle::kMarks)
    svg += polyline(line.points, x, y, "stroke=\"" + color + "\" stroke-width=\"1.5\"");
  if (!hasMarks(line)) return svg;
  for (const ChartPoint& p : line.points) {
    svg += drawErrorBar(p, color, panel, x, y);
    svg += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\">", x(p.x), y(p.y), color.c_str()) +
           "<title>" + escapeMarkup(line.name + " " + p.label) + "</title></circle>\n";
  }
  return svg;
}

std::string drawLabels(const ChartPanel& panel, const std::vector<ChartKey>& keys, const ChartAxis& x,
                       const ChartAxis& y) {
  LabelPlaces places;
  for (const ChartLine& line : panel.lines) {
    if (!hasMarks(line)) continue;
    for (const ChartPoint& p : line.points) places.avoid(x(p.x), y(p.y));
  }
  std::string svg;
  for (const ChartLine& line : panel.lines) {
    for (const ChartPoint& p : line.points) {
      if (p.label.empty()) continue;
      const auto place = places.take(x(p.x), y(p.y), p.label);
      if (!place) continue;
      svg += format("<text x=\"%.1f\" y=\"%.1f\" font-size=\"%g\" fill=\"%s\">", place->left, place->baseline,
                    kLabelSize, colorOf(keys, line.name).c_str()) +
             escapeMarkup(p.label) + "</text>\n";
    }
  }
  return svg;
}

std::string drawNothingMeasured() {
  return format("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\" fill=\"#888\">not measured here</text>\n",
                kMiddle, kHeight / 2);
}

std::string drawPanel(const ChartPanel& panel, const std::vector<ChartKey>& keys) {
  ChartAxis x(panel.x_scale, kLeft, kWidth - kRight), y(panel.y_scale, kHeight - kBottom, kTop);
  for (const ChartLine& line : panel.lines) {
    for (const ChartPoint& p : line.points) {
      x.include(p.x), y.include(p.y + p.error);
      y.include(panel.y_scale == Scale::kLinear || p.y > p.error ? p.y - p.error : p.y);
    }
  }
  std::string svg = drawAxes(panel, x, y);
  if (std::ranges::all_of(panel.lines, [](const ChartLine& line) { return line.points.empty(); }))
    return svg + drawNothingMeasured();
  if (panel.pareto)
    svg += polyline(paretoFront(panel), x, y,
                    "stroke=\"#bbb\" stroke-width=\"7\" stroke-linejoin=\"round\" opacity=\"0.6\"");
  for (auto line = panel.lines.rbegin(); line != panel.lines.rend(); ++line)
    svg += drawLine(*line, colorOf(keys, line->name), panel, x, y);
  return svg + drawLabels(panel, keys, x, y);
}

}  // namespace

std::vector<ChartPoint> paretoFront(const ChartPanel& panel) {
  std::vector<ChartPoint> all, front;
  for (const ChartLine& line : panel.lines) {
    if (line.style == LineStyle::kReference) continue;
    all.insert(all.end(), line.points.begin(), line.points.end());
  }
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  for (const ChartPoint& p : all) {
    if (front.empty() || p.y < front.back().y) front.push_back(p);
  }
  return front;
}

std::string drawCharts(const std::vector<ChartPanel>& panels, int per_group) {
  const int count = static_cast<int>(panels.size());
  const int rows = (per_group + kAcross - 1) / kAcross, across = (per_group + rows - 1) / rows;
  const double width = kWidth * std::min(across, count);
  const std::vector<ChartKey> keys = keysOf(panels);
  double top = kLegendTop;
  const std::string legend = drawLegend(keys, panels, kLeft, width, top);
  top += kLegendMargin;
  std::string svg;
  int down = 0;
  for (int i = 0; i < count; ++i) {
    const int place = i % per_group, row = i / per_group * rows + place / across;
    svg += format("<g transform=\"translate(%g,%g)\">\n", kWidth * (place % across), top + kHeight * row) +
           drawPanel(panels[static_cast<std::size_t>(i)], keys) + "</g>\n";
    down = row + 1;
  }
  const double height = top + kHeight * down;
  return format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" "
             "font-family=\"sans-serif\" font-size=\"11\">\n"
             "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
             width, height, width, height) +
         legend + svg + "</svg>\n";
}

}  // namespace saccade::eval
