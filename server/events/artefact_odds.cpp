#include "events/artefact_odds.h"

#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr double kOne = 255;  // Event::artefact for certainty

double normalDensity(double z) {
  return std::exp(-0.5 * z * z) * 0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2;
}

}  // namespace

double artefactOdds(double dL, double sigma) {
  if (!(sigma > 0)) return 0;
  const double a = std::abs(dL) / sigma;
  if (!(a > 1e-6)) return 0.5;
  return (normalDensity(0) - normalDensity(a)) / a + 0.5 * std::erfc(a / std::numbers::sqrt2);
}

void labelArtefacts(const IntensityChange& change, float bias, const ImageF& dL, Events& events) {
  for (Event& event : events) {
    const double variance = change.var_dI.at(event.x, event.y);
    const double sigma = std::sqrt(variance) / (bias + change.I_prev.at(event.x, event.y));
    event.artefact =
        static_cast<std::uint8_t>(std::lround(kOne * artefactOdds(dL.at(event.x, event.y), sigma)));
  }
}

std::uint64_t removeArtefacts(double most, Events& events) {
  return std::erase_if(events, [&](const Event& event) { return event.artefact > most * kOne; });
}

}  // namespace saccade
