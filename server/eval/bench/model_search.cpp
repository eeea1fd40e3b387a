#include "eval/bench/model_search.h"

#include <algorithm>

namespace saccade::eval {
namespace {

SceneModel joined(SceneModel a, const SceneModel& b) {
  a.bounces = std::min(a.bounces, b.bounces);
  a.disabled_features.insert(b.disabled_features.begin(), b.disabled_features.end());
  return a;
}

// Those that save time, the one that changes least first.
std::vector<MeasuredModel> worthwhile(const MeasuredModel& whole, std::vector<MeasuredModel> simpler) {
  std::erase_if(simpler, [&](const MeasuredModel& m) { return m.cpu_ms >= whole.cpu_ms; });
  std::stable_sort(simpler.begin(), simpler.end(),
                   [](const auto& a, const auto& b) { return a.changed < b.changed; });
  return simpler;
}

}  // namespace

std::vector<SceneModel> simplerByOne(const SceneModel& whole, const SceneFeatures& parts) {
  std::vector<SceneModel> models;
  for (int bounces = whole.bounces - 1; bounces >= 0; --bounces)
    models.push_back({bounces, whole.disabled_features});
  for (const SceneFeature part : parts) models.push_back({whole.bounces, {part}});
  return models;
}

std::vector<MeasuredModel> withCombinations(const MeasuredModel& whole,
                                            const std::vector<MeasuredModel>& simpler,
                                            const MeasureModel& measure) {
  std::vector<MeasuredModel> all{whole};
  all.insert(all.end(), simpler.begin(), simpler.end());
  SceneModel model = whole.model;
  for (const MeasuredModel& next : worthwhile(whole, simpler)) {
    model = joined(model, next.model);
    auto found = std::find_if(all.begin(), all.end(), [&](const auto& m) { return m.model == model; });
    if (found == all.end()) found = all.insert(all.end(), measure(model));
    if (found->changed > 1) break;
  }
  return all;
}

}  // namespace saccade::eval
