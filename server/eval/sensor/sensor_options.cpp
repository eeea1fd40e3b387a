#include "eval/sensor/sensor_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/names.h"
#include "base/number_in.h"
#include "events/event_model.h"
#include "events/noise/presets.h"
#include "saccade/wire/noise_units.h"
#include "saccade/wire/ranges.h"

namespace saccade::eval {
namespace {

void setNoise(NoiseConfig& noise, const std::string& text) {
  const std::size_t at = text.find('=');
  const std::string name = text.substr(0, at);
  const auto fields = noiseFields();
  const auto field =
      std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return name == f.name; });
  if (field == fields.end() || at == text.npos) {
    throw CLI::ValidationError("--noise",
                               "must be KEY=VALUE, not " + text + "; the keys are " + joinRowNames(fields));
  }
  if (!CLI::detail::lexical_cast(text.substr(at + 1), noise.*field->value))
    throw CLI::ValidationError("--noise", text + ": the value must be a number");
}

// A sensor without a preset has equal thresholds.
SensorPreset presetOf(const SensorOptions& o) {
  const SensorConfig defaults;
  const double threshold = o.threshold.value_or(defaults.threshold);
  if (o.preset.empty()) return {"", "", threshold, threshold, seconds(defaults.refractory), {}};
  if (const SensorPreset* preset = findPreset(o.preset)) return *preset;
  throw CLI::ValidationError("--preset", "there is no \"" + o.preset + "\"; there are: " + presetNames());
}

}  // namespace

void addSensorOptions(CLI::App& app, SensorOptions& o) {
  const NumberIn threshold(ranges::kThreshold.min, ranges::kThreshold.max);
  app.add_option("--preset", o.preset, "sensor of a known camera: " + presetNames());
  app.add_option("--threshold", o.threshold, "contrast threshold C, natural log units")->check(threshold);
  app.add_option("--threshold-off", o.threshold_off,
                 "threshold of OFF events; default: that of ON events, in the preset's proportion")
      ->check(threshold);
  app.add_option("--model", o.model, "event model: " + eventModelNames())->capture_default_str();
  app.add_option("--refractory", o.refractory_s, "seconds for which a pixel is blind after an event")
      ->check(NumberIn(ranges::kRefractory.min, ranges::kRefractory.max));
  app.add_option("--noise", o.noise,
                 "KEY=VALUE, an amount of the noise; may be given again. The keys are " + noiseUnitTexts())
      ->allow_extra_args(false);
  app.add_option("--bias", o.bias, "I_eps, scene luminance")
      ->check(NumberIn(ranges::kBias.min, ranges::kBias.max))
      ->capture_default_str();
  app.add_option("--seed", o.seed, "of the pixels and their noise")
      ->check(wholeNumber())
      ->capture_default_str();
}

SensorConfig configOf(const SensorOptions& o) {
  const SensorPreset preset = presetOf(o);
  const auto threshold = o.preset.empty() ? std::optional(preset.threshold) : o.threshold;
  const auto [on, off] = thresholdsOf(preset, threshold, o.threshold_off);
  SensorConfig config;
  config.threshold = on;
  config.threshold_off = off;
  config.refractory = TimeNs(std::llround(o.refractory_s.value_or(preset.refractory_s) * 1e9));
  config.bias = o.bias;
  config.model = o.model;
  config.seed = o.seed;
  config.noise = preset.noise;
  for (const std::string& noise : o.noise) setNoise(config.noise, noise);
  if (const auto fault = findFault(config)) throw std::runtime_error(fault->field + ": " + fault->message);
  return config;
}

}  // namespace saccade::eval
