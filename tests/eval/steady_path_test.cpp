#include "eval/bench/steady_path.h"

#include <cmath>

#include "scene/camera/motion.h"
#include "scene/scratch.h"

namespace saccade::eval {
namespace {

using namespace std::chrono_literals;

const Pose kStart{{1, 2, 3}, axisAngle({0.3, -0.2, 0.1})};
// On the axis, so that the pivot of an orbit is 4 ahead.
std::vector<Vec3d> probes() {
  return {kStart.position + rotate(kStart.rotation, Vec3d{0, 0, 4})};
}

Pose moved(const Trajectory& path, TimeNs t) {
  return inverse(kStart) * path.at(t);
}

TEST(StraightThrough, GoesOnBothBeforeAndAfterItsStart) {
  const Trajectory path = straightThrough(makeMotion({.kind = "truck", .speed = 2}, kStart, probes()), 700ms);
  expectNear(moved(path, 0ms).position, Vec3d{-1.4, 0, 0}, 1e-9);
  expectNear(moved(path, 700ms).position, Vec3d{}, 1e-12);
  expectNear(moved(path, 1s).position, Vec3d{0.6, 0, 0}, 1e-9);
}

// 100 degrees per second, where the motion itself turns back after kMaxOrbitRad.
TEST(TurningThrough, KeepsLookingAtThePivot) {
  const TimeNs at = 1003ms + 7us;
  const Trajectory path = turningThrough(makeMotion({.kind = "orbit", .speed = 100}, kStart, probes()), at);
  EXPECT_EQ(path.at(at), kStart);
  for (const TimeNs t : {TimeNs(0s), TimeNs(400ms), TimeNs(1003ms), TimeNs(1700ms)}) {
    const double turned = 100 * M_PI / 180 * seconds(t - at);
    // An orbit to the right turns to the left.
    expectNear(rotationVector(moved(path, t).rotation), Vec3d{0, -turned, 0}, 1e-6);
    expectNear(moved(path, t).position, Vec3d{4 * std::sin(turned), 0, 4 - 4 * std::cos(turned)}, 1e-5);
  }
}

}  // namespace
}  // namespace saccade::eval
