// Subscribers of large pictures who stop reading, each at another one.
#include <gtest/gtest.h>

#include "mock/control_calls.h"
#include "mock/needs_libzmq.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"
#include "mock/zmtp_peer.h"
#include "stream/large_packets.h"

namespace saccade {
namespace {

constexpr double kMiB = 1 << 20, kPictureMiB = 5;
constexpr int kSide = 1145;  // 5 MiB of float32
constexpr int kSubscribers = 20;

v1::OpenStream pictures() {
  v1::OpenStream request;
  request.set_pushed(true);
  request.mutable_view()->set_width(kSide);
  request.mutable_view()->set_height(kSide);
  request.mutable_timing()->set_frame_rate_hz(100);
  request.add_sensors();
  request.add_truth()->set_name("intensity");
  request.set_delivery(v1::DELIVERY_BROADCAST);
  return request;
}

class SlowReceivers : public testing::Test {
 protected:
  void SetUp() override {
    NEEDS_PATCHED_LIBZMQ();
    stream_ = client_.open(pictures());
  }
  // Sends a frame, and waits until the feed has taken it.
  void push() {
    v1::Request push;
    forStream(*push.mutable_push_frame(), stream_)
        .set_intensity(std::string(sizeof(float) * kSide * kSide, '\0'));
    ASSERT_TRUE(waitUntil([&] { return client_.call(push).status().code() == v1::CODE_OK; }, kPatience));
    const std::uint64_t due = frames_++;
    ASSERT_TRUE(waitUntil([&] { return client_.info(stream_.stream_id()).frames_done() >= due; }, kPatience));
  }
  double residentMiB() const { return static_cast<double>(server_.usage().resident_bytes) / kMiB; }

  ServerProcess server_;
  MockClient client_{server_.control()};
  v1::StreamOpened stream_;
  std::uint64_t frames_ = 0;
};

TEST_F(SlowReceivers, TogetherHoldNoMoreThanTheStreamMayLend) {
  if (kSanitized) GTEST_SKIP() << "sanitizers keep what is freed";
  std::vector<ZmtpPeer> subscribers;
  const auto join = [&] {
    subscribers.emplace_back(server_.broadcast(), "SUB");
    for (const std::string& topic : stream_.topics()) subscribers.back().say(zmtp::part('\1' + topic));
  };
  join();
  for (int i = 0; i < 4; ++i) push();  // what a stream with one such subscriber takes
  const double before = residentMiB();
  double top = before;
  for (int i = 0; i < kSubscribers; ++i) {
    join();
    push();
    push();
    top = std::max(top, residentMiB());
  }
  constexpr int kOnTheWay = 4;  // a frame that is pushed: its message, and what is made of it
  EXPECT_LT(top - before, (kMostLargePackets + 2 + kOnTheWay) * kPictureMiB)
      << kSubscribers << " subscribers";
}

TEST(LargePictures, CountAsQueues) {
  NEEDS_PATCHED_LIBZMQ();
  Config config = testConfig();
  config.limits[Limit::kQueues] = 16 + (kMostLargePackets + 1) * kPictureMiB - 1;
  TestServer server(config);
  EXPECT_EQ(server.client().tryOpen(pictures()).limit(), "queues");
  v1::OpenStream smaller = pictures();
  smaller.mutable_view()->set_width(kSide / 2);
  EXPECT_EQ(server.client().tryOpen(smaller).code(), v1::CODE_OK);
}

}  // namespace
}  // namespace saccade
