// Pose of the camera at each frame.
#include "truth/path_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class CameraPose final : public PathSource {
 protected:
  std::vector<double> row(const Trajectory& path, TimeNs t) override {
    const auto [p, q] = path.at(t);
    return {p.x, p.y, p.z, q.x, q.y, q.z, q.w};
  }
};

}  // namespace

std::unique_ptr<TruthSource> makePose(const TruthConfig&) {
  return std::make_unique<CameraPose>();
}

}  // namespace saccade
