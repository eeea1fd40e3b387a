#include "stability/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/check.h"

namespace saccade::test {
namespace {

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", v);
  return std::isnan(v) ? "-" : text;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

const char* nameOf(double Figures::*figure) {
  const auto column = std::find_if(kFigureColumns.begin(), kFigureColumns.end(),
                                   [&](const FigureColumn& c) { return c.value == figure; });
  SACCADE_CHECK(column != kFigureColumns.end());
  return column->name;
}

// The judged figure, with its bound where one is claimed; the least is bold.
std::string cell(const StabilityCase& c, const std::string& method, double figure, double least) {
  std::string text = number(figure);
  if (figure == least) text = "**" + text + "**";
  if (const Claim* claim = claimOf(c, method)) text += " ≤ " + number(claim->bound);
  return text;
}

double least(const StabilityCase& c, const MethodFigures& figures) {
  double best = INFINITY;
  for (const auto& [method, f] : figures) best = std::min(best, f.*c.judged);
  return best;
}

// "event_svgf: svgf, pt; irradiance_cache: svgf"
std::string losses(const StabilityCase& c, const MethodFigures& figures) {
  std::vector<std::string> all;
  for (const Claim& claim : c.claims) {
    const auto better = betterThan(claim.method, c, figures);
    if (!better.empty()) all.push_back(claim.method + ": " + joined(better, ", "));
  }
  return joined(all, "; ");
}

std::string reasons(const StabilityCase& c) {
  std::string text = "- " + c.name + ": " + c.why + ".";
  for (const Claim& claim : c.claims)
    if (*claim.why) text += " " + claim.method + ": " + claim.why + ".";
  return text + "\n";
}

}  // namespace

std::string StabilityTable::csv() const {
  std::string text = "# " + settings_ + "\ncase,judged,method,bound";
  for (const FigureColumn& column : kFigureColumns) text += std::string(",") + column.name;
  text += ",clearly_better\n";
  for (const Row& row : rows_) {
    for (const auto& [method, f] : row.figures) {
      const Claim* claim = claimOf(row.of, method);
      text += row.of.name + "," + nameOf(row.of.judged) + "," + method + "," +
              (claim ? number(claim->bound) : "-");
      for (const FigureColumn& column : kFigureColumns) text += "," + number(f.*column.value);
      text += "," + joined(betterThan(method, row.of, row.figures), " ") + "\n";
    }
  }
  return text;
}

std::string StabilityTable::markdown() const {
  if (rows_.empty()) return {};
  std::string text = "# Stability\n\n" + settings_ +
                     "\n\nLess is better; the best is bold, and bounds stand behind ≤. Events are per "
                     "pixel-frame, drift is in log units.\n\n| case | figure |";
  for (const auto& [method, f] : rows_.front().figures) text += " " + method + " |";
  text += " clearly better |\n|---|---|";
  for (std::size_t i = 0; i <= rows_.front().figures.size(); ++i) text += "---|";
  for (const Row& row : rows_) {
    text += "\n| " + row.of.name + " | " + nameOf(row.of.judged) + " |";
    const double best = least(row.of, row.figures);
    for (const auto& [method, f] : row.figures)
      text += " " + cell(row.of, method, f.*row.of.judged, best) + " |";
    text += " " + losses(row.of, row.figures) + " |";
  }
  text += "\n\nWhy methods fail there, and why claimed methods lose:\n\n";
  for (const Row& row : rows_) text += reasons(row.of);
  return text;
}

}  // namespace saccade::test
