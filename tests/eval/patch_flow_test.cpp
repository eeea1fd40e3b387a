#include "eval/tasks/patch_flow.h"

#include <gtest/gtest.h>

#include "eval/task_truths.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

constexpr int kSize = 48;
constexpr Vec2 kFlow{100, -60};  // pixels per second

Events drifting(int points, double span_s) {
  return test::eventsOfPoints(points, 40, kSize, kSize, span_s, [](Vec2 p, double t) {
    return Vec2{static_cast<float>(p.x + kFlow.x * t), static_cast<float>(p.y + kFlow.y * t)};
  });
}

TEST(WarpedEvents, AreSharedAmongPixels) {
  WarpedEvents image(4, 2);
  image.add({1.25f, 0.5f}, 8);
  image.add({3.5f, 0});  // outside
  EXPECT_FLOAT_EQ(image.at({1, 0}), 3);
  EXPECT_FLOAT_EQ(image.at({2, 1}), 1);
  EXPECT_FLOAT_EQ(image.at({1.5f, 0.5f}), 2);
  EXPECT_FLOAT_EQ(image.at({3, 0}), 0);
  // 3, 3, 1, 1 and four pixels of 0.
  EXPECT_NEAR(image.variance(), 20.0 / 8 - 1, 1e-6);
}

TEST(WarpedEvents, AreBlurredByOnePixel) {
  WarpedEvents image(9, 9);
  image.add({4, 4}, 256);
  image.blur();
  EXPECT_FLOAT_EQ(image.at({4, 4}), 36);
  EXPECT_FLOAT_EQ(image.at({5, 2}), 4);
  EXPECT_FLOAT_EQ(image.at({7, 4}), 0);
}

TEST(PatchFlow, IsThatOfItsPoints) {
  Events events = drifting(40, 0.032);
  std::erase_if(events, [](const Event& e) { return e.x < 16 || e.x >= 32 || e.y < 16 || e.y >= 32; });
  const Vec2 flow = patchFlow(events, 16, 16, TimeNs(16'000'000), 0.032);
  // Events have whole pixels, and the contrast is a little higher where they stay on them.
  EXPECT_NEAR(flow.x, kFlow.x, 12);
  EXPECT_NEAR(flow.y, kFlow.y, 12);
}

TEST(PatchFlow, IsScoredByWindowAndPatch) {
  const Events events = drifting(40, 0.064);
  const TaskScore score = scorePatchFlow({events, {}, 0.2, 1e-3, test::steadyTruth(kSize, kSize, 16, kFlow)});
  EXPECT_LT(score.error, 0.2);
  EXPECT_GE(score.answers, 12u);  // of 2 windows of 9 patches
  // Against a world that moves the other way it is wrong by twice the flow.
  const Vec2 back{-kFlow.x, -kFlow.y};
  EXPECT_NEAR(scorePatchFlow({events, {}, 0.2, 1e-3, test::steadyTruth(kSize, kSize, 16, back)}).error, 2,
              0.2);
}

}  // namespace
}  // namespace saccade::eval
