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
const int kRounds = kFull ? 3 : 2;
const int kClients = kFull ? 60 : 12;              // killed in each round
constexpr std::chrono::seconds kNoticed{5};        // that the connection is gone
constexpr std::int64_t kMaxGrowthBytes = 4 << 20;  // from round to round
// In full the server finds out by itself: a stream keeps its place for 30 s after its client was last there,
// and for 30 s more once it has been ended.
constexpr std::chrono::seconds kForgotten{30 + 30 + 15};

class KilledClients : public testing::Test {
 protected:
  // One that is killed after its first packet.
  v1::StreamOpened openAndKill(RemoteSubscriber& remote) {
    v1::OpenStream request = tinyRequest();
    request.mutable_timing()->set_duration_s(0);
    request.mutable_timing()->set_clock(v1::CLOCK_PACED);  // none of them hurries to fill its queue
    request.mutable_timing()->set_frame_rate_hz(50);
    const auto stream = client_.open(request);
    remote.attach(server_.data(), stream, 64 << 10);
    remote.signal(SIGKILL);
    return stream;
  }
  int streams() {
    v1::Request request;
    request.mutable_list_streams();
    return client_.call(request).list_streams().streams_size();
  }
  // Whether nothing is left of the streams of a round.
  bool clean() {
    const Usage now = server_.usage();
    return now.threads <= before_.threads && now.fds <= before_.fds && (!kFull || streams() == 0);
  }

  std::deque<RemoteSubscriber> remotes_ = std::deque<RemoteSubscriber>(kRounds * kClients);
  ServerProcess server_;
  MockClient client_{server_.control()};
  Usage before_;
};

TEST_F(KilledClients, LeaveNothingBehind) {
  client_.close(client_.open(tinyRequest()));  // the scene is loaded
  before_ = server_.usage();
  std::int64_t resident = 0;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<v1::StreamOpened> streams;
    for (int i = 0; i < kClients; ++i) streams.push_back(openAndKill(remotes_[round * kClients + i]));
    ASSERT_GT(server_.usage().threads, before_.threads);
    EXPECT_TRUE(waitUntil([&] { return server_.usage().fds <= before_.fds; }, kNoticed));
    if (!kFull) {
      for (const auto& stream : streams) EXPECT_EQ(client_.close(stream).code(), v1::CODE_OK);
    }
    EXPECT_TRUE(waitUntil([&] { return clean(); }, kFull ? kForgotten : kNoticed));
    const std::int64_t now = server_.usage().resident_bytes;
    if (kFull && round > 0) {  // a stream keeps its memory as long as its place
      EXPECT_LT(now - resident, kMaxGrowthBytes);
    }
    resident = now;
  }
  EXPECT_EQ(client_.tryOpen(tinyRequest()).code(), v1::CODE_OK);
}

}  // namespace
}  // namespace saccade
