#include "eval/tasks/moving_things.h"

#include <gtest/gtest.h>

#include "eval/task_truths.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr int kSize = 64;
constexpr double kSpan = 0.064, kMiddle = (kSize - 1) / 2.0;

// Every place moves by the same similarity, but for a square of 16 pixels that moves by itself.
bool isInSquare(Vec2 p) {
  return p.x >= 24 && p.x < 40 && p.y >= 24 && p.y < 40;
}

Events sceneWith(const GlobalMotion& m, Vec2 square) {
  return test::eventsOfPoints(150, 24, kSize, kSize, kSpan, [&](Vec2 p, double t) {
    const double x = p.x - kMiddle, y = p.y - kMiddle, dt = t - kSpan / 2;
    if (isInSquare(p))
      return Vec2{static_cast<float>(p.x + square.x * dt), static_cast<float>(p.y + square.y * dt)};
    return Vec2{static_cast<float>(p.x + dt * (m.x + m.expansion * x - m.turn * y)),
                static_cast<float>(p.y + dt * (m.y + m.turn * x + m.expansion * y))};
  });
}

TEST(GlobalMotion, IsFoundDespiteAnObject) {
  const GlobalMotion truth{60, -20, 0.75, -1};
  const GlobalMotion found =
      globalMotion(sceneWith(truth, {-50, 0}), kSize, kSize, TimeNs(32'000'000), kSpan);
  EXPECT_NEAR(found.x, truth.x, 8);
  EXPECT_NEAR(found.y, truth.y, 8);
  EXPECT_NEAR(found.expansion, truth.expansion, 0.2);
  EXPECT_NEAR(found.turn, truth.turn, 0.2);
}

// The truth has the square as a body where it is in the middle of the window.
TEST(MovingObjects, StandOutByTheirTimes) {
  TaskTruth truth = test::steadyTruth(kSize, kSize, 16, {});
  EXPECT_FALSE(truth.hasBodies());
  for (TruthFrame& frame : truth.frames)
    for (int y = 24; y < 40; ++y)
      for (int x = 24; x < 40; ++x) frame.body.at(x, y) = 1;
  EXPECT_TRUE(truth.hasBodies());
  const Events moving = sceneWith({60, 0, 0, 0}, {-65, 0});
  EXPECT_LT(scoreMovingObjects({moving, {}, 0.2, 1e-3, truth}).error, 0.35);
  const Events one = sceneWith({60, 0, 0, 0}, {60, 0});  // the square goes with the rest
  EXPECT_NEAR(scoreMovingObjects({one, {}, 0.2, 1e-3, truth}).error, 0.5, 0.1);
}

}  // namespace
}  // namespace saccade::eval
