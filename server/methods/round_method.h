// A method that samples the pixels of a frame in rounds, until it knows enough of each.
#pragma once

#include "methods/method.h"

namespace saccade {

// Its paths are those of SeedPlan::independent, and all are in pass 2.
class RoundMethod : public Method {
 public:
  RoundMethod* inRounds() final { return this; }
  // Marks the pixels that get more paths of this frame, and returns how many each gets; 0: the frame is done.
  // `spp`: the most of a pixel, over all rounds. Called before each round.
  virtual int nextRound(int spp, const PoolHandle& pool) = 0;
  virtual const Image<int>& wanted() const = 0;  // 0: the pixel gets none
  // Takes what the round has found, FrameSamples::I2 of the pixels that it marked. Makes I2 the mean over all
  // rounds of the frame. start() or estimate() follows the last one.
  virtual void take(Frame& frame, const PoolHandle& pool) = 0;
};

}  // namespace saccade
