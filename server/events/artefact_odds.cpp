#include "events/artefact_odds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace saccade {
namespace {

constexpr double kOne = 255;  // Event::artefact for certainty

double square(double v) {
  return v * v;
}

// The integral of the normal distribution from -infinity to z.
double normalIntegral(double z) {
  const double density = std::exp(-0.5 * z * z) * 0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2;
  return z * 0.5 * std::erfc(-z / std::numbers::sqrt2) + density;
}

// Of the pixels around one.
struct MeanSquares {
  double error = 0;   // of dI
  double change = 0;  // of dL
};

MeanSquares meanSquaresAround(const IntensityChange& change, const ImageF& dL, int x0, int y0) {
  MeanSquares sum;
  int pixels = 0;
  for (int y = std::max(0, y0 - 1); y <= std::min(dL.height() - 1, y0 + 1); ++y) {
    for (int x = std::max(0, x0 - 1); x <= std::min(dL.width() - 1, x0 + 1); ++x) {
      const double disagreement =
          static_cast<double>(change.I_now.at(x, y)) - change.I_prev.at(x, y) - change.dI.at(x, y);
      sum.error += change.var_dI.at(x, y) + square(disagreement);
      sum.change += square(dL.at(x, y));
      ++pixels;
    }
  }
  return {sum.error / pixels, sum.change / pixels};
}

}  // namespace

double artefactOdds(double dL, double sigma, double tau) {
  if (!(sigma > 0)) return 0;
  const double kappa = 1 / (1 + square(sigma / tau)), s = sigma * std::sqrt(kappa);
  const double a = std::abs(dL) / s;
  if (!(a > 1e-6)) return 0.5;
  // In units of s, with the change between 0 and a: the error beyond it, dL - truth, has mean (1 - kappa) a.
  const double mean = (1 - kappa) * a;
  return (normalIntegral(mean) - normalIntegral(mean - a)) / a;
}

void labelArtefacts(const IntensityChange& change, float bias, const ImageF& dL, Events& events) {
  for (Event& event : events) {
    const int x = event.x, y = event.y;
    const MeanSquares around = meanSquaresAround(change, dL, x, y);
    const double brightness = bias + std::max(0.f, change.I_prev.at(x, y) + change.dI.at(x, y));
    const double odds =
        artefactOdds(dL.at(x, y), std::sqrt(around.error) / brightness, std::sqrt(around.change));
    event.artefact = static_cast<std::uint8_t>(std::lround(kOne * odds));
  }
}

std::uint64_t removeArtefacts(double most, Events& events) {
  return std::erase_if(events, [&](const Event& event) { return event.artefact > most * kOne; });
}

}  // namespace saccade
