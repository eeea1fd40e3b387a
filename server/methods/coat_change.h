// The light of the coats of plastics, and its change, by pairs of paths [ours]. The grid keeps what their
// bases reflect. A coat shows light that moves unlike its surface, as metal does.
#pragma once

#include "base/pool_handle.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"
#include "frame/intensity_change.h"
#include "methods/stage_times.h"

namespace saccade {

class CoatChange {
 public:
  CoatChange(int width, int height);

  // Adds the light of both frames' coats, and its change, to what is known of all other light. Both frames
  // must follow those of the last call, unless it forgets.
  void addTo(IntensityChange& change, const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  // Forgets the last frame.
  void forget() { has_last_ = false; }

 private:
  void gather(const CoatSamples& coats, const PoolHandle& pool, StageTimes& times);
  // The change of this frame and that of the last one along the motion vectors.
  void joinLast(const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  // The light before, as the pairs know it, and as the last frame left it.
  void joinBefore(const CoatSamples& coats, const PoolHandle& pool, StageTimes& times);
  void add(const CoatSamples& coats, const PoolHandle& pool, IntensityChange& change, StageTimes& times);

  FilterPlanes filtered_, scratch_;  // light now, and its change
  ImageF d_, var_d_;                 // the change of this frame, joined with those before
  ImageF now_, var_now_;             // the light of the last frame
  ImageF before_, var_before_;       // the same, once this frame's pairs are joined
  ImageF carried_, var_carried_;
  bool has_last_ = false;
};

}  // namespace saccade
