// The files of a scene change under a running server.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mock/test_server.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

class SceneChange : public testing::Test {
 protected:
  SceneChange() { fs::copy(SACCADE_SOURCE_DIR "/scenes/cornell-box", scene_, fs::copy_options::recursive); }
  ~SceneChange() override { fs::remove_all(folder_); }

  // As an editor saves: at another time.
  void write(const std::string& text) const {
    const auto before = fs::last_write_time(file_);
    std::ofstream(file_) << text;
    fs::last_write_time(file_, before + std::chrono::seconds(1));
  }
  // A stream that is in its middle while `change` happens, and all its packets.
  Packets runThrough(const std::function<void()>& change) {
    v1::OpenStream request = tinyRequest();
    request.mutable_timing()->set_duration_s(0.2);
    const auto stream = server_->client().open(request);
    MockSubscriber subscriber = server_->dataSubscriber();
    subscriber.attach(stream);
    subscriber.giveCredit(1);
    Packets packets{subscriber.receive().value()};
    change();
    subscriber.giveCredit(1 << 20);
    const auto rest = subscriber.receiveAll(1)[0];
    packets.insert(packets.end(), rest.begin(), rest.end());
    checkPackets(packets);
    return packets;
  }

  const fs::path folder_ = testing::TempDir() + "scene_change_test_" + std::to_string(getpid());
  const fs::path scene_ = (fs::create_directories(folder_), folder_ / "cornell-box"),
                 file_ = scene_ / "scene.xml";
  std::unique_ptr<TestServer> server_ = std::make_unique<TestServer>(1, folder_.string());
};

TEST_F(SceneChange, OfABrokenFileIsTheMatterOfTheNextStream) {
  std::ifstream good(file_);
  const std::string text{std::istreambuf_iterator<char>(good), {}};
  const Packets undisturbed = runThrough([] {});
  const Packets disturbed = runThrough([&] {
    write(text.substr(0, text.size() / 2));
    const v1::Status status = server_->client().tryOpen(tinyRequest());
    EXPECT_EQ(status.code(), v1::CODE_UNAVAILABLE);
    EXPECT_NE(status.message().find("scene.xml:"), std::string::npos) << status.message();
  });
  EXPECT_TRUE(comparableBytes(disturbed) == comparableBytes(undisturbed));
  write(text);
  EXPECT_EQ(server_->client().tryOpen(tinyRequest()).code(), v1::CODE_OK);
}

TEST_F(SceneChange, ARemovedSceneIsNotFoundAnyMore) {
  const Packets undisturbed = runThrough([] {});
  const Packets disturbed = runThrough([&] {
    fs::remove_all(scene_);
    const v1::Status status = server_->client().tryOpen(tinyRequest());
    EXPECT_EQ(status.code(), v1::CODE_NOT_FOUND);
    EXPECT_EQ(status.field(), "scene");
    EXPECT_NE(status.message().find("there are: none"), std::string::npos) << status.message();
  });
  EXPECT_TRUE(comparableBytes(disturbed) == comparableBytes(undisturbed));
}

TEST_F(SceneChange, IsSeenByTheNextStream) {
  std::ifstream file(file_);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const double before = server_->client().open(tinyRequest()).luminance_p50();
  write(text.insert(text.rfind("</scene>"),
                    "<emitter type=\"constant\"><rgb name=\"radiance\" value=\"1\"/></emitter>"));
  EXPECT_GT(server_->client().open(tinyRequest()).luminance_p50(), 1.1 * before);
}

}  // namespace
}  // namespace saccade
