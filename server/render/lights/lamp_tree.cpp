#include "render/lights/lamp_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/lane_vectors.h"
#include "render/lights/lamp_clusters.h"

namespace saccade {
namespace {

constexpr float kBelowOne = 1 - 0x1p-24f;

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
    const bool one = cluster.lamps.size() == 1;
    if (one) places_[cluster.lamps[0]] = place;
    set(place, cluster.bounds, one ? kLamp + cluster.lamps[0] : build(lamps, cluster.lamps, place));
    ++place.slot;
  }
  return node;
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

// strength / (d^2 + r^2), as of a disk of radius r on its axis, times both cosines. From anywhere in the
// sphere an angle x is at least x - asin(r/d) [spread]. With sin u = r/d,
//   cos(x - u) <= cos x + 2 sin(u/2),   2 sin(u/2) <= sin u (1 + (sqrt 2 - 1) sin^2 u) [ours]
LampTree::F LampTree::weights(const Node& node, const Receiver& at) {
  const auto of = [](const float* p) { return load<kChildren>(p); };
  const Vec3T<F> to{at.point.x - of(node.x), at.point.y - of(node.y), at.point.z - of(node.z)};
  const F d2 = max(dot(to, to), F(1e-30f)), inverse_d = 1.f / sqrt(d2), r = of(node.radius);
  const F sine = r * inverse_d, more = sine * (1.f + 0.41421356f * sine * sine);
  const Vec3T<F> axis{of(node.axis_x), of(node.axis_y), of(node.axis_z)};
  const auto clamped = [](const F& f) { return min(max(f, F(0.f)), F(1.f)); };
  const F facing =
      clamped((dot(axis, to) * inverse_d + more + of(node.facing_offset)) * of(node.facing_slope));
  const F horizon = clamped(more - dot(splat<F>(at.normal), to) * inverse_d);
  return of(node.strength) * facing * horizon / (d2 + r * r);
}

LampTree::Chosen LampTree::choose(const Receiver& at, float u) const {
  Chosen chosen{0, 1, u};
  for (const Node* node = nodes_.data();;) {
    alignas(64) float weight[kChildren], sum[kChildren];
    store(weights(*node, at), weight);
    float total = 0;
    for (int i = 0; i < kChildren; ++i) sum[i] = total += weight[i];
    if (!(total > 0)) return {0, 0, u};
    const float target = chosen.u * total;
    int i = std::min(lanesOf(load<kChildren>(sum) <= target).size(), kChildren - 1);
    while (weight[i] <= 0) --i;  // only where rounding has led beyond the last
    chosen.probability *= weight[i] / total;
    chosen.u = std::clamp((target - (i > 0 ? sum[i - 1] : 0)) / weight[i], 0.f, kBelowOne);
    chosen.lamp = node->child[i];
    if (chosen.lamp & kLamp) break;
    node = &nodes_[chosen.lamp];
  }
  chosen.lamp -= kLamp;
  return chosen;
}

float LampTree::probability(std::uint32_t lamp, const Receiver& at) const {
  float p = 1;
  for (Place place = places_[lamp]; place.node != kNone;) {
    const Node& node = nodes_[place.node];
    alignas(64) float weight[kChildren];
    store(weights(node, at), weight);
    float total = 0;
    for (const float w : weight) total += w;
    if (!(weight[place.slot] > 0)) return 0;
    p *= weight[place.slot] / total;
    place = {node.parent, node.slot};
  }
  return p;
}

}  // namespace saccade
