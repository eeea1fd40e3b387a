#include "tables/simplification_table.h"

#include <algorithm>
#include <set>

#include "base/default_cache.h"
#include "base/names.h"

namespace saccade {

std::string SceneModel::text() const {
  const std::string text = std::to_string(bounces) + (bounces == 1 ? " bounce" : " bounces");
  return disabled_features.empty() ? text : text + ", without " + joinNames(namesOf(disabled_features));
}

std::vector<std::string> SimplificationTable::scenes() const {
  std::set<std::string> names;
  for (const MeasuredModel& row : rows) names.insert(row.scene);
  return {names.begin(), names.end()};
}

std::vector<MeasuredModel> SimplificationTable::modelsOf(const std::string& scene) const {
  std::vector<MeasuredModel> models;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(models),
               [&](const MeasuredModel& row) { return row.scene == scene; });
  return models;
}

std::string defaultSimplificationTable() {
  return defaultCache() + "/simplification/simplification.csv";
}

const MeasuredModel& cheapest(const std::vector<MeasuredModel>& models, double tolerance) {
  const MeasuredModel* best = &models.front();
  for (const MeasuredModel& m : models)
    if (m.changed <= tolerance && m.noise <= tolerance && m.cpu_ms < best->cpu_ms) best = &m;
  return *best;
}

}  // namespace saccade
