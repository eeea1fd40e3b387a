// What a bake knows of the two newest frames. It is read once for each frame: it never changes.
#pragma once

#include <memory>

#include "cache/baked_light.h"

namespace saccade {

class BakedFrames {
 public:
  using Time = SurfaceGrid::Time;

  BakedFrames(std::shared_ptr<const BakedLight> light, int width, int height);

  // Reads at the points of a tile of the next frame, and marks those that it knows.
  void look(Tile tile, Frame& next) { light_->read(tile, *next.surfaces, next.g, of_[next.index % 2]); }
  // What is known of a frame: of the newest, or of the one before it, which the next number stands for, too.
  const GridEstimate& of(FrameIndex frame) const { return of_[frame % 2]; }
  // Adds what is known of frame `cur` and of the one before it to estimates of all other points.
  Time add(FrameIndex cur, const PoolHandle& pool, GridEstimate& now, GridEstimate& before) const;

 private:
  std::shared_ptr<const BakedLight> light_;
  std::array<GridEstimate, 2> of_;  // in turn
};

}  // namespace saccade
