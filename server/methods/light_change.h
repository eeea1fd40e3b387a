// The change of light at points of surfaces, where bodies move: what closed forms and shadow rays do not tell
// of it [ours].
//
// takes    paths of this frame, and what their replays in the world of the frame before have found
// returns  the change of illumination since then at the points of this frame, 0 where none is proven
#pragma once

#include "cache/grid/light_states.h"
#include "filter/filter_planes.h"
#include "methods/stage_times.h"

namespace saccade {

class LightChange {
 public:
  LightChange(int w, int h) : estimate_(w, h), planes_(w, h), scratch_(w, h) {}

  // `at`: the points of the frame in the grids of `light`, whose changes learn.
  void estimate(const FramePair& frames, const Placement& at, LightState& light, const PoolHandle& pool,
                StageTimes& times);
  // After estimate().
  const ImageF& change() const { return planes_.d; }

 private:
  GridEstimate estimate_;
  FilterPlanes planes_, scratch_;
};

}  // namespace saccade
