// The method of a request that names none.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "mock/test_server.h"

namespace saccade {
namespace {

// A folder with one scene, whose lamp falls to a fifth.
class LampScene {
 public:
  LampScene() {
    std::filesystem::create_directories(folder_ / "lamp");
    std::filesystem::copy_file(SACCADE_SOURCE_DIR "/tests/stability/scenes/switched_lamp.xml",
                               folder_ / "lamp/scene.xml");
  }
  ~LampScene() { std::filesystem::remove_all(folder_); }
  std::string folder() const { return folder_.string(); }

 private:
  const std::filesystem::path folder_ = testing::TempDir() + "lamp_scene_" + std::to_string(getpid());
};

v1::OpenStream lampRequest() {
  v1::OpenStream request = tinyRequest();
  request.set_scene("lamp");
  request.mutable_trajectory()->mutable_motion()->set_kind(v1::MOTION_KIND_TRUCK);
  request.mutable_trajectory()->mutable_motion()->set_speed(0.1);
  return request;
}

v1::OpenStream resolvedBy(TestServer& server, const v1::OpenStream& request) {
  return server.client().open(request).resolved();
}

TEST(DefaultMethod, KeepsSteadyLight) {
  TestServer server;
  EXPECT_EQ(resolvedBy(server, tinyRequest()).method().name(), "irradiance_cache");
}

TEST(DefaultMethod, FollowsThePictureWhereLightChanges) {
  const LampScene scene;
  TestServer server(1, scene.folder());
  v1::OpenStream request = lampRequest();
  request.add_further_views()->CopyFrom(request.view());
  const v1::OpenStream resolved = resolvedBy(server, request);
  EXPECT_EQ(resolved.method().name(), "event_svgf");
  EXPECT_EQ(resolved.method().params().count("alpha"), 1u);
  EXPECT_EQ(resolved.method().params().count("cell_px"), 0u);
  EXPECT_EQ(resolvedBy(server, resolved).DebugString(), resolved.DebugString());
}

TEST(DefaultMethod, IsForRequestsThatLeaveItOpen) {
  const LampScene scene;
  TestServer server(1, scene.folder());
  v1::OpenStream named = lampRequest(), with_params = lampRequest(), odd = lampRequest();
  named.mutable_method()->set_name("irradiance_cache");
  EXPECT_EQ(resolvedBy(server, named).method().name(), "irradiance_cache");
  (*with_params.mutable_method()->mutable_params())["tau"] = 2;
  EXPECT_EQ(resolvedBy(server, with_params).method().name(), "irradiance_cache");
  odd.mutable_method()->set_spp(3);
  EXPECT_EQ(server.client().tryOpen(odd).field(), "method.spp");
}

}  // namespace
}  // namespace saccade
