#include "render/lights/lamp_tree.h"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "base/hash_rng.h"
#include "render/lights/lamp_clusters.h"

namespace saccade {
namespace {

// strength / (d^2 + r^2), as of a disk of radius r on its axis, times both cosines. From anywhere in the
// sphere an angle x is at least x - asin(r/d) [spread]. With sin u = r/d,
//   cos(x - u) <= cos x + 2 sin(u/2),   2 sin(u/2) <= sin u (1 + (sqrt 2 - 1) sin^2 u) [ours]
[[gnu::always_inline]] inline __m256 weightsOf(const auto& node, const Receiver& at) {
  const auto all = [](float value) { return _mm256_set1_ps(value); };
  const __m256 x = all(at.point.x) - _mm256_load_ps(node.x), y = all(at.point.y) - _mm256_load_ps(node.y),
               z = all(at.point.z) - _mm256_load_ps(node.z), r = _mm256_load_ps(node.radius);
  const __m256 d2 = _mm256_max_ps(x * x + y * y + z * z, all(1e-30f));
  const __m256 inverse_d = all(1) / _mm256_sqrt_ps(d2);
  const __m256 sine = r * inverse_d, more = sine * (all(1) + all(0.41421356f) * sine * sine);
  const __m256 along =
      _mm256_load_ps(node.axis_x) * x + _mm256_load_ps(node.axis_y) * y + _mm256_load_ps(node.axis_z) * z;
  const __m256 below = all(at.normal.x) * x + all(at.normal.y) * y + all(at.normal.z) * z;
  const __m256 facing =
      (along * inverse_d + more + _mm256_load_ps(node.facing_offset)) * _mm256_load_ps(node.facing_slope);
  const __m256 horizon = more - below * inverse_d;
  const __m256 none = _mm256_setzero_ps();
  return _mm256_load_ps(node.strength) / (d2 + r * r) * _mm256_min_ps(_mm256_max_ps(facing, none), all(1)) *
         _mm256_min_ps(_mm256_max_ps(horizon, none), all(1));
}

[[gnu::always_inline]] inline __m256 runningSums(__m256 v) {
  const auto shifted = [](__m256 of, auto bytes) {
    return _mm256_castsi256_ps(_mm256_slli_si256(_mm256_castps_si256(of), bytes));
  };
  v = v + shifted(v, std::integral_constant<int, 4>());
  v = v + shifted(v, std::integral_constant<int, 8>());
  return v + _mm256_permute_ps(_mm256_permute2f128_ps(v, v, 0x08), 0xff);  // the sum of the lower half
}
[[gnu::always_inline]] inline float sumOf(__m256 v) {
  return _mm256_cvtss_f32(_mm256_permutevar8x32_ps(runningSums(v), _mm256_set1_epi32(7)));
}
[[gnu::always_inline]] inline unsigned positive(__m256 v) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(v, _mm256_setzero_ps(), _CMP_GT_OQ)));
}

// Of a node that has some of `sight`: mostly in proportion to what is seen of its children. A part is left to
// each that may shine there, whatever the samples say.
[[gnu::always_inline]] inline __m256 seenWeights(__m256 weights, const LampSight::Shares& sight) {
  constexpr float kUnseen = 0.05f, kEqual = 0.05f;
  const __m256 seen = weights * _mm256_load_ps(sight.of);
  const float all_seen = sumOf(seen);
  if (!(all_seen > 0)) return weights;
  const __m256 equal =
      _mm256_and_ps(_mm256_cmp_ps(weights, _mm256_setzero_ps(), _CMP_GT_OQ),
                    _mm256_set1_ps(kEqual / static_cast<float>(std::popcount(positive(weights)))));
  return seen * _mm256_set1_ps((1 - kUnseen - kEqual) / all_seen) +
         weights * _mm256_set1_ps(kUnseen / sumOf(weights)) + equal;
}

}  // namespace

LampTree::LampTree(std::span<const LampBounds> lamps) : places_(lamps.size()) {
  std::vector<std::uint32_t> numbers(lamps.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  build(lamps, numbers, {kNone, 0});
}

std::uint32_t LampTree::build(std::span<const LampBounds> lamps, std::span<std::uint32_t> of, Place parent) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({});
  nodes_[node].parent = parent.node, nodes_[node].slot = parent.slot;
  Place place{node, 0};
  for (const LampCluster& cluster : clustersOf(lamps, of, kChildren)) {
    if (node == 0) groups_[place.slot].assign(cluster.lamps.begin(), cluster.lamps.end());
    const bool one = cluster.lamps.size() == 1;
    if (one) places_[cluster.lamps[0]] = place;
    set(place, cluster.bounds, one ? kLamp + cluster.lamps[0] : build(lamps, cluster.lamps, place));
    ++place.slot;
  }
  return node;
}

