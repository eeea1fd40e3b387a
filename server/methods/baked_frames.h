// What a bake knows of the two frames of a pair. It is read once for each frame: it never changes.
#pragma once

#include <memory>

#include "cache/baked_light.h"

namespace saccade {

class BakedFrames {
 public:
  using Time = SurfaceGrid::Time;

  BakedFrames(std::shared_ptr<const BakedLight> light, int width, int height);

  // Reads at the points of the next frame, and marks those that it knows. The frame that was the current one
  // is the previous one now.
  Time look(SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool);
  // Adds what is known of the current and of the previous frame to estimates of all other points.
  Time add(const PoolHandle& pool, GridEstimate& now, GridEstimate& before) const;

 private:
  std::shared_ptr<const BakedLight> light_;
  GridEstimate now_, prev_;
};

}  // namespace saccade
