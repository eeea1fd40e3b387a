// The levels of a bake, from fine to coarse.
#pragma once

#include <vector>

#include "cache/bake/baked_level.h"

namespace saccade {

struct BakedLevels {
  const BakedLevel& at(int exponent) const {
    const int i = exponent - first;
    return i >= 0 && i < static_cast<int>(levels.size()) ? levels[i] : none;
  }
  // A level, and the next coarser one.
  struct Two {
    const BakedLevel *fine, *coarse;
    int exponent;  // of the fine one
  };
  Two from(int exponent) const { return {&at(exponent), &at(exponent + 1), exponent}; }

  int first = 0;  // the exponent of the finest
  std::vector<BakedLevel> levels;
  BakedLevel none;
};

}  // namespace saccade
