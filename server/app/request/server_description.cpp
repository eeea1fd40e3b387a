#include "app/request/server_description.h"

#include "events/noise/presets.h"
#include "methods/method.h"
#include "render/features/simplify.h"
#include "truth/truth_source.h"

namespace saccade {

void describeMethods(v1::ServerDescription& description) {
  for (const MethodInfo& info : methodTable()) {
    v1::MethodInfo& method = *description.add_methods();
    method.set_name(info.name);
    method.set_description(info.description);
    for (const ParamSpec& spec : info.params) {
      v1::ParamInfo& param = *method.add_params();
      param.set_name(spec.name);
      param.set_min(spec.min);
      param.set_max(spec.max);
      param.set_default_value(spec.fallback);
      param.set_description(spec.what);
    }
  }
}

void describePresets(v1::ServerDescription& description) {
  for (const SensorPreset& info : sensorPresets()) {
    v1::PresetInfo& preset = *description.add_presets();
    preset.set_name(info.name);
    preset.set_description(info.description);
  }
}

void describeTruth(v1::ServerDescription& description) {
  for (const TruthChannelInfo& info : truthTable()) {
    v1::TruthInfo& truth = *description.add_truth();
    truth.set_name(info.name);
    truth.set_description(info.description);
    truth.set_unit(info.unit);
    truth.set_layout(info.layout);
    truth.set_element(info.element);
    truth.mutable_planes()->Add(info.planes.begin(), info.planes.end());
  }
}

void describeFeatures(v1::ServerDescription& description) {
  for (const SceneFeatureInfo& info : featureTable()) {
    v1::SceneFeatureInfo& feature = *description.add_scene_features();
    feature.set_name(info.name);
    feature.set_description(info.description);
  }
}

}  // namespace saccade