std::size_t LampTree::groupOf(std::uint32_t lamp) const {
  Place place = places_[lamp];
  while (place.node != 0) place = {nodes_[place.node].parent, nodes_[place.node].slot};
  return place.slot;
}

void LampTree::set(Place place, const LampBounds& bounds, std::uint32_t child) {
  Node& n = nodes_[place.node];
  const std::uint32_t i = place.slot;
  const Vec3 centre = bounds.centre();
  n.x[i] = centre.x, n.y[i] = centre.y, n.z[i] = centre.z, n.radius[i] = bounds.radius();
  n.axis_x[i] = bounds.axis.x, n.axis_y[i] = bounds.axis.y, n.axis_z[i] = bounds.axis.z;
  n.facing_offset[i] = 2 * std::sin(bounds.spread / 2) - bounds.dark;
  n.facing_slope[i] = 1 / std::max(1e-3f, bounds.bright - bounds.dark);
  n.strength[i] = bounds.strength, n.child[i] = child;
}

struct LampTree::Weights {
  explicit Weights(__m256 weights) : sums(runningSums(weights)), lit(positive(weights)) {
    _mm256_store_ps(of, weights), _mm256_store_ps(sum, sums);
  }
  float total() const { return sum[kChildren - 1]; }
  // The child whose part of the total holds `target`.
  int childAt(float target) const {
    const __m256 before = _mm256_cmp_ps(sums, _mm256_set1_ps(target), _CMP_LE_OQ);
    const int i = std::min(std::popcount(static_cast<unsigned>(_mm256_movemask_ps(before))), kChildren - 1);
    // Rounding may lead to a child without weight.
    const unsigned not_after = lit & ((2u << i) - 1);
    return not_after != 0 ? std::bit_width(not_after) - 1 : std::countr_zero(lit);
  }

  __m256 sums;
  unsigned lit;                                     // bits of those above 0
  alignas(32) float of[kChildren], sum[kChildren];  // each; with those before
};

[[gnu::always_inline]] inline LampTree::Weights LampTree::weights(std::uint32_t node,
                                                                  const Receiver& at) const {
  const __m256 all = weightsOf(nodes_[node], at);
  return Weights(node > 0 || sight_.empty() ? all : seenWeights(all, sight_.at(at)));
}

// Goes on from `lamp`, a node, to one of its children. Returns whether that is a node.
[[gnu::always_inline]] inline bool LampTree::descend(const Receiver& at, Chosen& chosen) const {
  const Weights w = weights(chosen.lamp, at);
  if (!(w.total() > 0)) return chosen.probability = 0, false;
  const float target = chosen.u * w.total();
  const int i = w.childAt(target);
  chosen.probability *= w.of[i] / w.total();
  // The rest of the number would change a thousand times faster with the point.
  chosen.u = toUnit(mix32(std::bit_cast<std::uint32_t>(chosen.u) + 1));
  chosen.lamp = nodes_[chosen.lamp].child[i];
  return (chosen.lamp & kLamp) == 0;
}

LampTree::Chosen LampTree::choose(const Receiver& at, float u) const {
  Chosen chosen{0, 1, u};
  while (descend(at, chosen)) {
  }
  chosen.lamp &= ~kLamp;
  return chosen;
}

// Level by level, so that the lanes do not wait for each other.
void LampTree::choose(const LaneVectors& points, const LaneVectors& normals, LaneSet lanes,
                      ChosenLanes& chosen) const {
  forEachLane(lanes, [&](int i) { chosen.lamp[i] = 0, chosen.probability[i] = 1; });
  for (LaneSet open = lanes; open.any();) {
    LaneSet next;
    forEachLane(open, [&](int i) {
      Chosen one{chosen.lamp[i], chosen.probability[i], chosen.u[i]};
      if (descend({points.at(i), normals.at(i)}, one)) next.add(i);
      chosen.lamp[i] = one.lamp, chosen.probability[i] = one.probability, chosen.u[i] = one.u;
    });
    open = next;
  }
  forEachLane(lanes, [&](int i) { chosen.lamp[i] &= ~kLamp; });
}

float LampTree::probability(std::uint32_t lamp, const Receiver& at) const {
  float p = 1;
  for (Place place = places_[lamp]; place.node != kNone;) {
    const Weights w = weights(place.node, at);
    if (!(w.of[place.slot] > 0)) return 0;
    p *= w.of[place.slot] / w.total();
    place = {nodes_[place.node].parent, nodes_[place.node].slot};
  }
  return p;
}

}  // namespace saccade
