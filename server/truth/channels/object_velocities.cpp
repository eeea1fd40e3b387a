// Velocities of the objects that move, at each frame.
#include "truth/object_source.h"
#include "truth/pose_rows.h"

namespace saccade {
namespace {

class ObjectVelocities final : public ObjectSource {
 protected:
  std::vector<double> row(const Trajectory& path, TimeNs t) override {
    return velocityRow(path.velocityAt(t));
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeObjectVelocities(const TruthConfig&) {
  return std::make_unique<ObjectVelocities>();
}

}  // namespace saccade
