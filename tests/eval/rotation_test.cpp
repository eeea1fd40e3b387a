#include "eval/tasks/rotation.h"

#include <gtest/gtest.h>

#include "eval/task_truths.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr int kWidth = 96, kHeight = 72;
constexpr double kSpan = 0.032;  // a window

// Far points, seen by a camera that turns by w: a direction d goes to exp(-w t) d.
Events seenTurning(const CameraModel& camera, Vec3d w, double span_s) {
  return test::eventsOfPoints(300, 8, kWidth, kHeight, span_s, [&](Vec2 p, double t) {
    const Vec3d d =
        rotate(axisAngle(w * -t), {(p.x - camera.cx) / camera.fx, (p.y - camera.cy) / camera.fy, 1});
    return Vec2{static_cast<float>(camera.cx + camera.fx * d.x / d.z),
                static_cast<float>(camera.cy + camera.fy * d.y / d.z)};
  });
}

TEST(Rotation, IsFoundAboutAllAxes) {
  const CameraModel camera = pinhole(60, kWidth, kHeight);
  for (const Vec3d w : {Vec3d{0, 1.5, 0}, Vec3d{-1, 0.5, 2}, Vec3d{0.3, -0.2, -3}}) {
    const Events events = seenTurning(camera, w, kSpan);
    const Vec3d found = rotationOf(events, camera, TimeNs(16'000'000), kSpan, {});
    EXPECT_LT(length(found - w), 0.05 * length(w)) << w.x << ' ' << w.y << ' ' << w.z;
  }
}

TEST(Rotation, IsScoredAgainstTheCamera) {
  const Vec3d w{0, 1.5, 0};
  TaskTruth truth = test::steadyTruth(kWidth, kHeight, 16, {});
  EXPECT_FALSE(truth.onlyTurns());
  for (TruthFrame& frame : truth.frames) frame.camera.angular = w;
  EXPECT_TRUE(truth.onlyTurns());
  const Events events = seenTurning(truth.camera, w, 2 * kSpan);
  const TaskScore score = scoreRotation({events, {}, 0.2, 1e-3, truth});
  EXPECT_LT(score.error, 0.05);
  EXPECT_EQ(score.answers, 2u);
  for (TruthFrame& frame : truth.frames) frame.camera.angular = w * -1.0;
  EXPECT_NEAR(scoreRotation({events, {}, 0.2, 1e-3, truth}).error, 2, 0.05);
  truth.frames.back().camera.linear = {0.1, 0, 0};
  EXPECT_FALSE(truth.onlyTurns());
}

}  // namespace
}  // namespace saccade::eval
