// Which groups of lamps are seen from where, learned from samples.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "render/lights/receiver.h"

namespace saccade {

inline constexpr std::size_t kLampGroups = 8;

// A place, and what it saw of one lamp of each group.
struct SightSample {
  enum Seen : std::uint8_t { kNothing, kLamp, kBlocked };  // kNothing: the lamp shines or lies elsewhere
  Receiver at;
  std::array<Seen, kLampGroups> seen;
};

// The space of points and normals is divided into boxes, in each of which nearly all samples saw the same
// [ours]. It is a decision tree: each split is the one that leaves the least variance (Breiman et al. 1984).
class LampSight {
 public:
  // By group: the share of the samples that saw a lamp, among those that could.
  struct alignas(32) Shares {
    float of[kLampGroups];
  };

  LampSight() = default;  // empty: nothing is known
  explicit LampSight(std::vector<SightSample> samples);

  bool empty() const { return boxes_.empty(); }
  const Shares& at(const Receiver& receiver) const {
    std::uint32_t i = 0;
    while (nodes_[i].axis != kBox)
      i = nodes_[i].next + (coordinate(receiver, nodes_[i].axis) >= nodes_[i].plane ? 1 : 0);
    return boxes_[nodes_[i].next];
  }

 private:
  struct Node {
    float plane;
    std::uint32_t axis;  // of six, or kBox
    std::uint32_t next;  // the first of two nodes, or the number of the box
  };
  static constexpr std::uint32_t kBox = 6;

  static float coordinate(const Receiver& r, std::uint32_t axis) {
    const Vec3 v = axis < 3 ? r.point : r.normal;
    return axis % 3 == 0 ? v.x : axis % 3 == 1 ? v.y : v.z;
  }
  void divide(std::uint32_t node, std::span<SightSample> samples, int depth);

  std::vector<Node> nodes_;
  std::vector<Shares> boxes_;
};

}  // namespace saccade
