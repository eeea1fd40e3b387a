// The first passage of a Brownian motion with drift through one of two barriers.
#pragma once

#include <cstdint>

namespace saccade {

// Numbers of a motion, in a row that its key begins.
class NumberRow {
 public:
  explicit NumberRow(std::uint64_t key) : key_(key) {}
  double uniform();   // in (0, 1)
  double gaussian();  // standard normal

 private:
  std::uint64_t key_, taken_ = 0;
};

// A path begins at `v`, between the barriers -off and on. Over a time of 1 it moves by `drift` in the mean,
// with this variance > 0.
struct BrownianPath {
  double v, drift, variance;
};

struct Passage {
  bool crosses;  // a barrier within the time
  double at;     // when, in (0, 1], to within `resolution`; 1 without a passage
  double level;  // the barrier, or the level at the end
};

// Draws the first passage, or the level at the end. Its law does not depend on how a time is cut into paths
// [exact up to the resolution; ours]:
// - The end of a path is normal. Between its ends the path is a Brownian bridge, which passes a barrier with
// a
//   probability in closed form.
// - The time of a passage is found by halves. The middle of a bridge is normal, and is taken with the
//   probability that the bridge passes through one of its halves.
Passage firstPassage(const BrownianPath& path, double on, double off, double resolution, NumberRow& numbers);

}  // namespace saccade
