// The common part of channels that give one picture of a frame.
#pragma once

#include <utility>

#include "truth/truth_source.h"

namespace saccade {

// A frame of the feed.
struct TruthFrame {
  const Frame& frame;
  const ImageF& intensity;  // D[I], Rec. 709 luminance
  const Camera& camera;
  const RenderScene& scene;
};

class PictureSource : public TruthSource {
 public:
  explicit PictureSource(const TruthConfig& config) : frames_(config.frames) {}

  TruthSamples sample(const FeedInterval& interval) final;

 protected:
  // The planes of a frame, as in LAYOUT_PICTURE.
  virtual std::string picture(const TruthFrame& frame) = 0;

 private:
  void add(const TruthFrame& frame, TruthSamples& samples);

  FrameSelection frames_;
};

}  // namespace saccade
