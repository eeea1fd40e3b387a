// Clients that are killed in the middle of their streams leave nothing behind.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <deque>

#include "mock/remote_subscriber.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"

namespace saccade {
namespace {

const bool kFull = std::getenv("SACCADE_FULL") != nullptr;
constexpr int kRounds = 2;
const int kClients = kFull ? 100 : 12;              // killed in each round
constexpr const char* kLease = "0.5";               // seconds; ended after one, forgotten after another
constexpr std::chrono::seconds kForgotten{15};      // four seconds, where the machine is not busy
constexpr std::int64_t kMaxGrowthBytes = 16 << 20;  // a stream takes 2 MB

class KilledClients : public testing::Test {
 protected:
  // One that is killed after its first packet.
  void openAndKill(RemoteSubscriber& remote) {
    v1::OpenStream request = tinyRequest();
    request.mutable_timing()->set_duration_s(0);
    request.mutable_timing()->set_clock(v1::CLOCK_PACED);  // none of them hurries to fill its queue
    request.mutable_timing()->set_frame_rate_hz(50);
    const auto stream = client_.open(request);
    remote.attach(server_.data(), stream, 64 << 10);
    remote.signal(SIGKILL);
  }
  // Whether nothing is left of the streams of a round.
  bool clean() {
    const Usage now = server_.usage();
    const bool memory = kSanitized || now.resident_bytes < before_.resident_bytes + kMaxGrowthBytes;
    return memory && now.threads <= before_.threads && now.fds <= before_.fds &&
           client_.streams().streams_size() == 0;
  }

  std::deque<RemoteSubscriber> remotes_ = std::deque<RemoteSubscriber>(kRounds * kClients);
  ServerProcess server_{{"--lease", kLease}};
  MockClient client_{server_.control()};
  Usage before_;
};

TEST_F(KilledClients, LeaveNothingBehind) {
  client_.close(client_.open(tinyRequest()));  // the scene is loaded
  ASSERT_TRUE(waitUntil([&] { return client_.streams().streams_size() == 0; }, kForgotten));
  before_ = server_.usage();
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kClients; ++i) openAndKill(remotes_[round * kClients + i]);
    EXPECT_TRUE(waitUntil([&] { return clean(); }, kForgotten))
        << server_.usage().threads - before_.threads << " threads, " << server_.usage().fds - before_.fds
        << " descriptors and " << server_.usage().resident_bytes - before_.resident_bytes << " bytes more";
    const std::int64_t grown = server_.usage().resident_bytes - before_.resident_bytes;
    RecordProperty("resident_growth_bytes", std::to_string(grown));
  }
  EXPECT_EQ(client_.tryOpen(tinyRequest()).code(), v1::CODE_OK);
}

}  // namespace
}  // namespace saccade
