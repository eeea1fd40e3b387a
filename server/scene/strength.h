// The strength of an emitter over time, for lamps that are switched, fade or flicker.
#pragma once

#include <vector>

#include "base/units.h"

namespace saccade {

struct StrengthKey {
  TimeNs time;   // stream time, at least 0
  float factor;  // on the emitter's radiance; finite, at least 0
};

// The factor on an emitter's radiance as a function of stream time: linear between keys, held before the
// first and after the last. Keys at the same time make a step; at that time the last of them holds.
class Strength {
 public:
  Strength() = default;                              // 1 at all times
  explicit Strength(std::vector<StrengthKey> keys);  // at least one; times never decrease
  // Starts again at 0 after `period`, which is above 0 and not before the last key.
  static Strength periodic(std::vector<StrengthKey> keys, TimeNs period);

  bool isSteady() const { return keys_.empty(); }  // 1 at all times
  float at(TimeNs t) const;                        // t >= 0

 private:
  std::vector<StrengthKey> keys_;
  TimeNs period_ = TimeNs::max();
};

}  // namespace saccade
