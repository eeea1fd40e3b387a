#include "eval/svg_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "eval/markup.h"

namespace saccade {
namespace {

constexpr double kWidth = 420, kHeight = 320, kLeft = 58, kRight = 14, kTop = 30, kBottom = 44,
                 kLegendRow = 20;
// Colours that the colour-blind can tell apart (Okabe and Ito).
constexpr const char* kColors[] = {"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                   "#e69f00", "#56b4e9", "#000000"};

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[512];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

// A logarithmic axis of whole steps 1, 2, 5 around the values.
class Axis {
 public:
  Axis(double first, double last) : first_(first), last_(last) {}
  void include(double v) { low_ = std::min(low_, v), high_ = std::max(high_, v); }
  double operator()(double v) const {
    const double low = std::log(low_ / 1.15), high = std::log(high_ * 1.15);
    return first_ + (last_ - first_) * (std::log(v) - low) / (high - low);
  }
  std::vector<double> ticks() const {
    std::vector<double> values;
    for (double decade = std::pow(10, std::floor(std::log10(low_))); decade <= high_ * 10; decade *= 10) {
      for (double step : {1.0, 2.0, 5.0}) {
        if (decade * step >= low_ / 1.15 && decade * step <= high_ * 1.15) values.push_back(decade * step);
      }
    }
    return values;
  }

 private:
  double first_, last_, low_ = std::numeric_limits<double>::infinity(), high_ = 0;
};

std::string polyline(const std::vector<ChartPoint>& points, const Axis& x, const Axis& y,
                     const std::string& style) {
  std::string text = "<polyline fill=\"none\" " + style + " points=\"";
  for (const ChartPoint& p : points) text += format("%.1f,%.1f ", x(p.x), y(p.y));
  return text + "\"/>\n";
}

std::string drawAxes(const ChartPanel& panel, const Axis& x, const Axis& y) {
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
  svg += format("<text x=\"%g\" y=\"18\" text-anchor=\"middle\" font-weight=\"bold\">", kWidth / 2) +
         escapeMarkup(panel.title) + "</text>\n";
  svg += format("<text x=\"%g\" y=\"%g\" text-anchor=\"middle\">", kWidth / 2, kHeight - 10) +
         escapeMarkup(panel.x_label) + "</text>\n";
  svg += format("<text transform=\"translate(13,%g) rotate(-90)\" text-anchor=\"middle\">", kHeight / 2) +
         escapeMarkup(panel.y_label) + "</text>\n";
  return svg;
}

std::string drawPanel(const ChartPanel& panel, const std::vector<std::string>& names) {
  Axis x(kLeft, kWidth - kRight), y(kHeight - kBottom, kTop);
  for (const ChartLine& line : panel.lines) {
    for (const ChartPoint& p : line.points) x.include(p.x), y.include(p.y);
  }
  std::string svg = drawAxes(panel, x, y);
  if (panel.pareto)
    svg += polyline(paretoFront(panel), x, y,
                    "stroke=\"#bbb\" stroke-width=\"7\" stroke-linejoin=\"round\" opacity=\"0.6\"");
  for (const ChartLine& line : panel.lines) {
    const auto index =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), line.name) - names.begin());
    const std::string color = kColors[index % std::size(kColors)];
    svg += polyline(line.points, x, y, "stroke=\"" + color + "\" stroke-width=\"1.5\"");
    for (const ChartPoint& p : line.points) {
      svg += format(
                 "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/><text x=\"%.1f\" y=\"%.1f\" "
                 "font-size=\"9\" fill=\"%s\">",
                 x(p.x), y(p.y), color.c_str(), x(p.x) + 5, y(p.y) - 4, color.c_str()) +
             escapeMarkup(p.label) + "</text>\n";
    }
  }
  return svg;
}

std::string drawLegend(const std::vector<std::string>& names, bool pareto, double y) {
  std::string svg;
  double x = kLeft;
  for (std::size_t i = 0; i < names.size(); ++i) {
    svg += format("<circle cx=\"%g\" cy=\"%g\" r=\"4\" fill=\"%s\"/><text x=\"%g\" y=\"%g\">", x, y,
                  kColors[i % std::size(kColors)], x + 9, y + 4) +
           escapeMarkup(names[i]) + "</text>\n";
    x += 26 + 7.2 * static_cast<double>(names[i].size());
  }
  if (!pareto) return svg;
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
  std::vector<std::string> names;  // in the order of their first appearance: one colour each
  for (const ChartPanel& panel : panels) {
    for (const ChartLine& line : panel.lines) {
      if (std::find(names.begin(), names.end(), line.name) == names.end()) names.push_back(line.name);
    }
  }
  const int count = static_cast<int>(panels.size()), down = (count + across - 1) / across;
  const double width = kWidth * std::min(across, count), height = kHeight * down + kLegendRow;
  std::string svg = format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%g\" height=\"%g\" viewBox=\"0 0 %g %g\" "
      "font-family=\"sans-serif\" font-size=\"11\">\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      width, height, width, height);
  for (int i = 0; i < count; ++i) {
    svg += format("<g transform=\"translate(%g,%g)\">\n", kWidth * (i % across), kHeight * (i / across)) +
           drawPanel(panels[static_cast<std::size_t>(i)], names) + "</g>\n";
  }
  return svg + drawLegend(names, panels.front().pareto, kHeight * down + 8) + "</svg>\n";
}

}  // namespace saccade
