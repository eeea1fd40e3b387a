#include "scene/roam/roam_try.h"

#include <algorithm>
#include <numeric>

#include "base/hash_rng.h"
#include "scene/roam/clear.h"
#include "scene/roam/gaze.h"
#include "scene/roam/pace.h"
#include "scene/roam/round_trip.h"
#include "scene/roam/rounded_trip.h"

namespace saccade {
namespace {

constexpr std::size_t kAims = 6, kPoints = 384, kPanoramas = 48, kPoses = 512;
// Lines, round corners and the path in the end are clear by so many clearances: each leaves room for the
// next.
constexpr double kLineMargin = 1.15, kCornerMargin = 1.1, kPathMargin = 1.06;
constexpr double kNearest = 0.05, kFarthest = 8;  // that is seen, in sights
constexpr double kEnough = 0.5;
enum Purpose : std::uint64_t { kRoot, kTree, kTrip, kGaze };

std::vector<Panorama> panoramasAlong(const RoamPlace& place, const std::vector<Vec3d>& places) {
  std::vector<Panorama> around;
  const double apart = static_cast<double>(places.size()) / kPanoramas;
  for (std::size_t i = 0; i < kPanoramas; ++i)
    around.emplace_back(place.space, loopAt(places, apart * static_cast<double>(i)), place.level, place.lens,
                        place.range);
  return around;
}

bool isClear(const RoamPlace& place, const std::vector<Pose>& poses, double clearance) {
  std::vector<Vec3d> positions;
  for (const Pose& pose : poses) positions.push_back(pose.position);
  return isLoopClear(place.space, positions, clearance);
}

}  // namespace

RoamPlace::RoamPlace(const Pose& start, const FreeSpace& space, const Lens& lens)
    : space(space),
      lens(lens),
      start(start),
      level(levelOf(start.rotation)),
      around(lookAround(space, start.position)),
      range{kNearest * around.sight, kFarthest * around.sight},
      enough(kEnough * Panorama(space, start.position, level, lens, range).bestShare()) {}

std::optional<RoamPath> tryRoam(const RoamPlace& place, double clearance, std::size_t stops,
                                std::uint64_t seed) {
  const double of_lines = kLineMargin * clearance;
  const auto root = findRoot(place.space, place.start.position, of_lines, place.around, hashKey(seed, kRoot));
  if (!root) return {};
  const std::vector<Place> tree = growTree(place.space, *root, of_lines, place.around, hashKey(seed, kTree));
  const std::vector<Vec3d> corners = roundTrip(place.space, tree, of_lines, stops, hashKey(seed, kTrip));
  Course course{roundedTrip(place.space, corners, kCornerMargin * clearance, kPoints), {}, place.level};
  const std::vector<Panorama> around = panoramasAlong(place, course.places);
  course.gaze = drawGaze(around, place.level, kAims, hashKey(seed, kGaze));
  const Pace pace = measurePace(place.space, course, place.lens, place.range);
  const double period_s = std::accumulate(pace.durations.begin(), pace.durations.end(), 0.0);
  if (!(period_s > 0)) return {};
  RoamPath path{evenlyInTime(course, pace, kPoses), period_s, *std::ranges::min_element(pace.seen)};
  if (!isClear(place, path.poses, kPathMargin * clearance)) return {};
  return path;
}

}  // namespace saccade
