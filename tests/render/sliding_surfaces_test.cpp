#include "render/world/sliding_surfaces.h"

#include <gtest/gtest.h>

#include "render/moving_room.h"

namespace saccade {
namespace {

using namespace test;

constexpr float kOffset = 2e-5f;

// A level card of edge 2 about the origin.
std::shared_ptr<const RenderScene> card() {
  Scene s = furnace(0.6f, 0);
  s.meshes.push_back(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, 0));
  s.meshes.back().name = "card";
  const std::string names[]{"card"};
  setBodies(s, names);
  return std::make_shared<RenderScene>(std::move(s));
}

// After the card has made this step, and has then stood.
SlidingSurfaces after(const std::shared_ptr<const RenderScene>& scene, const Pose& step) {
  const Body& body = scene->description().bodies[0];
  const PosedScene before(scene, {standing(body)}), now(scene, {standing(body, step)});
  SlidingSurfaces sliding;
  sliding.next(now, before);
  sliding.next(now, now);
  return sliding;
}

TEST(SlidingSurfaces, AreThoseThatStayInTheirPlace) {
  const auto scene = card();
  const Vec3 up{0, 0, 1};
  const SlidingSurfaces turned = after(scene, {{}, axisAngle({0, 0, 0.1})});
  EXPECT_TRUE(turned.at(0, {{0.3f, 0.4f, 0}, up, kOffset}));
  const SlidingSurfaces slid = after(scene, {{0.1, 0, 0}, {}});
  EXPECT_TRUE(slid.at(0, {{0.3f, 0.4f, 0}, up, kOffset}));
  EXPECT_TRUE(slid.at(0, {{1.05f, 0, 0}, up, kOffset}));   // it has come here
  EXPECT_TRUE(slid.at(0, {{-0.85f, 0, 0}, up, kOffset}));  // the next step leaves it
}

TEST(SlidingSurfaces, AreNotThoseThatRiseOrTilt) {
  const auto scene = card();
  const SlidingSurfaces risen = after(scene, {{0.1, 0, 0.05}, {}});
  EXPECT_FALSE(risen.at(0, {{0.3f, 0.4f, 0.05f}, {0, 0, 1}, kOffset}));
  const SlidingSurfaces tilted = after(scene, {{}, axisAngle({0.1, 0, 0})});
  const Vec3 normal{0, -std::sin(0.1f), std::cos(0.1f)};
  EXPECT_FALSE(tilted.at(0, {{0.3f, 0, 0}, normal, kOffset}));
  EXPECT_FALSE(tilted.at(0, {{0.3f, 0.5f * std::cos(0.1f), 0.5f * std::sin(0.1f)}, normal, kOffset}));
}

// A wall at a distance of 1 from the axis about which it turns. Beside the foot of the axis it comes forward
// by more than rays start off it. So a place of it lies within the body at the other time.
TEST(SlidingSurfaces, AreNotThoseThatTurnAboutAFarAxis) {
  constexpr double kTurn = 0.002;
  const auto scene = card();
  const SlidingSurfaces turned =
      after(scene, {{0, std::sin(kTurn), 1 - std::cos(kTurn)}, axisAngle({kTurn, 0, 0})});
  const Vec3 normal{0, -std::sin(float{kTurn}), std::cos(float{kTurn})};
  EXPECT_FALSE(turned.at(0, {{0, 0.03f, 0.03f * float{kTurn}}, normal, kOffset}));
  EXPECT_FALSE(turned.at(0, {{0, float{kTurn}, float(kTurn * kTurn / 2)}, normal, kOffset}));  // at the foot
}

TEST(SlidingSurfaces, AreNoneBeforeABodyHasMoved) {
  const auto scene = card();
  EXPECT_FALSE(after(scene, {}).at(0, {{0.3f, 0.4f, 0}, {0, 0, 1}, kOffset}));
}

}  // namespace
}  // namespace saccade
