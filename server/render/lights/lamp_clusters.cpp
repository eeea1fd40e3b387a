#include "render/lights/lamp_clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace saccade {
namespace {

constexpr int kBins = 16;

LampBounds boundsOf(std::span<const LampBounds> lamps, std::span<const std::uint32_t> numbers) {
  LampBounds all = lamps[numbers[0]];
  for (const std::uint32_t i : numbers.subspan(1)) all = merged(all, lamps[i]);
  return all;
}

float costOf(const LampBounds& b) {
  const float radius = b.radius();
  return b.strength * radius * radius * (1 + 2 * std::sin(b.spread / 2));
}

// A plane across an axis, at the lower side of a bin.
struct Split {
  int axis = -1, bin = 0;
  float low = 0, width = 0;  // of all bins
  float cost = std::numeric_limits<float>::infinity();

  int binOf(const LampBounds& lamp) const {
    const float at = coordinate(lamp.centre());
    return std::clamp(static_cast<int>((at - low) / width * kBins), 0, kBins - 1);
  }
  float coordinate(Vec3 v) const { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
};

// The best of an axis, if the centres differ along it.
Split bestAlong(int axis, std::span<const LampBounds> lamps, std::span<const std::uint32_t> numbers) {
  Split split{axis};
  float high = -std::numeric_limits<float>::infinity();
  split.low = -high;
  for (const std::uint32_t i : numbers) {
    const float at = split.coordinate(lamps[i].centre());
    split.low = std::min(split.low, at), high = std::max(high, at);
  }
  split.width = high - split.low;
  if (!(split.width > 0)) return split;
  struct Bin {
    bool any = false;
    LampBounds bounds;
    void add(const LampBounds& b) { bounds = any ? merged(bounds, b) : b, any = true; }
    float cost() const { return any ? costOf(bounds) : 0; }
  };
  std::array<Bin, kBins> bins;
  for (const std::uint32_t i : numbers) bins[static_cast<std::size_t>(split.binOf(lamps[i]))].add(lamps[i]);
  std::array<float, kBins> above{};  // cost of the bins from there on
  Bin side;
  for (std::size_t k = kBins; k-- > 1;) {
    if (bins[k].any) side.add(bins[k].bounds);
    above[k] = side.cost();
  }
  side = {};
  for (std::size_t k = 1; k < kBins; ++k) {
    if (bins[k - 1].any) side.add(bins[k - 1].bounds);
    if (const float cost = side.cost() + above[k]; cost < split.cost)
      split.cost = cost, split.bin = static_cast<int>(k);
  }
  return split;
}

// The number of lamps in the first part. Lamps at one place are halved.
std::size_t divide(std::span<const LampBounds> lamps, std::span<std::uint32_t> numbers) {
  Split best;
  for (int axis = 0; axis < 3; ++axis)
    if (const Split split = bestAlong(axis, lamps, numbers); split.cost < best.cost) best = split;
  if (best.axis < 0) return numbers.size() / 2;
  const auto middle = std::stable_partition(numbers.begin(), numbers.end(),
                                            [&](std::uint32_t i) { return best.binOf(lamps[i]) < best.bin; });
  const auto first = static_cast<std::size_t>(middle - numbers.begin());
  return first == 0 || first == numbers.size() ? numbers.size() / 2 : first;
}

}  // namespace

std::vector<LampCluster> clustersOf(std::span<const LampBounds> lamps, std::span<std::uint32_t> numbers,
                                    std::size_t count) {
  std::vector<LampCluster> clusters{{numbers, boundsOf(lamps, numbers)}};
  while (clusters.size() < std::min(count, numbers.size())) {
    const auto priority = [](const LampCluster& c) { return c.lamps.size() < 2 ? -1 : costOf(c.bounds); };
    const auto widest = std::max_element(
        clusters.begin(), clusters.end(),
        [&](const LampCluster& a, const LampCluster& b) { return priority(a) < priority(b); });
    const std::span<std::uint32_t> all = widest->lamps;
    const std::size_t first = divide(lamps, all);
    *widest = {all.first(first), boundsOf(lamps, all.first(first))};
    clusters.push_back({all.subspan(first), boundsOf(lamps, all.subspan(first))});
  }
  return clusters;
}

}  // namespace saccade
