// The change of pixels whose light the grid does not hold: metals and very dark surfaces. In the first frame
// of a new light these are all pixels. SVGF estimates them, and pairs of paths the change of those that have
// any.
#pragma once

#include <memory>

#include "methods/paired_change.h"
#include "methods/svgf.h"

namespace saccade {

class UncachedChange {
 public:
  // Tells of the next frame whether its lamps have other strengths than the one before.
  void next(bool light_changed);
  // Whether it reads the frame's PairSamples.
  bool needsPairs(const FramePair& frames) const;
  // Replaces the change of such pixels, or of all. `now`, `before`: the illumination of all others.
  void estimate(const FramePair& frames, bool all, const ImageF& now, const ImageF& before,
                const PoolHandle& pool, IntensityChange& out, StageTimes& times);

 private:
  void bySvgf(const FramePair& frames, bool all, const ImageF& now, const PoolHandle& pool,
              IntensityChange& out, StageTimes& times);

  std::uint32_t catch_up_ = 0;  // frames in which svgf_ still follows the last change of light
  // From the first frame on that needs it.
  std::unique_ptr<Svgf> svgf_;
  std::unique_ptr<IntensityChange> by_svgf_;
  std::unique_ptr<PairedChange> paired_;  // likewise
};

}  // namespace saccade
