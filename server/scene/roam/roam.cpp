#include "scene/roam/roam.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/cancelled.h"
#include "base/hash_rng.h"
#include "scene/camera/random_path.h"
#include "scene/roam/roam_try.h"
#include "scene/roam/space_tree.h"

namespace saccade {
namespace {

constexpr std::uint64_t kTries = 8;
constexpr std::size_t kMostStops = 6;
// Clearances, in sights. Nearer than kLeast no path goes, so that rounding does no harm.
constexpr double kUsual = 0.05, kLeastUsual = 1e-3, kLeast = 1e-4;
constexpr int kShrinks = 25;
constexpr double kShrink = 0.92;  // of the clearance of the roomiest place, again and again

struct Request {
  std::uint64_t seed;
  const std::stop_token& stop;
};

// The first that shows enough, else the one that shows most.
std::optional<RoamPath> draw(const RoamPlace& place, double clearance, const Request& request) {
  std::optional<RoamPath> best;
  for (std::uint64_t i = 0; i < kTries; ++i) {
    throwIfStopped(request.stop);
    auto path = tryRoam(place, std::max(clearance, kLeast * place.around.sight), kMostStops - i / 2,
                        hashKey(request.seed, i));
    if (path && path->seen >= place.enough) return path;
    if (path && path->seen > 0 && (!best || path->seen > best->seen)) best = std::move(path);
  }
  return best;
}

// Two digits, not above `value`.
double roundedDown(double value) {
  const double scale = std::pow(10, 1 - std::floor(std::log10(value)));
  return std::floor(value * scale) / scale;
}

// 0 where none is found.
double largestClearance(const RoamPlace& place, const Request& request) {
  double clearance = roomiest(place.space, place.start.position, place.around, request.seed);
  for (int i = 0; i < kShrinks; ++i) {
    clearance *= kShrink;
    const double rounded = roundedDown(clearance);
    if (draw(place, rounded, request)) return rounded;
  }
  return 0;
}

[[noreturn]] void refuse(const RoamPlace& place, double clearance, const Request& request) {
  if (place.around.sight == 0) throw NoRoom("no surface can be seen from the start, in any direction", 0);
  const double largest = largestClearance(place, request);
  if (largest == 0) throw NoRoom("no path is found that keeps away from all surfaces and sees something", 0);
  char text[100];
  std::snprintf(text, sizeof text, "no path keeps %g from all surfaces; the largest found that works is %g",
                clearance, largest);
  throw NoRoom(text, largest);
}

RoamPath pathOf(const RoamPlace& place, const Motion& motion, const Request& request) {
  const double usual = kUsual * place.around.sight, wanted = motion.clearance.value_or(usual);
  const double least = motion.clearance.value_or(kLeastUsual * place.around.sight);
  if (place.around.sight > 0)
    for (double clearance = wanted; clearance >= least; clearance /= 2)
      if (auto path = draw(place, clearance, request)) return *path;
  refuse(place, wanted, request);
}

}  // namespace

Trajectory makeRoam(const Motion& motion, const Pose& start, const FreeSpace& space, const Lens& lens,
                    const std::stop_token& stop) {
  RoamPath path = pathOf(RoamPlace(start, space, lens), motion, {motion.seed, stop});
  const double speed = motion.image_speed ? motion.speed : motion.speed * std::numbers::pi / 180;
  const double period_s =
      std::clamp(path.period_s / speed, seconds(kMinRandomPeriod), seconds(kMaxRandomPeriod));
  return Trajectory(SplinePath{TimeNs{std::llround(period_s * 1e9)}, std::move(path.poses)});
}

}  // namespace saccade
