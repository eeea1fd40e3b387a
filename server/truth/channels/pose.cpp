// Pose of the camera at each frame.
#include <array>

#include "truth/channels/channels.h"

namespace saccade {
namespace {

class CameraPose final : public TruthSource {
 public:
  TruthSamples sample(const FeedInterval& interval) override {
    TruthSamples samples;
    if (interval.frames.prev.index == 0) samples.push_back(at(interval.path, interval.change.t0));
    samples.push_back(at(interval.path, interval.change.t1));
    return samples;
  }

 private:
  static TruthSample at(const Trajectory& path, TimeNs t) {
    const auto [p, q] = path.at(t);
    const std::array row{p.x, p.y, p.z, q.x, q.y, q.z, q.w};
    return {t.count(), std::string(reinterpret_cast<const char*>(row.data()), sizeof row)};
  }
};

}  // namespace

std::unique_ptr<TruthSource> makePose(const TruthConfig&) {
  return std::make_unique<CameraPose>();
}

}  // namespace saccade
