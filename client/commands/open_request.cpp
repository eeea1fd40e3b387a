#include <algorithm>
#include <stdexcept>

#include "client/commands/request_options.h"
#include "client/commands/request_text.h"

namespace saccade::client {
namespace {

v1::Method makeMethod(const RequestOptions& options) {
  v1::Method method;
  method.set_name(options.method);
  method.set_spp(options.spp.value_or(0));
  for (const std::string& param : options.params) {
    const auto [name, number] = splitAt(param, '=');
    const auto value = parseNumber<double>(number);
    if (name.empty() || !value) throw std::invalid_argument("--set: '" + param + "' is not NAME=NUMBER");
    (*method.mutable_params())[name] = *value;
  }
  return method;
}

// "2%" is 0.02.
double parseShare(const std::string& option, const std::string& text) {
  const auto [number, rest] = splitAt(text, '%');
  const auto percent = parseNumber<double>(number);
  if (percent && rest.empty() && text.ends_with('%')) return *percent / 100;
  throw std::invalid_argument(option + ": '" + text + "' is not a percentage, such as 2%");
}

v1::Quality makeQuality(const RequestOptions& options) {
  v1::Quality quality;
  if (options.bounces) quality.set_bounces(*options.bounces);
  quality.set_jitter(options.jitter);
  if (options.bake_error) quality.set_bake_error(*options.bake_error);
  if (options.budget_ms) quality.set_budget_ms(*options.budget_ms);
  if (options.max_false_rate) quality.set_max_false_rate(*options.max_false_rate);
  if (!options.max_event_change.empty())
    quality.set_max_event_change(parseShare("--max-event-change", options.max_event_change));
  for (const std::string& feature : options.disabled_features) quality.add_disabled_features(feature);
  return quality;
}

void setNoise(const std::vector<std::string>& amounts, v1::Sensor& sensor) {
  for (const std::string& amount : amounts) {
    const auto [name, number] = splitAt(amount, '=');
    const auto value = parseNumber<double>(number);
    const auto* field = v1::Noise::descriptor()->FindFieldByName(name);
    if (!value || !field) {
      throw std::invalid_argument("--noise: '" + amount + "' is not KEY=NUMBER, with KEY one of " +
                                  fieldNames(*v1::Noise::descriptor()));
    }
    v1::Noise& noise = *sensor.mutable_noise();
    noise.GetReflection()->SetDouble(&noise, field, *value);
  }
}

v1::Sensor makeSensor(const RequestOptions& options, std::size_t index) {
  v1::Sensor sensor;
  const auto& off = options.thresholds_off;
  if (!options.thresholds.empty()) sensor.set_threshold(options.thresholds[index]);
  if (!off.empty()) sensor.set_threshold_off(off[off.size() == 1 ? 0 : index]);
  if (options.bias) sensor.set_bias(*options.bias);
  if (options.refractory_s) sensor.set_refractory_s(*options.refractory_s);
  if (options.cutoff_hz) sensor.set_cutoff_hz(*options.cutoff_hz);
  if (!options.model.empty()) {
    sensor.set_model(enumValue<v1::EventModel>("--model", options.model));
  }
  if (!options.reconstruction.empty()) {
    sensor.set_reconstruction(enumValue<v1::Reconstruction>("--reconstruction", options.reconstruction));
  }
  sensor.set_preset(options.preset);
  setNoise(options.noise, sensor);
  return sensor;
}

v1::Timing makeTiming(const RequestOptions& options) {
  v1::Timing timing;
  timing.set_frame_rate_hz(options.rate_hz);
  timing.set_duration_s(options.duration_s);
  timing.set_clock(enumValue<v1::Clock>("--clock", options.clock));
  if (timing.clock() == v1::CLOCK_LOCKSTEP)
    throw std::invalid_argument("--clock: lockstep is for clients that send poses, such as those in Python");
  return timing;
}

}  // namespace

v1::OpenStream makeOpenStream(const RequestOptions& options) {
  const std::size_t sensors = std::max<std::size_t>(options.thresholds.size(), 1);
  if (options.thresholds_off.size() > 1 && options.thresholds_off.size() != sensors) {
    throw std::invalid_argument("--threshold-off: give one value, or one for each --threshold");
  }
  v1::OpenStream open;
  open.set_scene(options.scene);
  *open.mutable_view() = makeView(options.camera);
  *open.mutable_trajectory() = makeTrajectory(options);
  *open.mutable_timing() = makeTiming(options);
  *open.mutable_method() = makeMethod(options);
  *open.mutable_quality() = makeQuality(options);
  for (std::size_t i = 0; i < sensors; ++i) *open.add_sensors() = makeSensor(options, i);
  addFurtherViews(options, open);
  open.set_delivery(enumValue<v1::Delivery>("--delivery", options.delivery));
  if (!options.codec.empty()) open.set_codec(enumValue<v1::Codec>("--codec", options.codec));
  open.set_seed(options.seed);
  return open;
}

}  // namespace saccade::client
