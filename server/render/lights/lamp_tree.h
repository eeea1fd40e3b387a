// A tree over lamps: chooses one by what it can give at a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/wide.h"
#include "render/lights/lamp_bounds.h"

namespace saccade {

// The receiver of light: a point of a surface.
struct Receiver {
  Vec3 point;
  Vec3 normal;  // geometric, unit; light comes from its side alone
};

// A node has up to eight children, one in each lane. A child is chosen by an upper bound of the irradiance
// that its lamps can give [Conty Estevez and Kulla 2018], in a form without angles [ours], see weights().
// Probabilities are continuous in the point. One random number goes down the whole tree. So points that are
// close together choose equal lamps from equal numbers, nearly always.
class LampTree {
 public:
  struct Chosen {
    std::uint32_t lamp;
    float probability;  // 0: no lamp shines there
    float u;            // a random number in [0, 1) for further choices
  };

  // Lamps are numbered in the order given. There must be at least one.
  explicit LampTree(std::span<const LampBounds> lamps);

  Chosen choose(const Receiver& at, float u) const;
  float probability(std::uint32_t lamp, const Receiver& at) const;  // with which choose() finds it

 private:
  static constexpr int kChildren = 8;
  using F = Floats<kChildren>;

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
  static F weights(const Node& node, const Receiver& at);

  std::vector<Node> nodes_;
  std::vector<Place> places_;  // of the lamps
};

}  // namespace saccade
