// The output of `saccade record` when its server is lost in the middle and comes back: the same, byte by
// byte.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "client/scratch_folder.h"
#include "mock/server_process.h"
#include "mock/wait_until.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

// At most, of a CSV file. The header is written before any events come.
constexpr std::uintmax_t kHeaderBytes = 4096;

class LostServer : public testing::Test {
 protected:
  Process record(const std::string& file, const std::vector<std::string>& more) const {
    std::vector<std::string> words{SACCADE_COMMAND, "record",     "cornell-box",   "--trajectory",
                                   "right",         "--size",     "32x24",         "--threshold",
                                   "0.05",          "--duration", "0.6",           "--rate",
                                   "500",           "-o",         folder_.at(file)};
    words.insert(words.end(), {"--control", control_});
    words.insert(words.end(), more.begin(), more.end());
    return Process(words);
  }

  // Once `file` has events, the server gets `signal` and another takes its place.
  void replaceServer(const std::string& file, int signal) {
    const std::string partial = folder_.at(file + ".partial");
    const auto begun = [&] { return fs::exists(partial) && fs::file_size(partial) > kHeaderBytes; };
    ASSERT_TRUE(waitUntil(begun, kPatience));
    server_->process().signal(signal);
    server_->process().finish();
    server_.emplace(std::vector<std::string>{"--control", control_, "--data", data_});
  }

  std::string textOf(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(folder_.at(file)).rdbuf();
    return text.str();
  }

  const ScratchFolder folder_;
  std::optional<ServerProcess> server_{std::in_place};
  const std::string control_ = server_->control(), data_ = server_->data();
};

TEST_F(LostServer, KilledTheRecordingIsWhatItWouldHaveBeen) {
  const std::vector<std::string> two{"--threshold", "0.1", "--codec", "zstd"};
  EXPECT_EQ(record("whole.csv", two).finish(), 0);
  Process disturbed = record("a.csv", two);
  replaceServer("a-0.csv", SIGKILL);
  const std::string output = disturbed.rest();
  EXPECT_EQ(disturbed.finish(), 0) << output;
  EXPECT_NE(output.find("the server has restarted"), std::string::npos) << output;
  EXPECT_EQ(output.find("lost on the way"), std::string::npos) << output;
  for (const std::string sensor : {"-0.csv", "-1.csv"}) {
    EXPECT_GT(textOf("whole" + sensor).size(), 10000u);
    EXPECT_TRUE(textOf("a" + sensor) == textOf("whole" + sensor)) << sensor;
  }
}

TEST_F(LostServer, DrainedTheRecordingIsWhatItWouldHaveBeen) {
  EXPECT_EQ(record("whole.csv", {}).finish(), 0);
  Process disturbed = record("a.csv", {});
  replaceServer("a.csv", SIGTERM);
  const std::string output = disturbed.rest();
  EXPECT_EQ(disturbed.finish(), 0) << output;
  EXPECT_NE(output.find("the server has restarted"), std::string::npos) << output;
  EXPECT_NE(output.find("the server has stopped"), std::string::npos) << output;
  EXPECT_NE(output.find("trying again for 60 s"), std::string::npos) << output;
  EXPECT_TRUE(textOf("a.csv") == textOf("whole.csv"));
}

TEST_F(LostServer, ARecordingWaitsForAServerThatIsNotUpYet) {
  EXPECT_EQ(record("whole.csv", {}).finish(), 0);
  server_.reset();
  Process early = record("a.csv", {});
  const std::string line = early.lineWith("trying again for 60 s");
  EXPECT_NE(line.find("no saccaded answers at " + control_), std::string::npos) << line;
  server_.emplace(std::vector<std::string>{"--control", control_, "--data", data_});
  const std::string output = early.rest();
  EXPECT_EQ(early.finish(), 0) << output;
  EXPECT_TRUE(textOf("a.csv") == textOf("whole.csv"));
}

// Its first frame takes long, so that the server stops before it has opened the stream.
TEST_F(LostServer, ARecordingIsOpenedAgainAtAServerThatRestartsMeanwhile) {
  Process disturbed({SACCADE_COMMAND, "record", "cornell-box", "--trajectory", "right", "--size", "24x16",
                     "--method", "pt", "--spp", "2048", "--rate", "500", "--duration", "0.004", "--control",
                     control_, "-o", folder_.at("a.csv")});
  MockClient watcher(control_);
  ASSERT_TRUE(waitUntil([&] { return watcher.streams().opening_size() > 0; }, kPatience));
  server_->process().signal(SIGTERM);
  server_->process().finish();
  server_.emplace(std::vector<std::string>{"--control", control_, "--data", data_});
  const std::string output = disturbed.rest();
  EXPECT_EQ(disturbed.finish(), 0) << output;
  // The server's last answer may come, or get lost with it. The next server knows of no such request.
  EXPECT_NE(output.find("trying again for 60 s"), std::string::npos) << output;
}

TEST_F(LostServer, WithoutTimeToRetryAServerThatIsNotUpIsToldAtOnce) {
  server_.reset();
  Process early = record("a.csv", {"--retry-time", "0"});
  const std::string output = early.rest();
  EXPECT_EQ(early.finish(), 1);
  EXPECT_NE(output.find("no saccaded answers at " + control_), std::string::npos) << output;
  EXPECT_EQ(output.find("trying again"), std::string::npos) << output;
}

}  // namespace
}  // namespace saccade::client
