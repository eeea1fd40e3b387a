#include "render/world/sliding_surfaces.h"

#include <gtest/gtest.h>

#include "render/moving_room.h"

namespace saccade {
namespace {

using namespace test;

constexpr float kPixel = 0.01f;

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
  EXPECT_TRUE(turned.at(0, {{0.3f, 0.4f, 0}, up, kPixel}));
  const SlidingSurfaces slid = after(scene, {{0.1, 0, 0}, {}});
  EXPECT_TRUE(slid.at(0, {{0.3f, 0.4f, 0}, up, kPixel}));
  EXPECT_TRUE(slid.at(0, {{1.05f, 0, 0}, up, kPixel}));   // it has come here
  EXPECT_TRUE(slid.at(0, {{-0.85f, 0, 0}, up, kPixel}));  // the next step leaves it
}

TEST(SlidingSurfaces, AreNotThoseThatRiseOrTilt) {
  const auto scene = card();
  const SlidingSurfaces risen = after(scene, {{0.1, 0, 0.05}, {}});
  EXPECT_FALSE(risen.at(0, {{0.3f, 0.4f, 0.05f}, {0, 0, 1}, kPixel}));
  const SlidingSurfaces tilted = after(scene, {{}, axisAngle({0.1, 0, 0})});
  const Vec3 normal{0, -std::sin(0.1f), std::cos(0.1f)};
  EXPECT_FALSE(tilted.at(0, {{0.3f, 0, 0}, normal, kPixel}));
  EXPECT_FALSE(tilted.at(0, {{0.3f, 0.5f * std::cos(0.1f), 0.5f * std::sin(0.1f)}, normal, kPixel}));
}

TEST(SlidingSurfaces, AreNoneBeforeABodyHasMoved) {
  const auto scene = card();
  EXPECT_FALSE(after(scene, {}).at(0, {{0.3f, 0.4f, 0}, {0, 0, 1}, kPixel}));
}

}  // namespace
}  // namespace saccade
