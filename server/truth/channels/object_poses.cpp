// Poses of the objects that move, at each frame.
#include "truth/object_source.h"
#include "truth/pose_rows.h"

namespace saccade {
namespace {

class ObjectPoses final : public ObjectSource {
 protected:
  std::vector<double> row(const Trajectory& path, TimeNs t) override { return poseRow(path.at(t)); }
};

}  // namespace

std::unique_ptr<TruthSource> makeObjectPoses(const TruthConfig&) {
  return std::make_unique<ObjectPoses>();
}

}  // namespace saccade
