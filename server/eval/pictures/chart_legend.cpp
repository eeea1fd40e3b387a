#include "eval/pictures/chart_legend.h"

#include <algorithm>

#include "base/check.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

// Colours that the colour-blind can tell apart: seven of Okabe and Ito, five of Tol.
constexpr const char* kColors[] = {"#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
                                   "#999999", "#882255", "#44aa99", "#332288", "#ddcc77", "#661100"};
constexpr const char* kReferenceColor = "#000000";
constexpr double kRow = 20, kSymbol = 26, kCharWidth = 6.6;

auto findKey(const std::vector<ChartKey>& keys, const std::string& name) {
  return std::find_if(keys.begin(), keys.end(), [&](const ChartKey& key) { return key.name == name; });
}

bool hasErrorBars(const ChartPanel& panel) {
  return std::any_of(panel.lines.begin(), panel.lines.end(), [](const ChartLine& line) {
    return std::any_of(line.points.begin(), line.points.end(), [](const auto& p) { return p.error > 0; });
  });
}

struct Entry {
  std::string symbol, name;  // the symbol is drawn around (0, 0)
};

std::vector<Entry> entriesOf(const std::vector<ChartKey>& keys, const std::vector<ChartPanel>& panels) {
  std::vector<Entry> entries;
  for (const ChartKey& key : keys)
    entries.push_back({"<circle r=\"4\" fill=\"" + key.color + "\"/>", key.name});
  if (std::any_of(panels.begin(), panels.end(), hasErrorBars))
    entries.push_back({"<line y1=\"-6\" y2=\"6\" stroke=\"#444\"/>", "standard error over seeds"});
  if (panels.front().pareto)
    entries.push_back({"<line x1=\"-8\" x2=\"5\" stroke=\"#bbb\" stroke-width=\"7\"/>", "Pareto front"});
  return entries;
}

}  // namespace

std::vector<ChartKey> keysOf(const std::vector<ChartPanel>& panels) {
  std::vector<ChartKey> keys;
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

const std::string& colorOf(const std::vector<ChartKey>& keys, const std::string& name) {
  const auto key = findKey(keys, name);
  SACCADE_CHECK(key != keys.end());
  return key->color;
}

std::string drawLegend(const std::vector<ChartKey>& keys, const std::vector<ChartPanel>& panels, double left,
                       double width, double& y) {
  std::string svg;
  double x = left;
  for (const Entry& entry : entriesOf(keys, panels)) {
    const double size = kSymbol + kCharWidth * static_cast<double>(entry.name.size());
    if (x > left && x + size > width) x = left, y += kRow;
    svg += format("<g transform=\"translate(%g,%g)\">", x, y) + entry.symbol + "<text x=\"9\" y=\"4\">" +
           escapeMarkup(entry.name) + "</text></g>\n";
    x += size;
  }
  return svg;
}

}  // namespace saccade::eval
