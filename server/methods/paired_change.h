// The change of pixels that have pairs of paths. It is filtered over space, and joined with the change that
// their surfaces had one frame ago, as far as both agree [ours].
#pragma once

#include "base/pool_handle.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"
#include "frame/intensity_change.h"
#include "methods/stage_times.h"

namespace saccade {

class PairedChange {
 public:
  PairedChange(int width, int height);

  // Sets dI and var_dI of the pixels with PairSamples, and I_prev by what it already is there. All planes of
  // other pixels are known: it reads them. Both frames must follow those of the last call, unless it forgets.
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& change, StageTimes& times);
  // Forgets the last frame.
  void forget() { has_last_ = false; }

 private:
  void gather(const FramePair& frames, const IntensityChange& change, const PoolHandle& pool,
              StageTimes& times);
  void joinBefore(const FramePair& frames, const PoolHandle& pool, IntensityChange& change,
                  StageTimes& times);
  void joinLast(const FramePair& frames, const PoolHandle& pool, StageTimes& times);

  FilterPlanes filtered_, scratch_;  // reflected light now, and its change; Rec. 709 luminance
  ImageF last_, var_last_;           // the change of the last frame, and its variance
  bool has_last_ = false;
  ImageF carried_, var_carried_;  // what is joined with the estimate of this frame, and its variance
};

}  // namespace saccade
