#include "scene/roam/rounded_trip.h"

#include <algorithm>
#include <numeric>

namespace saccade {
namespace {

constexpr int kRounds = 200;
constexpr double kAhead = 8;  // clearances: how far distances are asked for, as they are used again

std::vector<double> sidesOf(const std::vector<Vec3d>& corners) {
  std::vector<double> sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(length(corners[(i + 1) % corners.size()] - corners[i]));
  return sides;
}

std::vector<Vec3d> evenly(const std::vector<Vec3d>& corners, const std::vector<double>& sides, double step,
                          std::size_t points) {
  std::vector<Vec3d> even;
  std::size_t side = 0;
  double before = 0;  // the way to the corner that the side begins at
  for (std::size_t i = 0; i < points; ++i) {
    const double way = step * static_cast<double>(i);
    while (side + 1 < sides.size() && way >= before + sides[side]) before += sides[side++];
    const double share = sides[side] > 0 ? std::min(1.0, (way - before) / sides[side]) : 0;
    even.push_back(corners[side] + (corners[(side + 1) % corners.size()] - corners[side]) * share);
  }
  return even;
}

}  // namespace

std::vector<Vec3d> roundedTrip(const FreeSpace& space, const std::vector<Vec3d>& corners, double clearance,
                               std::size_t points) {
  const std::vector<double> sides = sidesOf(corners);
  const double step = std::accumulate(sides.begin(), sides.end(), 0.0) / static_cast<double>(points);
  std::vector<Vec3d> trip = evenly(corners, sides, step, points);
  const double needed = clearance + step, reach = needed + kAhead * clearance;
  std::vector<double> known, least;  // the distance is at least so much, and has to be
  for (const Vec3d p : trip) {
    known.push_back(space.distance(p, reach));
    least.push_back(std::min(needed, known.back()));
  }
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < points; ++i) {
      const Vec3d between = (trip[(i + points - 1) % points] + trip[(i + 1) % points]) / 2.0;
      const Vec3d move = (between - trip[i]) / 2.0;
      double distance = known[i] - length(move);
      if (distance < least[i]) distance = space.distance(trip[i] + move, reach);
      if (distance < least[i]) continue;
      trip[i] = trip[i] + move;
      known[i] = distance;
    }
  return trip;
}

}  // namespace saccade
