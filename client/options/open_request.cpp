#include <stdexcept>

#include "client/options/request_options.h"
#include "client/options/request_text.h"

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

// Without --rate, what is not given of the intervals is left to the server.
void setRates(const RequestOptions& options, v1::Timing& timing) {
  constexpr double kIntervalPx = 1;  // beside --min-rate: a rate alone would be that of whole frames
  if (const auto rate = options.rate_hz ? options.rate_hz : options.min_rate_hz)
    timing.set_frame_rate_hz(*rate);
  if (options.interval_px || options.min_rate_hz)
    timing.set_interval_px(options.interval_px.value_or(kIntervalPx));
  if (options.finest_px) timing.mutable_refinement()->set_finest_px(*options.finest_px);
  if (options.max_rate_hz) timing.set_max_rate_hz(*options.max_rate_hz);
}

v1::Timing makeTiming(const RequestOptions& options) {
  v1::Timing timing;
  setRates(options, timing);
  const bool until_path_ends = !options.duration_s && namesPoses(options);
  timing.set_until_path_ends(until_path_ends);
  if (!until_path_ends) timing.set_duration_s(options.duration_s.value_or(kDuration));
  timing.set_clock(enumValue<v1::Clock>("--clock", options.clock));
  if (timing.clock() == v1::CLOCK_LOCKSTEP)
    throw std::invalid_argument("--clock: lockstep is for clients that send poses, such as those in Python");
  return timing;
}

}  // namespace

v1::OpenStream makeOpenStream(const RequestOptions& options) {
  v1::OpenStream open;
  open.set_scene(options.scene);
  open.set_animation(options.animation);
  *open.mutable_trajectory() = makeTrajectory(options);
  addObjects(options.objects, open);
  *open.mutable_timing() = makeTiming(options);
  *open.mutable_method() = makeMethod(options);
  *open.mutable_quality() = makeQuality(options);
  addSensors(options.sensors, open);
  const double units_per_metre = 1 / options.rig.metres_per_unit.value_or(1);
  addViews(options.rig, makeViews(options.camera, units_per_metre), open);
  open.set_delivery(enumValue<v1::Delivery>("--delivery", options.delivery));
  if (!options.codec.empty()) open.set_codec(enumValue<v1::Codec>("--codec", options.codec));
  open.set_seed(options.seed);
  return open;
}

}  // namespace saccade::client
