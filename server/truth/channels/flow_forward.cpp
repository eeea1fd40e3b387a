// Optical flow into the next frame. It is known once that is rendered; the last frame has none.
#include "truth/flow.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class FlowForward final : public TruthSource {
 public:
  explicit FlowForward(const TruthConfig& config) : frames_(config.frames) {}

  TruthSamples sample(const FeedInterval& interval) override {
    const RenderedInterval& rendered = *interval.rendered;
    const Frame &cur = rendered.frames.cur, &prev = rendered.frames.prev;
    if (!frames_.takes(prev.index, prev.time)) return {};
    return {{prev.time.count(), flowPlanes({prev.g, rendered.camera_t0, rendered.scene_t0},
                                           {cur.g, rendered.camera, rendered.scene})}};
  }

 private:
  FrameSelection frames_;
};

}  // namespace

std::unique_ptr<TruthSource> makeFlowForward(const TruthConfig& config) {
  return std::make_unique<FlowForward>(config);
}

}  // namespace saccade
