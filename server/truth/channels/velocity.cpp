// Velocity of the camera at each frame.
#include "truth/path_source.h"
#include "truth/pose_rows.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class CameraVelocity final : public PathSource {
 protected:
  std::vector<double> row(const Trajectory& path, TimeNs t) override {
    return velocityRow(path.velocityAt(t));
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeVelocity(const TruthConfig&) {
  return std::make_unique<CameraVelocity>();
}

}  // namespace saccade
