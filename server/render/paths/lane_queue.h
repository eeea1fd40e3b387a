// Rays and what belongs to them, kept until there are enough for a packet.
#pragma once

#include <array>

#include "base/wide.h"

namespace saccade {

// Entries of `kFields` numbers each.
template <int W, int kFields>
class LaneQueue {
 public:
  using Entries = std::array<Floats<W>, kFields>;  // a lane each

  // Adds the lanes of a set. There must be fewer than W entries.
  [[gnu::always_inline]] void push(LaneSet lanes, const Entries& entries) {
    for (int k = 0; k < kFields; ++k) compress(lanes, entries[k], &fields_[k][count_]);
    count_ += lanes.size();
  }
  bool full() const { return count_ >= W; }
  int size() const { return count_; }

  // Takes W entries out, or all if there are fewer. Returns how many.
  [[gnu::always_inline]] int take(Entries& out) {
    for (int k = 0; k < kFields; ++k) {
      out[k] = load<W>(&fields_[k][0]);
      store(load<W>(&fields_[k][W]), &fields_[k][0]);
    }
    const int taken = count_ < W ? count_ : W;
    count_ -= taken;
    return taken;
  }

 private:
  alignas(64) float fields_[kFields][2 * W] = {};
  int count_ = 0;
};

}  // namespace saccade
