// A scene that cannot be loaded is the matter of its client alone.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mock/test_server.h"

namespace saccade {
namespace {

class BrokenScene : public testing::Test {
 protected:
  ~BrokenScene() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& scene, const std::string& text) {
    std::filesystem::create_directories(folder_ / scene);
    std::ofstream(folder_ / scene / "scene.xml") << text;
  }
  void expectUnavailable(TestServer& server, const std::string& scene, const std::string& why) {
    v1::OpenStream request = tinyRequest();
    request.set_scene(scene);
    const v1::Status status = server.client().tryOpen(request);
    EXPECT_EQ(status.code(), v1::CODE_UNAVAILABLE);
    EXPECT_EQ(status.field(), "scene");
    EXPECT_NE(status.message().find(why), std::string::npos) << status.message();
  }

  const std::filesystem::path folder_ = testing::TempDir() + "broken_scenes_" + std::to_string(getpid());
};

TEST_F(BrokenScene, IsToldAndDoesNotStopTheServer) {
  write("broken", "<scene version=\"3.0.0\">\n<shape type=\"teapot\"/>\n</scene>\n");
  TestServer server(1, folder_.string());
  for (int attempt = 0; attempt < 2; ++attempt)  // the failure is not remembered as a scene
    expectUnavailable(server, "broken", "scene.xml");
  EXPECT_EQ(server.client().server().protocol_version(), 1u);
}

// PendingOpen a FIFO to read it waits for a writer.
TEST_F(BrokenScene, WithAFifoIsListedAndRefusedAtOnce) {
  write("mesh",
        "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='40'/></sensor>\n"
        "<shape type='obj'><string name='filename' value='a.obj'/></shape></scene>");
  write("no utf-8: \xFF", "<scene/>");
  std::filesystem::create_directories(folder_ / "fifo");
  for (const char* name : {"mesh/a.obj", "fifo/scene.xml", "mesh/README.md"})
    ASSERT_EQ(mkfifo((folder_ / name).c_str(), 0600), 0) << name;
  TestServer server(1, folder_.string());
  v1::Request list;
  list.mutable_list_scenes();
  const v1::SceneList scenes = server.client().call(list).list_scenes();
  ASSERT_EQ(scenes.scenes_size(), 3);
  EXPECT_NE(scenes.scenes(0).unavailable().find("fifo/scene.xml: cannot be read"), std::string::npos);
  EXPECT_NE(scenes.scenes(2).unavailable().find("is not UTF-8"), std::string::npos);
  expectUnavailable(server, "fifo", "scene.xml: cannot be read: is not a plain file");
  expectUnavailable(server, "mesh", "a.obj: cannot be read: is not a plain file");
}

}  // namespace
}  // namespace saccade
