#include "eval/figures/cell_rows.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "eval/bench/open_scene.h"
#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

std::string settingOf(const Result& r) {
  return r.method + '@' + std::to_string(r.spp);
}

// Empty for what is unknown.
std::string number(double value) {
  return std::isnan(value) ? "" : format("%g", value);
}

std::string timesText(double ratio) {
  return format("%.3gx", ratio);
}

// "0.83x"; in brackets if it does not count.
std::string ratioText(const Ratio& ratio) {
  if (std::isnan(ratio.value)) return "(-)";
  const std::string text = timesText(ratio.value);
  return ratio.mark == Mark::kNone ? text : '(' + text + ')';
}

// Columns that stand behind the compared ones: no ratio tells which of two shares is better.
constexpr std::array kShares{&Score::dI_share, &Score::dL_share};

template <class Figure>
std::string line(const std::string& name, Figure figure) {
  std::string text = format("  %-34s", name.c_str());
  for (const ComparedColumn& column : kComparedColumns) text += format(" %13s", figure(column).c_str());
  return text;
}

std::string heading() {
  std::string text = line("", [](const ComparedColumn& column) { return std::string(column.name); });
  for (const auto share : kShares) text += format(" %8s", columnOf(share).name);
  return text + '\n';
}

std::string figures(const Result& r) {
  std::string text =
      line(settingOf(r), [&](const ComparedColumn& column) { return format("%.4g", column.of(r)); });
  for (const auto share : kShares) text += format(" %8.3f", r.score.*share);
  return text + '\n';
}

std::string startOf(const std::string& cell, const Result& candidate) {
  return cell +
         format(",%g,%g,%g,", candidate.px_per_frame, candidate.reference_error, candidate.reference_events) +
         settingOf(candidate) + ',';
}

void addRow(std::ostringstream& csv, const std::string& cell, const ComparedCell& c, const Result& candidate,
            const ComparedColumn& column) {
  const Ratio ratio = ratioOf(candidate, c.baselines, column);
  csv << startOf(cell, candidate) << column.name << ',' << number(column.of(candidate)) << ','
      << (ratio.baseline ? settingOf(*ratio.baseline) : "") << ','
      << (ratio.baseline ? number(column.of(*ratio.baseline)) : "") << ',' << number(ratio.value) << ','
      << textOf(ratio.mark) << '\n';
}

}  // namespace

std::string csvOf(const std::vector<ComparedCell>& cells) {
  std::ostringstream csv;
  csv << "scene,motion,px_per_frame,frames,measured_px_per_frame,reference_error,reference_events,candidate,"
         "column,"
         "value,baseline,baseline_value,ratio,mark\n";
  for (const ComparedCell& c : cells) {
    const std::string cell = sceneName(c.cell.scene) + ',' + c.cell.motion + ',' +
                             format("%g", c.cell.px_per_frame) + ',' + c.cell.framesText();
    if (!c.left_out.empty()) csv << cell << ",,,,,,,,,,left out: " << c.left_out << '\n';
    for (const Result& candidate : c.candidates) {
      for (const ComparedColumn& column : kComparedColumns) addRow(csv, cell, c, candidate, column);
      for (const auto share : kShares)
        csv << startOf(cell, candidate) << columnOf(share).name << ',' << number(candidate.score.*share)
            << ",,,,\n";
    }
  }
  return csv.str();
}

std::string textOf(const ComparedCell& c) {
  if (!c.left_out.empty()) return c.cell.name() + ": left out: " + c.left_out + "\n\n";
  const Result& any = c.baselines.front();
  std::string text = c.cell.name() + format(
                                         ": %.3g px per frame; own error of the reference %.3f, and %.3g "
                                         "false and missed events each\n",
                                         any.px_per_frame, any.reference_error, any.reference_events);
  text += heading();
  for (const Result& r : c.baselines) text += figures(r);
  for (const Result& r : c.candidates) {
    text += figures(r);
    text += line("  over the better baseline",
                 [&](const ComparedColumn& column) { return ratioText(ratioOf(r, c.baselines, column)); }) +
            '\n';
  }
  return text + '\n';
}

std::string summaryText(const std::vector<ComparedCell>& cells, const std::vector<std::string>& candidates) {
  std::string text = "Over the better baseline, figure by figure: geometric mean, and largest ratio\n";
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    text += candidates[i] + '\n';
    for (const ComparedColumn& column : kComparedColumns) {
      const RatioSummary s = summarize(cells, i, column);
      text += format("  %-14s %8s  cells: %d", column.name, s.counted > 0 ? timesText(s.mean).c_str() : "-",
                     s.counted);
      if (s.marked > 0) text += format(", and %d in brackets", s.marked);
      if (s.counted > 0)
        text += format("; largest: %s in %s", timesText(s.largest).c_str(), s.largest_in.c_str());
      text += '\n';
    }
  }
  const auto left_out =
      std::count_if(cells.begin(), cells.end(), [](const ComparedCell& c) { return !c.left_out.empty(); });
  return left_out > 0
             ? text + format("left out: %zu of %zu cells\n", static_cast<std::size_t>(left_out), cells.size())
             : text;
}

}  // namespace saccade::eval
