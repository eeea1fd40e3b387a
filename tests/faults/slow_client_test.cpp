// One of five clients of a live stream stands still: it alone loses something, and is told how much.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <deque>
#include <thread>
#include <utility>

#include "mock/remote_subscriber.h"
#include "mock/server_process.h"
#include "mock/wait_until.h"
#include "stream/session.h"

namespace saccade {
namespace {

using Clock = std::chrono::steady_clock;

const bool kFull = std::getenv("SACCADE_FULL") != nullptr;
const double kStreamSeconds = kFull ? 90 : 3;  // of which the client stands still for the middle third
const auto kThird = std::chrono::milliseconds(std::llround(kStreamSeconds * 1000 / 3));
constexpr int kOthers = 4;
constexpr double kLatencyRatio = 1.5, kTickSeconds = 0.05;  // p99; asked of a free machine alone
constexpr std::int64_t kSlackBytes = 8 << 20;               // what the heap does not give back
constexpr std::uint64_t kCredit = 256 << 10, kEventBytes = 9;

// Of one feed with any other threshold. The packets of the clients that keep up fit the server's queue as a
// whole. However slow the machine is, none of theirs is dropped for its sake.
constexpr double kMany = 0.02, kFew = 2;

v1::OpenStream liveRequest(double threshold) {
  v1::OpenStream request;
  request.set_scene("cornell-box");
  request.mutable_view()->set_width(48);
  request.mutable_view()->set_height(36);
  request.mutable_trajectory()->set_name("right");
  request.mutable_timing()->set_frame_rate_hz(100);
  request.mutable_timing()->set_duration_s(kStreamSeconds);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_method()->set_name("pt");  // noise: many events
  request.mutable_quality()->set_bounces(0);
  request.set_delivery(v1::DELIVERY_LIVE);
  request.add_sensors()->set_threshold(threshold);
  return request;
}

// A client that keeps up, and when each packet came.
struct Prompt {
  Packets packets;
  std::vector<Clock::time_point> arrivals;

  void run(MockSubscriber& subscriber) {
    while (packets.empty() || packets.back().header.kind() != v1::KIND_END) {
      auto packet = subscriber.receive();
      if (!packet) return;
      arrivals.push_back(Clock::now());
      subscriber.giveCredit(packet->bytes);
      subscriber.acknowledge(0, packet->header.seq());
      packets.push_back(std::move(*packet));
    }
  }

  // How late the packets of [from_s, to_s) of stream time came, at most, but for the latest hundredth;
  // against the promptest of all.
  double latencyP99(double from_s, double to_s) const {
    std::vector<double> lateness;
    double promptest = 1e9;
    for (std::size_t i = 0; i < packets.size(); ++i) {
      const double t = static_cast<double>(packets[i].header.t1_ns()) * 1e-9;
      const double late = std::chrono::duration<double>(arrivals[i] - arrivals[0]).count() - t;
      promptest = std::min(promptest, late);
      if (t >= from_s && t < to_s) lateness.push_back(late);
    }
    std::sort(lateness.begin(), lateness.end());
    return lateness.at(lateness.size() * 99 / 100) - promptest;
  }
};

class SlowClient : public testing::Test {
 protected:
  SlowClient() {
    for (int i = 0; i < kOthers; ++i) {
      streams_.push_back(client_.open(liveRequest(kFew)));
      subscribers_.emplace_back(server_.data());
      subscribers_[i].attach(streams_[i]);
      subscribers_[i].giveCredit(kQueueBytes);
    }
  }
  void receiveAll() {
    for (int i = 0; i < kOthers; ++i) threads_.emplace_back([this, i] { others_[i].run(subscribers_[i]); });
  }

