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
  // Demodulates what is known of each pixel.
  void gather(const FramePair& frames, const IntensityChange& change, const PoolHandle& pool,
              StageTimes& times);
  // The illumination before, as the pairs know it, and as `change` does.
  void joinBefore(const FramePair& frames, const PoolHandle& pool, const IntensityChange& change,
                  StageTimes& times);
  // The change of this frame and that of the last one along the motion vectors. A reflection that does not
  // follow its surface makes them differ.
  void joinLast(const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  void modulate(const FramePair& frames, const PoolHandle& pool, IntensityChange& change,
                StageTimes& times) const;

  FilterPlanes filtered_, scratch_;  // illumination now, and its change
  ImageF last_, var_last_;           // the change of illumination of the last frame
  bool has_last_ = false;
  ImageF carried_, var_carried_;  // what is joined with the estimate of this frame
  ImageF before_, var_before_;    // the illumination of the frame before
};

}  // namespace saccade
