// A scene that cannot be loaded is the matter of its client alone.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mock/test_server.h"

namespace saccade {
namespace {

TEST(BrokenScene, IsToldAndDoesNotStopTheServer) {
  const std::filesystem::path folder = testing::TempDir() + "broken_scenes_" + std::to_string(getpid());
  std::filesystem::create_directories(folder / "broken");
  std::ofstream(folder / "broken/scene.xml")
      << "<scene version=\"3.0.0\">\n<shape type=\"teapot\"/>\n</scene>\n";
  TestServer server(1, folder.string());
  v1::OpenStream request = tinyRequest();
  request.set_scene("broken");
  for (int attempt = 0; attempt < 2; ++attempt) {  // the failure is not remembered as a scene
    const v1::Status status = server.client().tryOpen(request);
    EXPECT_EQ(status.code(), v1::CODE_UNAVAILABLE);
    EXPECT_EQ(status.field(), "scene");
    EXPECT_NE(status.message().find("scene.xml"), std::string::npos) << status.message();
  }
  EXPECT_EQ(server.client().server().protocol_version(), 1u);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace saccade
