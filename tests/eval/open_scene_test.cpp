#include "eval/bench/open_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "scene/scratch.h"

namespace saccade::eval {
namespace {

using namespace std::chrono_literals;

TEST(OpenTrajectory, TakesAMotionByNameOrWithItsSpeed) {
  const auto scene = openScene("cornell-box");
  const Pose start = scene->description().T_world_camera;
  const auto moved = [&](const std::string& text) {
    return inverse(start) * openTrajectory("cornell-box", text, *scene, {}).at(100ms);
  };
  EXPECT_NEAR(moved("dolly:0.2").position.z, 0.02, 1e-9);
  EXPECT_NEAR(rotationVector(moved("pan:-15").rotation).y, -1.5 * 3.14159265358979 / 180, 1e-9);
  EXPECT_GT(moved("right").position.x, 0);
  EXPECT_NE(moved("arc"), Pose{});  // one of the scene's own
}

// A pan of 2 px a frame. Near the centre of the view, an angle of a moves the image by a focal lengths.
TEST(OpenTrajectory, TakesPixelsPerFrame) {
  const auto scene = openScene("cornell-box");
  const FeedConfig feed{.camera = pinhole(60, 200, 256), .frame_rate_hz = 100, .params = {}};
  const Trajectory path = openTrajectory("cornell-box", "pan:2px", *scene, feed);
  const double focal_px = 100 / std::tan(30 * std::numbers::pi / 180);
  const double angle = rotationVector((inverse(path.at(0ms)) * path.at(10ms)).rotation).y;
  EXPECT_NEAR(angle * focal_px, 2, 0.4);
}

TEST(OpenTrajectory, ListsAllThatItTakes) {
  const auto scene = openScene("cornell-box");
  EXPECT_THROW(openTrajectory("cornell-box", "fly:1", *scene, {}), SceneError);
  try {
    openTrajectory("cornell-box", "fly", *scene, {});
    FAIL();
  } catch (const SceneError& fault) {
    for (const std::string word :
         {"'fly'", "arc", "slide", "right", "still", "dolly", "KIND:SPEEDpx", ".csv"})
      EXPECT_NE(std::string(fault.what()).find(word), std::string::npos) << word << ": " << fault.what();
  }
}

// Runs in a folder of its own, so that the name of a folder leads nowhere else.
struct OpenScene : testing::Test {
  OpenScene() {
    files.write("objroom/scene.xml",
                "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='40'/></sensor>"
                "<shape type='obj'><string name='filename' value='a.obj'/></shape></scene>");
    files.write("objroom/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl brown\nf 1 2 3\n");
    std::filesystem::current_path(files.path(""));
  }
  ~OpenScene() override { std::filesystem::current_path(before); }
  const std::filesystem::path before = std::filesystem::current_path();
  const Scratch files;
};

TEST_F(OpenScene, AFolderWithoutASlashIsToldHowToBeNamed) {
  const std::string error = errorOf([] { openScene("objroom"); });
  expectContains(error, "no scene is named 'objroom'; there are: ");
  expectContains(error, "the folder here is ./objroom");
  EXPECT_EQ(errorOf([] { openScene("absent"); }).find("./absent"), std::string::npos);
}

TEST_F(OpenScene, WarnsOfWhatThePictureLacks) {
  testing::internal::CaptureStderr();
  openScene("./objroom");
  const std::string told = testing::internal::GetCapturedStderr();
  expectContains(told, "warning: ./objroom: ");
  expectContains(told, "a.obj: its materials (usemtl) are not read");
  expectContains(told, "the scene has no light");
}

TEST(SceneName, IsTheServersNameOfAScene) {
  EXPECT_EQ(sceneName("cornell-box"), "cornell-box");
  EXPECT_EQ(sceneName("mine/room/scene.xml"), "room");
  EXPECT_EQ(sceneName("mine/room"), "room");
  EXPECT_EQ(sceneName("mine/room/"), "room");
  EXPECT_EQ(sceneName("mine/room/dark.xml"), "dark");
}

TEST(RequireTableNames, RefusesTwoScenesOfOneName) {
  EXPECT_NO_THROW(requireTableNames({"room", "mine/hall/scene.xml"}));
  EXPECT_THROW(requireTableNames({"room", "mine/room/scene.xml"}), std::runtime_error);
  EXPECT_THROW(requireTableNames({"mine/a,b/scene.xml"}), std::runtime_error);
}

}  // namespace
}  // namespace saccade::eval
