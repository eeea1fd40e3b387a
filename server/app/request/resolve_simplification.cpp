#include "app/request/refusal.h"
#include "app/request/resolve_objects.h"
#include "app/request/resolve_quality.h"
#include "base/names.h"
#include "base/text_cut.h"

namespace saccade {
namespace {

void checkLeftOpen(const v1::Quality& quality) {
  if (quality.has_budget_ms() || quality.has_max_false_rate())
    refuse("quality.max_event_change", "give a budget or max_event_change, not both");
  const std::string why = "max_event_change chooses it; leave it out";
  if (quality.has_bounces()) refuse("quality.bounces", why);
  if (quality.disabled_features_size() > 0) refuse("quality.disabled_features", why);
}

// Replaces max_event_change by the model it chose: the request, sent again, asks for the same.
v1::ExpectedChange take(const MeasuredModel& chosen, const MeasuredModel& whole,
                        const SimplificationTable& table, v1::Quality& quality) {
  quality.clear_max_event_change();
  quality.set_bounces(static_cast<std::uint32_t>(chosen.model.bounces));
  setDisabledFeatures(chosen.model.disabled_features, quality);
  v1::ExpectedChange expected;
  expected.set_model(chosen.model.text());
  expected.set_changed(chosen.changed);
  expected.set_time(whole.cpu_ms > 0 ? chosen.cpu_ms / whole.cpu_ms : 1);
  expected.set_measured_on(table.settings);
  return expected;
}

}  // namespace

std::optional<v1::ExpectedChange> resolveSimplification(v1::OpenStream& request,
                                                        const SimplificationSource& source) {
  v1::Quality& quality = *request.mutable_quality();
  if (!quality.has_max_event_change()) return std::nullopt;
  const std::string field = "quality.max_event_change";
  checkRange(field, quality.max_event_change(), ranges::kMaxEventChange);
  checkLeftOpen(quality);
  if (!source.unavailable.empty()) throw Refusal(v1::CODE_UNAVAILABLE, field, source.unavailable);
  if (!bodyNames(request).empty())
    throw Refusal(v1::CODE_UNAVAILABLE, field, "no scene is measured with moving objects");
  const std::vector<MeasuredModel> models = source.table.modelsOf(request.scene());
  if (models.empty()) {
    throw Refusal(v1::CODE_UNAVAILABLE, field,
                  "no scene of this name is measured: " + request.scene() + "; measured are: " +
                      joinNames(source.table.scenes()) + "; `saccade-eval simplification` measures more");
  }
  return take(cheapest(models, quality.max_event_change()), models.front(), source.table, quality);
}

SceneFeatures resolveDisabledFeatures(v1::Quality& quality) {
  SceneFeatures features;
  for (int i = 0; i < quality.disabled_features_size(); ++i) {
    const SceneFeatureInfo* info = findFeature(quality.disabled_features(i));
    if (!info)
      refuse("quality.disabled_features[" + std::to_string(i) + "]",
             "there is no feature '" + cutText(quality.disabled_features(i), kMaxEcho) +
                 "'; there are: " + featureNames());
    features.insert(info->feature);
  }
  setDisabledFeatures(features, quality);
  return features;
}

void setDisabledFeatures(const SceneFeatures& features, v1::Quality& quality) {
  quality.clear_disabled_features();
  for (const std::string& name : namesOf(features)) quality.add_disabled_features(name);
}

}  // namespace saccade