  RemoteSubscriber stopped_;  // before the test has any other thread
  ServerProcess server_;
  MockClient client_{server_.control()};
  std::vector<v1::StreamOpened> streams_;
  std::deque<MockSubscriber> subscribers_;
  Prompt others_[kOthers];
  std::vector<std::jthread> threads_;
};

TEST_F(SlowClient, AloneLosesPacketsAndCanCountThem) {
  const auto slow = client_.open(liveRequest(kMany));
  stopped_.attach(server_.data(), slow, kCredit, RemoteSubscriber::Refill::kYes);
  receiveAll();
  const auto framesDone = [&] {
    return static_cast<double>(client_.info(slow.stream_id()).frames_done()) / 100;
  };
  // In full there is a beginning for the latency to be compared with.
  ASSERT_TRUE(waitUntil([&] { return !kFull || framesDone() >= kStreamSeconds / 3; }, kPatience + kThird));
  const std::int64_t before = server_.usage().resident_bytes;
  stopped_.signal(SIGSTOP);
  ASSERT_TRUE(waitUntil([&] { return framesDone() >= kStreamSeconds * 2 / 3; }, kPatience + kThird));
  const std::int64_t grown = server_.usage().resident_bytes - before;
  stopped_.signal(SIGCONT);
  const Summary summary = stopped_.summary();
  threads_.clear();

  // Packets that wait for it, and those that it has not acknowledged, with as much on the way as its credit.
  RecordProperty("resident_growth_bytes", std::to_string(grown));
  EXPECT_LT(grown, static_cast<std::int64_t>((1 + kKeptBounds) * kQueueBytes + kCredit) + kSlackBytes);
  const v1::StreamInfo info = client_.info(slow.stream_id());
  EXPECT_GT(summary.dropped, 0u);
  EXPECT_EQ(summary.dropped, info.dropped_packets());
  EXPECT_LT(summary.events, info.events());
  for (int i = 0; i < kOthers; ++i) {
    const Summary whole = checkPackets(others_[i].packets, false,
                                       others_[i].packets[0].header.t0_ns());  // a gap would be a failure
    ASSERT_TRUE(kFull || whole.events * kEventBytes < kQueueBytes) << whole.events;
    EXPECT_EQ(whole.events, client_.info(streams_[i].stream_id()).events());
    const double third = kStreamSeconds / 3;
    const double before_s = others_[i].latencyP99(0, third),
                 during_s = others_[i].latencyP99(third, 2 * third);
    EXPECT_TRUE(!kFull || during_s < kLatencyRatio * before_s + kTickSeconds)
        << before_s << " s, then " << during_s;
  }
}

// A client of a dataset stands still: its stream is held, and nothing else happens.
TEST(StoppedDataset, IsHeldInBoundsAndThenGoesOnWithoutLoss) {
  RemoteSubscriber stopped;
  ServerProcess server;
  MockClient client(server.control());
  v1::OpenStream request = liveRequest(kMany);
  request.set_delivery(v1::DELIVERY_LOSSLESS);
  request.mutable_timing()->set_clock(v1::CLOCK_FAST);
  const auto stream = client.open(request);
  stopped.attach(server.data(), stream, kCredit, RemoteSubscriber::Refill::kYes);
  stopped.signal(SIGSTOP);
  const auto info = [&] { return client.info(stream.stream_id()); };
  const std::int64_t before = server.usage().resident_bytes;
  std::uint64_t frames = 0;
  const auto held = [&] {
    return std::exchange(frames, info().frames_done()) == info().frames_done() && frames > 0;
  };
  const auto heldForAWhile = [&] {
    for (int i = 0; i < 20; ++i) {
      if (!held()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  };
  ASSERT_TRUE(waitUntil(heldForAWhile, kPatience));
  EXPECT_LT(frames, stream.frames());
  EXPECT_LT(server.usage().resident_bytes - before,
            static_cast<std::int64_t>((1 + kKeptBounds) * kQueueBytes + kCredit) + kSlackBytes);
  stopped.signal(SIGCONT);
  const Summary summary = stopped.summary();
  EXPECT_EQ(summary.dropped, 0u);
  EXPECT_EQ(summary.events, info().events());
}

// Its machine still answers for it: only ZeroMQ's own heartbeats tell that it is not there.
TEST(StoppedDataset, IsForgottenWhereItDoesNotGoOnWithinItsLease) {
  RemoteSubscriber stopped;
  ServerProcess server({"--lease", "1"});
  MockClient client(server.control());
  v1::OpenStream request = liveRequest(kMany);
  request.set_delivery(v1::DELIVERY_LOSSLESS);
  const auto stream = client.open(request);
  stopped.attach(server.data(), stream, kCredit, RemoteSubscriber::Refill::kYes);
  stopped.signal(SIGSTOP);
  // 8 s until they do, two leases, and what a busy machine adds.
  EXPECT_TRUE(waitUntil([&] { return client.info(stream.stream_id()).stream_id().empty(); }, kPatience));
}

}  // namespace
}  // namespace saccade
