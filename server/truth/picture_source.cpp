#include "truth/picture_source.h"

namespace saccade {

// The first interval of a feed also completes frame 0.
TruthSamples PictureSource::sample(const FeedInterval& interval) {
  const auto& [change, frames, camera, camera_t0, path, scene] = interval;
  TruthSamples samples;
  if (frames.prev.index == 0) add({frames.prev, change.I_prev, camera_t0, scene}, samples);
  add({frames.cur, change.I_now, camera, scene}, samples);
  return samples;
}

void PictureSource::add(const TruthFrame& frame, TruthSamples& samples) {
  if (!frames_.takes(frame.frame.index, frame.frame.time)) return;
  samples.push_back({frame.frame.time.count(), picture(frame)});
}

}  // namespace saccade
