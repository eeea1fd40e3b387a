#include "eval/bench/open_scene.h"

#include <gtest/gtest.h>

#include "scene/files/scene_error.h"

namespace saccade::eval {
namespace {

using namespace std::chrono_literals;

TEST(OpenTrajectory, TakesAMotionByNameOrWithItsSpeed) {
  const auto scene = openScene("cornell-box");
  const Pose start = scene->description().T_world_camera;
  const auto moved = [&](const std::string& text) {
    return inverse(start) * openTrajectory("cornell-box", text, *scene).at(100ms);
  };
  EXPECT_NEAR(moved("dolly:0.2").position.z, 0.02, 1e-9);
  EXPECT_NEAR(rotationVector(moved("pan:-15").rotation).y, -1.5 * 3.14159265358979 / 180, 1e-9);
  EXPECT_GT(moved("right").position.x, 0);
  EXPECT_NE(moved("arc"), Pose{});  // one of the scene's own
}

TEST(OpenTrajectory, RefusesWhatItDoesNotKnow) {
  const auto scene = openScene("cornell-box");
  EXPECT_THROW(openTrajectory("cornell-box", "fly:1", *scene), SceneError);
  EXPECT_THROW(openTrajectory("cornell-box", "fly", *scene), SceneError);
}

}  // namespace
}  // namespace saccade::eval
