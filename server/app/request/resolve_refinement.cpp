#include <algorithm>
#include <cmath>

#include "app/request/refusal.h"
#include "app/request/resolve_parts.h"
#include "feed/refinement.h"

namespace saccade {
namespace {

constexpr double kPieces = 16, kMostPieces = 32;  // of an interval

// The least of all sensors, also after their changes.
RefinementSettings mostSensitive(const ResolvedStream& stream) {
  RefinementSettings least{.threshold = ranges::kThreshold.max, .bias = ranges::kBias.max};
  const auto take = [&](const SensorConfig& sensor) {
    least.threshold = std::min({least.threshold, sensor.threshold, sensor.threshold_off});
    least.bias = std::min(least.bias, sensor.bias);
  };
  for (std::size_t i = 0; i < stream.sensors.size(); ++i) {
    SensorConfig sensor = stream.sensors[i];
    take(sensor);
    for (const SensorChange& change : stream.changes[i]) take(sensor = changed(sensor, change));
  }
  return least;
}

double stepBelow(double value, double first, double factor, double least) {
  const double steps = std::floor(std::log(value / first) / std::log(factor) + 1e-9);
  return std::max(first * std::pow(factor, steps), least);
}

// Sensors that differ a little may share a feed. Other feeds than those of PACED streams are never shared.
RefinementSettings madeFor(const ResolvedStream& stream) {
  const RefinementSettings sensors = mostSensitive(stream), usual;
  if (stream.request.timing().clock() != v1::CLOCK_PACED) return sensors;
  return {
      .threshold = stepBelow(sensors.threshold, usual.threshold, 2, ranges::kRefinedThreshold.min),
      .bias = stepBelow(sensors.bias, usual.bias, 10, ranges::kRefinedBias.min),
  };
}

void setDefaults(const ResolvedStream& stream, double interval_px, v1::Refinement& refinement) {
  if (refinement.finest_px() == 0)
    refinement.set_finest_px(refinementFault(stream.feed).empty() ? interval_px / kPieces : interval_px);
  const RefinementSettings least = madeFor(stream);
  if (refinement.threshold() == 0) refinement.set_threshold(least.threshold);
  if (refinement.bias() == 0) refinement.set_bias(least.bias);
}

}  // namespace

void resolveRefinement(ResolvedStream& stream) {
  v1::Timing& timing = *stream.request.mutable_timing();
  const std::string field = "timing.refinement";
  stream.feed.refinement.reset();
  if (timing.interval_px() == 0) {
    if (timing.has_refinement()) refuse(field, "it needs timing.interval_px");
    return;
  }
  v1::Refinement& refinement = *timing.mutable_refinement();
  setDefaults(stream, timing.interval_px(), refinement);
  checkRange(field + ".finest_px", refinement.finest_px(), timing.interval_px() / kMostPieces,
             timing.interval_px());
  checkRange(field + ".threshold", refinement.threshold(), ranges::kRefinedThreshold);
  checkRange(field + ".bias", refinement.bias(), ranges::kRefinedBias);
  if (refinement.finest_px() == timing.interval_px()) return;
  if (const std::string fault = refinementFault(stream.feed); !fault.empty())
    refuse(field + ".finest_px", fault);
  stream.feed.refinement = {
      .finest_px = refinement.finest_px(), .threshold = refinement.threshold(), .bias = refinement.bias()};
}

}  // namespace saccade
