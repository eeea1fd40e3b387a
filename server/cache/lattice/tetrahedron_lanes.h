// The tetrahedra around several points of one level at once: what Tetrahedron finds for each.
#pragma once

#include "base/wide.h"
#include "cache/lattice/lanes.h"
#include "cache/lattice/lattice.h"

namespace saccade {

class TetrahedronLanes {
 public:
  static constexpr int kLanes = 8;
  using F = Floats<kLanes>;

  void setPoint(int lane, Vec3 position) {
    position_[0][lane] = position.x, position_[1][lane] = position.y, position_[2][lane] = position.z;
  }
  Vec3 point(int lane) const { return {position_[0][lane], position_[1][lane], position_[2][lane]}; }
  // Of all points that have been set. Cells have the edge 1 / `inv_h`, powers of two: nothing is rounded but
  // the fraction of a negative number, as in Tetrahedron.
  void find(const F& inv_h) {
    std::array<F, 3> within;
    for (int axis = 0; axis < 3; ++axis) {
      const F q = load<kLanes>(position_[axis]) * inv_h, low = floor(q);
      within[axis] = q - low;
      const Uints<kLanes> whole =
          toUints(F(low - floor(low * 0x1p-19f) * 0x1p19f));  // addresses have 19 bits
      store(Uints<kLanes>((whole + Tetrahedron::kCentre) & Tetrahedron::kAddressMask), low_[axis]);
    }
    const auto& [x, y, z] = within;
    const auto bit = [](const auto& condition, float value) { return select(condition, F(value), F(0.f)); };
    store(toUints(F(bit(x >= y, 1) + bit(x >= z, 2) + bit(y >= z, 4))), order_);
    const F a = max(x, max(y, z)), c = min(x, min(y, z)), b = max(min(x, y), min(max(x, y), z));
    store(F(1.f - a), weight_[0]), store(F(a - b), weight_[1]);
    store(F(b - c), weight_[2]), store(c, weight_[3]);
  }
  // As Tetrahedron has them.
  VertexKey lowest(int lane, int bin) const {
    return Tetrahedron::lowest(low_[0][lane], low_[1][lane], low_[2][lane], bin);
  }
  unsigned order(int lane) const { return order_[lane]; }
  Quad weights(int lane) const {
    return Quad{weight_[0][lane], weight_[1][lane], weight_[2][lane], weight_[3][lane]};
  }

 private:
  alignas(64) float position_[3][kLanes] = {};
  alignas(64) std::uint32_t low_[3][kLanes];  // addresses
  alignas(64) std::uint32_t order_[kLanes];
  alignas(64) float weight_[4][kLanes];
};

}  // namespace saccade
