#include "eval/bench/moving_objects.h"

#include <gtest/gtest.h>

#include <numbers>

#include "eval/bench/open_scene.h"
#include "scene/scratch.h"

namespace saccade::eval {
namespace {

using namespace std::chrono_literals;

using Names = std::vector<std::string>;

std::shared_ptr<const RenderScene> turntable(const Names& objects) {
  return openMovingScene("cornell-turntable", parseObjects(objects));
}

Names moving(const Names& objects) {
  Names names;
  const auto scene = turntable(objects);
  for (const Body& body : scene->description().bodies) names.push_back(body.name);
  return names;
}

// By which the turntable, the last of the bodies, has turned after 0.1 s, degrees.
double turn(const Names& objects) {
  const Trajectory path = openPaths(turntable(objects)->description(), parseObjects(objects), 100).back();
  return rotationVector((inverse(path.at(0ms)) * path.at(100ms)).rotation).y * 180 / std::numbers::pi;
}

TEST(MovingObjects, AreThoseOfTheSceneAndTheGivenOnes) {
  EXPECT_EQ(moving({}), (Names{"ball", "turntable"}));
  EXPECT_EQ(moving({"light=slide:0.3"}), (Names{"ball", "light", "turntable"}));
  EXPECT_EQ(moving({"turntable=still"}), (Names{"ball"}));
  EXPECT_EQ(moving({"turntable=still", "ball=still", "light=still"}), Names{});
  EXPECT_TRUE(openScene("cornell-turntable")->description().bodies.empty());
}

// motion.toml says spin:60.
TEST(MovingObjects, TheGivenPathComesFirst) {
  EXPECT_NEAR(turn({}), 6, 1e-6);
  EXPECT_NEAR(turn({"turntable=spin:-90"}), -9, 1e-6);
  EXPECT_NEAR(turn({"turntable=spin:0.3/frame"}), 3, 1e-6);
}

TEST(MovingObjects, FaultsNameWhatIsValid) {
  expectContains(errorOf([] { moving({"lamp=still"}); }),
                 "the scene has no object 'lamp'; it has: back_wall, ball, ");
  expectContains(errorOf([] { parseObjects({"ball=spin:1", "ball=still"}); }), "'ball' is given twice");
  expectContains(errorOf([] { turn({"turntable=stop"}); }),
                 "--object turntable: 'stop' is no path of an object; give KIND:SPEED, with KIND one of "
                 "spin, orbit, slide, swing, a .csv or .txt file, or still");
}

}  // namespace
}  // namespace saccade::eval
