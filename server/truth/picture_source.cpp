#include "truth/picture_source.h"

namespace saccade {

// The first interval of a feed also completes frame 0.
TruthSamples PictureSource::sample(const FeedInterval& interval) {
  const IntensityChange& change = interval.change;
  std::optional<RenderedFrame> prev, cur;
  if (interval.rendered) {
    const auto& [frames, camera, camera_t0, path, scene, scene_t0] = *interval.rendered;
    prev.emplace(RenderedFrame{frames.prev, camera_t0, scene_t0});
    cur.emplace(RenderedFrame{frames.cur, camera, scene});
  }
  TruthSamples samples;
  if (change.frame == 1) add({0, change.t0, change.I_prev, prev ? &*prev : nullptr}, samples);
  if (interval.ends_frame) add({interval.frame, change.t1, change.I_now, cur ? &*cur : nullptr}, samples);
  return samples;
}

void PictureSource::add(const TruthFrame& frame, TruthSamples& samples) {
  if (!frames_.takes(frame.index, frame.time)) return;
  samples.push_back({frame.time.count(), picture(frame)});
}

}  // namespace saccade
