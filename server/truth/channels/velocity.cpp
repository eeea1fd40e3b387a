// Velocity of the camera at each frame.
#include "truth/path_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class CameraVelocity final : public PathSource {
 protected:
  std::vector<double> row(const Trajectory& path, TimeNs t) override {
    const auto [v, w] = path.velocityAt(t);
    return {v.x, v.y, v.z, w.x, w.y, w.z};
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeVelocity(const TruthConfig&) {
  return std::make_unique<CameraVelocity>();
}

}  // namespace saccade
