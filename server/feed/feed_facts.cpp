#include "feed/feed_facts.h"

namespace saccade {

FeedFacts factsOf(const Rig& rig, const Trajectory& body, FrameIndex frames) {
  return {rig.first().firstFrameLuminance(0.01), rig.first().firstFrameLuminance(0.5), rig.pixelSpeed(frames),
          body.lastTime()};
}

}  // namespace saccade
