// Facts of a rig that are known before its first step.
#pragma once

#include "feed/rig.h"

namespace saccade {

// 0 where a client sends the frames.
struct FeedFacts {
  float luminance_p01 = 0, luminance_p50 = 0;  // of frame 0, in view 0
  PixelSpeed pixel_speed = {};
  TimeNs last_pose{};  // of the body's path
};

// `body`: the path of `rig`. `frames`: those of the stream; 0: it has no end. Call it before any step.
FeedFacts factsOf(const Rig& rig, const Trajectory& body, FrameIndex frames);

}  // namespace saccade
