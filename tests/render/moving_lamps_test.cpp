// Points, spots and suns that move, against scenes whose file has them there.
#include <gtest/gtest.h>

#include "render/moving_frames.h"
#include "render/moving_room.h"

namespace saccade {
namespace {

using namespace test;

// The room under one lamp without extent.
Scene roomUnder(const std::string& lamp) {
  Scene s = movingRoom();
  s.meshes[1].radiance = {};
  if (lamp == "point") s.point_lights = {{{-0.5f, -0.4f, 0}, {1, 1, 1}, lamp}};
  if (lamp == "spot")
    s.spot_lights = {{{0.5f, -0.5f, 0}, normalize(Vec3{0, 1, 0.5f}), {2, 2, 2}, 0.3f, 0.6f, lamp}};
  if (lamp == "sun") {
    s.meshes.erase(s.meshes.begin());  // the walls
    s.directional_lights = {{normalize(Vec3{0.2f, 0.3f, 1}), {1, 1, 1}, lamp}};
  }
  return s;
}

Scene withBody(Scene s, const std::string& name) {
  const std::string names[]{name};
  setBodies(s, names);
  return s;
}

// The lamps of this name placed by hand.
Scene movedInTheFile(Scene s, const std::string& name, const RigidMotion& motion) {
  for (PointLight& point : s.point_lights)
    if (point.name == name) point.position = motion.point(point.position);
  for (SpotLight& spot : s.spot_lights)
    if (spot.name == name)
      spot.position = motion.point(spot.position), spot.axis = motion.direction(spot.axis);
  for (DirectionalLight& sun : s.directional_lights)
    if (sun.name == name) sun.direction = motion.direction(sun.direction);
  return s;
}

TEST(MovingLamps, ShineAsIfTheFileHadThemThere) {
  for (const std::string name : {"point", "spot", "sun"}) {
    const Scene moving = withBody(roomUnder(name), name);
    const Body& body = moving.bodies[0];
    EXPECT_FALSE(body.has_shapes);
    // Both are bodies: of lamps that stand, a scene knows what blocks them, and takes other samples.
    const Scene by_hand = withBody(movedInTheFile(roomUnder(name), name, motionBy(body, kMoved)), name);
    const PosedScene posed(std::make_shared<RenderScene>(moving), {standing(body, kMoved)});
    const PosedScene there(std::make_shared<RenderScene>(by_hand), {standing(by_hand.bodies[0])});
    const PosedScene before(std::make_shared<RenderScene>(roomUnder(name)));
    const Frame a = render(posed, posed), b = render(there, there), c = render(before, before);
    EXPECT_LT(meanDifference(a.samples.I2, b.samples.I2), 1e-5) << name;
    EXPECT_GT(meanDifference(c.samples.I2, b.samples.I2), 5e-3) << name;
  }
}

// A lamp alone has no box that rays are tested against.
TEST(MovingLamps, MoveLightAndNoShape) {
  const Scene moving = withBody(roomUnder("spot"), "spot");
  const auto scene = std::make_shared<RenderScene>(moving);
  const PosedScene now(scene, {standing(moving.bodies[0], kMoved)}),
      then(scene, {standing(moving.bodies[0])});
  const MovedBodies moved(now, then), none(then, then);
  EXPECT_TRUE(moved.any() && moved.touchAllFrom(kNoBody));
  EXPECT_TRUE(moved.boxes().empty());
  EXPECT_FALSE(none.any() || none.touchAllFrom(kNoBody));
}

}  // namespace
}  // namespace saccade
