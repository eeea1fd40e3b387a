#include "scene/roam/round_trip.h"

#include <algorithm>
#include <limits>

#include "base/hash_rng.h"
#include "scene/roam/clear.h"

namespace saccade {
namespace {

using Stops = std::vector<std::size_t>;
constexpr std::uint64_t kChoices = 3;  // of a stop

// From the place to the root.
Stops wayUp(const std::vector<Place>& tree, std::size_t place) {
  Stops way{place};
  while (way.back() != 0) way.push_back(tree[way.back()].parent);
  return way;
}

// Along the tree, by the nearest place that both ways to the root share.
Stops wayBetween(const std::vector<Place>& tree, std::size_t from, std::size_t to) {
  Stops up = wayUp(tree, from), down = wayUp(tree, to);
  while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2])
    up.pop_back(), down.pop_back();
  up.insert(up.end(), down.rbegin() + 1, down.rend());
  return up;
}

// Leaves out what straight lines can leave out. Appends all but the last.
void appendShortened(const FreeSpace& space, const std::vector<Place>& tree, const Stops& way,
                     double clearance, std::vector<Vec3d>& corners) {
  for (std::size_t i = 0; i + 1 < way.size();) {
    corners.push_back(tree[way[i]].at);
    std::size_t next = way.size() - 1;
    while (next > i + 1 && !isClear(space, tree[way[i]].at, tree[way[next]].at, clearance)) --next;
    i = next;
  }
}

// Each is the farthest from those before, of some that the seed draws.
Stops drawStops(const std::vector<Place>& tree, std::size_t count, std::uint64_t seed) {
  const auto draw = [&](std::uint64_t n) {
    const double u = toUnit(hashKey(seed, n));
    return std::min(tree.size() - 1, static_cast<std::size_t>(u * static_cast<double>(tree.size())));
  };
  Stops stops{draw(0)};
  const auto apart = [&](std::size_t place) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t stop : stops) least = std::min(least, length(tree[stop].at - tree[place].at));
    return least;
  };
  for (std::uint64_t n = 1; stops.size() < count; n += kChoices) {
    std::size_t best = draw(n);
    for (std::uint64_t i = 1; i < kChoices; ++i)
      if (const std::size_t other = draw(n + i); apart(other) > apart(best)) best = other;
    stops.push_back(best);
  }
  return stops;
}

double lengthOf(const std::vector<Place>& tree, const Stops& order) {
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    sum += length(tree[order[(i + 1) % order.size()]].at - tree[order[i]].at);
  return sum;
}

// From the first on.
Stops shortestOrder(const std::vector<Place>& tree, Stops stops) {
  std::sort(stops.begin() + 1, stops.end());
  Stops best = stops;
  do
    if (lengthOf(tree, stops) < lengthOf(tree, best)) best = stops;
  while (std::next_permutation(stops.begin() + 1, stops.end()));
  return best;
}

}  // namespace

std::vector<Vec3d> roundTrip(const FreeSpace& space, const std::vector<Place>& tree, double clearance,
                             std::size_t stops, std::uint64_t seed) {
  const Stops order = shortestOrder(tree, drawStops(tree, stops, seed));
  std::vector<Vec3d> corners;
  for (std::size_t i = 0; i < order.size(); ++i)
    appendShortened(space, tree, wayBetween(tree, order[i], order[(i + 1) % order.size()]), clearance,
                    corners);
  if (corners.empty()) corners.push_back(tree[order[0]].at);
  return corners;
}

}  // namespace saccade
