#include "tables/accuracy_table.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <utility>

#include "base/default_cache.h"
#include "base/names.h"

namespace saccade {
namespace {

double errors(const MeasuredSetting& s) {
  return s.false_events + s.missed_events;
}

// The setting with the least `goal` among those with `cost` <= limit, and true. Without one: the setting with
// the least `cost`, and false.
template <class Cost, class Goal>
std::pair<MeasuredSetting, bool> leastWithin(const std::vector<MeasuredSetting>& settings, Cost cost,
                                             double limit, Goal goal) {
  const auto rank = [&](const MeasuredSetting& s) {
    const bool fits = cost(s) <= limit;
    return std::tuple(!fits, fits ? goal(s) : cost(s), cost(s));
  };
  const MeasuredSetting& best = *std::min_element(
      settings.begin(), settings.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return {best, cost(best) <= limit};
}

}  // namespace

std::string MeasuredSetting::text() const {
  return method.text + " at " + std::to_string(spp) + " spp";
}

std::vector<std::string> AccuracyTable::scenes() const {
  std::set<std::string> names;
  for (const MeasuredSetting& row : rows) names.insert(row.scene);
  return {names.begin(), names.end()};
}

std::string defaultAccuracyTable() {
  return defaultCache() + "/chart/results.csv";
}

std::vector<MeasuredSetting> settingsFor(const AccuracyTable& table, const SettingsQuery& rendering) {
  const double pixels = rendering.pixels / (static_cast<double>(table.width) * table.height);
  const double length = table.frames > 0 ? rendering.frames / table.frames : 1;
  const double rate = table.threshold / rendering.threshold;  // [E (34)]
  std::set<std::string> methods;                              // of the scene
  std::vector<MeasuredSetting> settings;
  for (MeasuredSetting row : table.rows) {
    if (row.scene != rendering.scene) continue;
    methods.insert(row.method.name);
    if (!rendering.method.empty() && row.method.name != rendering.method) continue;
    row.cpu_ms = timeAt({row.cpu_ms, row.small_ms, row.small_late_ms}, pixels, length);
    row.false_events *= rate, row.missed_events *= rate;
    settings.push_back(row);
  }
  if (!settings.empty()) return settings;
  if (!methods.empty()) {
    throw NotMeasured(rendering.method + " is not measured on " + rendering.scene +
                      "; measured are: " + joinNames(methods));
  }
  throw NotMeasured("no scene of this name is measured: " + rendering.scene +
                    "; measured are: " + joinNames(table.scenes()));
}

MeasuredSetting mostAccurate(const std::vector<MeasuredSetting>& settings, double budget_ms) {
  const auto [best, fits] = leastWithin(
      settings, [](const auto& s) { return s.cpu_ms; }, budget_ms, errors);
  if (fits) return best;
  std::ostringstream text;
  text << "the fastest setting here, " << best.text() << ", takes " << best.cpu_ms << " ms";
  throw NothingFits(text.str());
}

MeasuredSetting fastest(const std::vector<MeasuredSetting>& settings, double max_false_rate) {
  const auto [best, fits] = leastWithin(
      settings, [](const auto& s) { return s.false_events; }, max_false_rate,
      [](const auto& s) { return s.cpu_ms; });
  if (fits) return best;
  std::ostringstream text;
  text << "the lowest rate here, of " << best.text() << ", is " << best.false_events
       << " false events per pixel-frame";
  throw NothingFits(text.str());
}

}  // namespace saccade
