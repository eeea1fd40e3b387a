// The common part of channels that give one picture of a frame.
#pragma once

#include <utility>

#include "truth/truth_source.h"

namespace saccade {

// A frame as it was rendered.
struct RenderedFrame {
  const Frame& frame;
  const Camera& camera;
  const PosedScene& scene;
};

// A frame of the feed.
struct TruthFrame {
  FrameIndex index;
  TimeNs time;
  const ImageF& intensity;        // D[I], Rec. 709 luminance
  const RenderedFrame* rendered;  // nullptr where a client has sent it
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
