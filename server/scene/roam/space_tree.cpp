#include "scene/roam/space_tree.h"

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "scene/roam/clear.h"

namespace saccade {
namespace {

constexpr std::size_t kPlaces = 96, kScouts = 400, kTries = 4 * kPlaces, kClimbs = 200;
constexpr double kFarthest = 4;   // step, in sights
constexpr double kLongest = 0.9;  // step, as a share of the way to what is seen
constexpr double kApart = 0.1;    // places, in sights, unless there are kFew
constexpr std::size_t kFew = 8;
constexpr double kReach = 1e3;  // distances are known up to this, in sights

// The numbers of one try.
class Draws {
 public:
  Draws(std::uint64_t seed, std::size_t n) : key_(hashKey(seed, n)) {}
  double operator()(std::uint64_t i) const { return toUnit(hashKey(key_, i)); }
  std::size_t below(std::size_t count, std::uint64_t i) const {
    return std::min(count - 1, static_cast<std::size_t>((*this)(i) * static_cast<double>(count)));
  }

 private:
  std::uint64_t key_;
};

double lookTo(const FreeSpace& space, Vec3d from, Vec3d direction) {
  double distance = 0;
  space.look(from, {&direction, 1}, {&distance, 1});
  return distance;
}

// The first place with this clearance on a walk along free lines from the start, or else the one with most.
Place scout(const FreeSpace& space, Vec3d start, double clearance, const Surroundings& around,
            std::uint64_t seed) {
  std::vector<Place> scouts{{start, space.distance(start, kReach * around.sight)}};
  for (std::size_t i = 0; i < kScouts && scouts.back().distance < clearance; ++i) {
    const Draws draw(seed, i);
    const Vec3d from = scouts[draw.below(scouts.size(), 0)].at, along = directionOf(draw(1), draw(2));
    const double seen = lookTo(space, from, along);
    const Vec3d at = from + along * (std::min(seen, kFarthest * around.sight) * draw(3));
    if (length(at - start) > kMostWay * around.sight || !seesLandmarks(space, around, at)) continue;
    scouts.push_back({at, space.distance(at, kReach * around.sight)});
  }
  return *std::ranges::max_element(scouts, {}, &Place::distance);
}

}  // namespace

std::optional<Place> findRoot(const FreeSpace& space, Vec3d start, double clearance,
                              const Surroundings& around, std::uint64_t seed) {
  const Place found = scout(space, start, clearance, around, seed);
  if (found.distance < clearance) return {};
  return found;
}

double roomiest(const FreeSpace& space, Vec3d start, const Surroundings& around, std::uint64_t seed) {
  Place best = scout(space, start, kReach * around.sight, around, seed);
  for (std::size_t i = 0; i < kClimbs; ++i) {  // within the ball that is known to be free
    const Draws draw(hashKey(seed, kScouts), i);
    const Vec3d at = best.at + directionOf(draw(0), draw(1)) * (best.distance * draw(2) / 2);
    const double distance = space.distance(at, kReach * around.sight);
    if (distance > best.distance) best = {at, distance};
  }
  return std::min(best.distance, kMostDistance * around.sight);
}

std::vector<Place> growTree(const FreeSpace& space, const Place& root, double clearance,
                            const Surroundings& around, std::uint64_t seed) {
  std::vector<Place> tree{root};
  tree[0].parent = 0;
  const double far = std::max(kMostDistance * around.sight, root.distance);
  for (std::size_t i = 0; i < kTries && tree.size() < kPlaces; ++i) {
    const Draws draw(seed, i);
    // The farther of two, so that it grows outwards.
    const std::size_t one = draw.below(tree.size(), 0), two = draw.below(tree.size(), 4);
    const auto way = [&](std::size_t place) { return length(tree[place].at - root.at); };
    const std::size_t parent = way(one) > way(two) ? one : two;
    const Place& from = tree[parent];
    const Vec3d along = directionOf(draw(1), draw(2));
    const bool in_ball = i % 4 == 3;
    const double seen = in_ball ? from.distance - clearance : lookTo(space, from.at, along);
    if (!std::isfinite(seen)) continue;
    const double share = (in_ball ? 1 : kLongest) * std::sqrt(draw(3));  // rather far: there is more room
    const Vec3d at = from.at + along * std::min(seen * share, kFarthest * around.sight);
    const bool needed = tree.size() < kFew && i > kTries / 2;
    if (length(at - from.at) < kApart * around.sight && !needed) continue;
    const double distance = space.distance(at, kReach * around.sight);
    if (distance > far || length(at - root.at) > kMostWay * around.sight) continue;
    if (!in_ball && !isClear(space, from.at, at, clearance)) continue;
    if (!seesLandmarks(space, around, at)) continue;
    tree.push_back({at, distance, parent});
  }
  return tree;
}

}  // namespace saccade
