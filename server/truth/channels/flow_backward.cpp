// Optical flow into the frame before. Frame 0 has none.
#include "truth/flow.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class FlowBackward final : public TruthSource {
 public:
  explicit FlowBackward(const TruthConfig& config) : frames_(config.frames) {}

  TruthSamples sample(const FeedInterval& interval) override {
    const RenderedInterval& rendered = *interval.rendered;
    const Frame &cur = rendered.frames.cur, &prev = rendered.frames.prev;
    if (!frames_.takes(cur.index, cur.time)) return {};
    return {{cur.time.count(), flowPlanes({cur.g, rendered.camera, rendered.scene},
                                          {prev.g, rendered.camera_t0, rendered.scene_t0})}};
  }

 private:
  FrameSelection frames_;
};

}  // namespace

std::unique_ptr<TruthSource> makeFlowBackward(const TruthConfig& config) {
  return std::make_unique<FlowBackward>(config);
}

}  // namespace saccade
