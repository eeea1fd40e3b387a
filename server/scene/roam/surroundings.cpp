#include "scene/roam/surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/quantile.h"

namespace saccade {
namespace {

constexpr std::size_t kDirections = 1024, kLandmarks = 24;
constexpr double kBefore = 0.98;  // of the way to what is seen: so that a wall hides it from behind
constexpr double kEnough = 0.25;

}  // namespace

Vec3d directionOf(double u, double v) {
  const double z = 1 - 2 * u, r = std::sqrt(std::max(0.0, 1 - z * z)), angle = 2 * std::numbers::pi * v;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Surroundings lookAround(const FreeSpace& space, Vec3d start) {
  std::vector<Vec3d> directions;
  for (std::size_t i = 0; i < kDirections; ++i)  // a Fibonacci lattice
    directions.push_back(directionOf((static_cast<double>(i) + 0.5) / kDirections,
                                     std::fmod(static_cast<double>(i) / std::numbers::phi, 1.0)));
  std::vector<double> distances(kDirections), met;
  space.look(start, directions, distances);
  Surroundings around;
  for (std::size_t i = 0; i < kDirections; ++i)
    if (std::isfinite(distances[i])) {
      met.push_back(distances[i]);
      around.landmarks.push_back(start + directions[i] * (kBefore * distances[i]));
    }
  if (met.empty()) return {};
  around.sight = quantile(met, 0.5);
  if (static_cast<double>(met.size()) >= kOpen * kDirections) around.landmarks.clear();
  const std::size_t step = around.landmarks.size() / kLandmarks + 1;
  for (std::size_t i = 0; i * step < around.landmarks.size(); ++i)
    around.landmarks[i] = around.landmarks[i * step];
  around.landmarks.resize((around.landmarks.size() + step - 1) / step);
  return around;
}

bool seesLandmarks(const FreeSpace& space, const Surroundings& around, Vec3d point) {
  std::vector<Vec3d> directions;
  std::vector<double> ways, distances(around.landmarks.size());
  for (const Vec3d landmark : around.landmarks) {
    ways.push_back(length(landmark - point));
    directions.push_back((landmark - point) / std::max(ways.back(), 1e-30));
  }
  space.look(point, directions, distances);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) seen += distances[i] > ways[i];
  return static_cast<double>(seen) >= kEnough * static_cast<double>(ways.size());
}

}  // namespace saccade
