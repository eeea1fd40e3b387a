#include "eval/figures/equal_time_rows.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

#include "eval/pictures/text.h"

namespace saccade::eval {
namespace {

using Row = EqualTimeRow;
// Rows of one scene and budget, by rising error; scenes in the order of their names.
using Ranking = std::map<std::string, std::map<double, std::vector<const Row*>>>;

bool fits(const Row& row) {
  return row.result.spp > 0;
}

double wrongEvents(const Row& row) {
  return row.result.score.false_events + row.result.score.missed_events;
}

Ranking rankingOf(const std::vector<Row>& rows) {
  Ranking ranking;
  for (const Row& row : rows) ranking[row.scene][row.budget].push_back(&row);
  for (auto& [scene, budgets] : ranking)
    for (auto& [budget, ranked] : budgets)
      std::stable_sort(ranked.begin(), ranked.end(), [](const Row* a, const Row* b) {
        return fits(*a) != fits(*b) ? fits(*a) : fits(*a) && wrongEvents(*a) < wrongEvents(*b);
      });
  return ranking;
}

std::string figures(const Row& row) {
  const Result& r = row.result;
  if (!fits(row)) return format("  %-22s nothing fits\n", row.method.c_str());
  return format("  %-22s %5d %6.2f %8.4f %8.4f %8.4f %8.4f %9.5f\n", row.method.c_str(), r.spp,
                r.cpu_ms / row.budget_ms, r.score.dI_l1, r.score.dL_l1, r.score.false_events,
                r.score.missed_events, r.score.sigma_dL);
}

std::string winner(const Row& row) {
  return format("`%s@%d` %.3f", row.method.c_str(), row.result.spp, wrongEvents(row));
}

// "`svgf@4` 0.12, then `relax@2` 0.15"
std::string bestTwo(const std::vector<const Row*>& ranked) {
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, ranked.size()); ++i)
    if (fits(*ranked[i])) text += (i > 0 ? ", then " : "") + winner(*ranked[i]);
  return text;
}

}  // namespace

std::string csvOf(const std::vector<Row>& rows) {
  std::ostringstream csv;
  csv << "scene,budget,budget_ms,method,spp,share";
  for (const ScoreColumn& column : kScoreColumns) csv << ',' << column.name;
  csv << '\n';
  for (const Row& row : rows) {
    csv << row.scene << ',' << row.budget << ',' << row.budget_ms << ',' << row.method << ','
        << row.result.spp << ',';
    if (fits(row)) csv << row.result.cpu_ms / row.budget_ms;
    for (const ScoreColumn& column : kScoreColumns) {
      csv << ',';
      if (fits(row)) csv << row.result.score.*column.value;
    }
    csv << '\n';
  }
  return csv.str();
}

std::string textOf(const std::vector<Row>& rows) {
  std::string text;
  for (const auto& [scene, budgets] : rankingOf(rows)) {
    for (const auto& [budget, ranked] : budgets) {
      text += format("%s, %g times the time of two paths: %.3g CPU ms per frame\n", scene.c_str(), budget,
                     ranked.front()->budget_ms);
      text += format("  %-22s %5s %6s %8s %8s %8s %8s %9s\n", "", "paths", "share", "dI_l1", "dL_l1", "false",
                     "missed", "sigma_dL");
      for (const Row* row : ranked) text += figures(*row);
    }
  }
  return text;
}

std::string markdownOf(const std::vector<Row>& rows) {
  const Ranking ranking = rankingOf(rows);
  if (ranking.empty()) return {};
  std::string head = "| scene |", rule = "|---|", body;
  for (const auto& [budget, ranked] : ranking.begin()->second)
    head += format(" %g times |", budget), rule += "---|";
  for (const auto& [scene, budgets] : ranking) {
    body += "| " + scene + " |";
    for (const auto& [budget, ranked] : budgets) body += " " + bestTwo(ranked) + " |";
    body += '\n';
  }
  return head + '\n' + rule + '\n' + body;
}

void writeEqualTimes(const std::vector<Row>& rows, const std::string& settings, const std::string& path) {
  std::printf("%s\n%s", textOf(rows).c_str(), markdownOf(rows).c_str());
  writeText(path, "# " + settings + '\n' + csvOf(rows));
  std::printf("wrote %s\n", path.c_str());
}

}  // namespace saccade::eval
