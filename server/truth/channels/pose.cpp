// Pose of the camera at each frame.
#include "truth/path_source.h"
#include "truth/pose_rows.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class CameraPose final : public PathSource {
 protected:
  std::vector<double> row(const Trajectory& path, TimeNs t) override { return poseRow(path.at(t)); }
};

}  // namespace

std::unique_ptr<TruthSource> makePose(const TruthConfig&) {
  return std::make_unique<CameraPose>();
}

}  // namespace saccade
