// A tree over lamps: chooses one by what it can give at a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/lane_vectors.h"
#include "render/lights/lamp_bounds.h"
#include "render/lights/lamp_sight.h"

namespace saccade {

// A node has up to eight children, one in each lane. A child is chosen by an upper bound of the irradiance
// that its lamps can give [Conty Estevez and Kulla 2018]. The form of weightsOf() in lamp_tree.cpp has no
// angles [ours]. Probabilities are continuous in the point. One number is hashed anew for each level. So
// points that are close together choose equal lamps from equal numbers, nearly always.
class LampTree {
 public:
  struct Chosen {
    std::uint32_t lamp;
    float probability;  // 0: no lamp shines there
    float u;            // a random number in [0, 1) for further choices
  };
  // Of several receivers, a lane each.
  struct ChosenLanes {
    std::uint32_t lamp[kLaneVectors];
    float probability[kLaneVectors], u[kLaneVectors];
  };

  // Lamps are numbered in the order given. There must be at least one.
  explicit LampTree(std::span<const LampBounds> lamps);

  std::size_t count() const { return places_.size(); }
  // The lamps below each of the root's children.
  const std::array<std::vector<std::uint32_t>, kLampGroups>& groups() const { return groups_; }
  // From now on lamps that are blocked are chosen less.
  void look(LampSight sight) { sight_ = std::move(sight); }
  // The shares of the groups that were seen from near a place; nullptr: nothing is known.
  const LampSight::Shares* seenFrom(const Receiver& at) const {
    return sight_.empty() ? nullptr : &sight_.at(at);
  }
  std::size_t groupOf(std::uint32_t lamp) const;

  Chosen choose(const Receiver& at, float u) const;
  // The same for the lanes of a set. `chosen.u` has their numbers.
  void choose(const LaneVectors& points, const LaneVectors& normals, LaneSet lanes,
              ChosenLanes& chosen) const;
  float probability(std::uint32_t lamp, const Receiver& at) const;  // with which choose() finds it

 private:
  static constexpr int kChildren = kLampGroups;
  struct Weights;  // of the children of a node

  struct alignas(64) Node {
    float x[kChildren], y[kChildren], z[kChildren], radius[kChildren];  // of a sphere around the lamps
    float axis_x[kChildren], axis_y[kChildren], axis_z[kChildren];
    float facing_offset[kChildren], facing_slope[kChildren];
    float strength[kChildren];       // 0: there is no child
    std::uint32_t child[kChildren];  // a node, or kLamp + a lamp
    std::uint32_t parent, slot;      // of the root: kNone
  };
  struct Place {
    std::uint32_t node, slot;
  };
  static constexpr std::uint32_t kLamp = 0x80000000u, kNone = 0xffffffffu;

  std::uint32_t build(std::span<const LampBounds> lamps, std::span<std::uint32_t> of, Place parent);
  void set(Place place, const LampBounds& bounds, std::uint32_t child);
  Weights weights(std::uint32_t node, const Receiver& at) const;
  bool descend(const Receiver& at, Chosen& at_node) const;

  std::vector<Node> nodes_;
  std::vector<Place> places_;  // of the lamps
  std::array<std::vector<std::uint32_t>, kLampGroups> groups_;
  LampSight sight_;
};

}  // namespace saccade
