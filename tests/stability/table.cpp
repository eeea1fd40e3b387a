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

double least(const StabilityCase& c, const MethodFigures& figures) {
  double best = INFINITY;
  for (const auto& [method, f] : figures) best = std::min(best, f.*c.judged);
  return best;
}

}  // namespace

std::vector<std::string> betterThanOurs(const StabilityCase& c, const MethodFigures& figures) {
  const auto ours =
      std::find_if(figures.begin(), figures.end(), [](const auto& f) { return f.first == kOurs; });
  SACCADE_CHECK(ours != figures.end());
  std::vector<std::string> better;
  for (const auto& [method, f] : figures)
    if (f.*c.judged < kClearly * (ours->second.*c.judged)) better.push_back(method);
  return better;
}

std::string StabilityTable::csv() const {
  std::string text = "# " + settings_ + "\ncase,judged,bound,method";
  for (const FigureColumn& column : kFigureColumns) text += std::string(",") + column.name;
  text += ",better_than_ours\n";
  for (const Row& row : rows_) {
    const auto better = betterThanOurs(row.of, row.figures);
    for (const auto& [method, f] : row.figures) {
      text += row.of.name + "," + nameOf(row.of.judged) + "," + number(row.of.bound) + "," + method;
      for (const FigureColumn& column : kFigureColumns) text += "," + number(f.*column.value);
      text += std::find(better.begin(), better.end(), method) == better.end() ? ",0\n" : ",1\n";
    }
  }
  return text;
}

std::string StabilityTable::markdown() const {
  if (rows_.empty()) return {};
  std::string text = "# Stability\n\n" + settings_ +
                     "\n\nLess is better; the best is bold. Events are per pixel-frame, drift is in log "
                     "units.\n\n| case | figure | ours at most |";
  for (const auto& [method, f] : rows_.front().figures) text += " " + method + " |";
  text += " ours is worse than |\n|---|---|---|";
  for (std::size_t i = 0; i <= rows_.front().figures.size(); ++i) text += "---|";
  for (const Row& row : rows_) {
    text += "\n| " + row.of.name + " | " + nameOf(row.of.judged) + " | " + number(row.of.bound) + " |";
    for (const auto& [method, f] : row.figures) {
      const std::string value = number(f.*row.of.judged);
      text += f.*row.of.judged == least(row.of, row.figures) ? " **" + value + "** |" : " " + value + " |";
    }
    text += " " + joined(betterThanOurs(row.of, row.figures), ", ") + " |";
  }
  text += "\n\nWhy methods fail there:\n\n";
  for (const Row& row : rows_)
    text += "- " + row.of.name + ": " + row.of.why + (*row.of.beaten_why ? ". Ours: " : "") +
            row.of.beaten_why + ".\n";
  return text;
}

}  // namespace saccade::test
