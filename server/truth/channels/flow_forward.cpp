// Optical flow into the next frame. It is known once that is rendered; the last frame has none.
#include "truth/channels/channels.h"
#include "truth/flow.h"

namespace saccade {
namespace {

class FlowForward final : public TruthSource {
 public:
  explicit FlowForward(const TruthConfig& config) : frames_(config.frames) {}

  TruthSamples sample(const FeedInterval& interval) override {
    const auto& [cur, prev] = interval.frames;
    if (!frames_.takes(prev.index, prev.time)) return {};
    return {{prev.time.count(), flowPlanes({prev.g, interval.camera_t0}, {cur.g, interval.camera})}};
  }

 private:
  FrameSelection frames_;
};

}  // namespace

std::unique_ptr<TruthSource> makeFlowForward(const TruthConfig& config) {
  return std::make_unique<FlowForward>(config);
}

}  // namespace saccade
