#include "events/sensor_config.h"

#include "base/range.h"
#include "events/event_model.h"
#include "events/reconstruction.h"
#include "saccade/wire/ranges.h"

namespace saccade {
namespace {

// Returns an error text for the numbers, or nothing.
std::optional<SensorFault> findRangeFault(const SensorConfig& config) {
  std::optional<SensorFault> fault;
  const auto check = [&](const std::string& field, double value, auto range) {
    std::string message = rangeFault(value, range.min, range.max);
    if (!fault && !message.empty()) fault = {field, std::move(message)};
  };
  check("threshold", config.threshold, ranges::kThreshold);
  check("threshold_off", config.threshold_off, ranges::kThreshold);
  check("bias", config.bias, ranges::kBias);
  check("cutoff_hz", config.reconstruction_cutoff_hz, ranges::kCutoff);
  check("refractory_s", seconds(config.refractory), ranges::kRefractory);
  check("max_events_per_pixel_frame", config.max_events_per_pixel_frame, ranges::kMaxPixelEvents);
  check("max_artefact_odds", config.max_artefact_odds, ranges::kArtefactOdds);
  check("max_events_per_frame", static_cast<double>(config.max_events_per_frame), Range<double>{1, 0x1p64});
  for (const NoiseField& field : noiseFields()) {
    check(std::string("noise.") + field.name, config.noise.*field.value, field.range);
  }
  if (!fault && config.noise.follower_hz > 0 && config.noise.photoreceptor_hz == 0) {
    fault = {"noise.follower_hz", "a follower needs a photoreceptor_hz above 0"};
  }
  if (!fault && config.noise.asymmetry > 0 && config.noise.photoreceptor_hz == 0) {
    fault = {"noise.asymmetry", "an asymmetry needs a photoreceptor_hz above 0"};
  }
  if (!fault && config.noise.brownian_hz > 0 && config.model != "stochastic") {
    fault = {"noise.brownian_hz", "a Brownian motion needs the model stochastic"};
  }
  return fault;
}

}  // namespace

SensorConfig changed(SensorConfig config, const SensorChange& change) {
  config.threshold = change.threshold.value_or(config.threshold);
  config.threshold_off = change.threshold_off.value_or(config.threshold_off);
  config.bias = change.bias.value_or(config.bias);
  config.noise = change.noise.value_or(config.noise);
  return config;
}

SensorChange together(SensorChange first, const SensorChange& last) {
  if (last.threshold) first.threshold = last.threshold;
  if (last.threshold_off) first.threshold_off = last.threshold_off;
  if (last.bias) first.bias = last.bias;
  if (last.noise) first.noise = last.noise;
  return first;
}

std::optional<SensorFault> findFault(const SensorConfig& config) {
  if (auto fault = findRangeFault(config)) return fault;
  if (!findEventModel(config.model)) {
    return SensorFault{"model", "no event model '" + config.model + "'; there are: " + eventModelNames()};
  }
  if (!findReconstruction(config.reconstruction)) {
    return SensorFault{"reconstruction", "no reconstruction '" + config.reconstruction +
                                             "'; there are: " + reconstructionNames()};
  }
  return std::nullopt;
}

}  // namespace saccade
