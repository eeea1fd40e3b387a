// SIGTERM under load.
#include <gtest/gtest.h>

#include <csignal>
#include <deque>

#include "mock/mock_http.h"
#include "mock/needs_libzmq.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kNotReady{500};
constexpr double kDrainSeconds = 5;
constexpr int kStreams = 4;  // of each delivery

TEST(Drain, EndsAllStreamsInTimeAndLetsNobodyIn) {
  NEEDS_PATCHED_LIBZMQ();
  ServerProcess server({"--drain-time", std::to_string(kDrainSeconds)});
  MockClient client(server.control());
  std::vector<v1::StreamOpened> streams;
  std::deque<MockSubscriber> subscribers;
  std::deque<Packets> packets;
  for (const auto delivery : {v1::DELIVERY_LOSSLESS, v1::DELIVERY_LIVE, v1::DELIVERY_BROADCAST}) {
    for (int i = 0; i < kStreams; ++i) {
      v1::OpenStream request = tinyRequest();
      request.mutable_timing()->set_duration_s(0);
      request.set_delivery(delivery);
      streams.push_back(client.open(request));
      if (delivery == v1::DELIVERY_BROADCAST) {
        subscribers.emplace_back(server.broadcast(), streams.back());
      } else {
        subscribers.emplace_back(server.data());
        subscribers.back().attach(streams.back());
        subscribers.back().giveCredit(std::uint64_t{1} << 30);
      }
    }
  }
  for (auto& subscriber : subscribers) {
    const auto first = subscriber.receive();
    ASSERT_TRUE(first);
    packets.push_back({*first});
  }

  const auto began = std::chrono::steady_clock::now();
  server.process().signal(SIGTERM);
  // 0: nobody answers any more.
  EXPECT_TRUE(waitUntil([&] { return httpGet(server.http(), "/readyz").status != 200; }, kNotReady));
  for (std::size_t i = 0; i < subscribers.size(); ++i) {
    auto rest = subscribers[i].receiveAll(1)[0];  // throws unless END comes
    packets[i].insert(packets[i].end(), rest.begin(), rest.end());
    const Summary summary = checkPackets(packets[i]);
    const v1::PacketHeader& end = packets[i].back().header;
    EXPECT_EQ(end.first_event_index(), summary.events);  // where to go on
    EXPECT_EQ(end.t0_ns(), summary.end_ns);
    EXPECT_EQ(end.seq(), summary.packets);
  }
  EXPECT_EQ(server.process().finish(), 0);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  EXPECT_LT(took.count(), kDrainSeconds);
  RecordProperty("seconds", std::to_string(took.count()));
}

// One of them takes nothing: the server waits for it as long as it was told to, says that it is not ready,
// and goes.
TEST(Drain, DoesNotWaitForEver) {
  ServerProcess server({"--drain-time", "1"});
  MockClient client(server.control());
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  const auto stream = client.open(request);
  MockSubscriber subscriber(server.data());
  subscriber.attach(stream);
  subscriber.giveCredit(1);
  ASSERT_TRUE(subscriber.receive());
  server.process().signal(SIGTERM);
  EXPECT_TRUE(waitUntil([&] { return httpGet(server.http(), "/readyz").status == 503; }, kNotReady));
  EXPECT_NE(server.process().lineWith("stopped before all streams were done"), "");
  EXPECT_EQ(server.process().finish(), 0);
}

// A stream that would take minutes to open is not waited for before the others have their END.
TEST(Drain, EndsStreamsWhileAnotherIsBeingOpened) {
  ServerProcess server(
      {"--drain-time", std::to_string(kDrainSeconds), "--limit-rays", "1e12", "--limit-pixel-rays", "1e6"});
  MockClient client(server.control()), other(server.control());
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_speed(0.02);
  const auto stream = client.open(request);
  MockSubscriber subscriber(server.data());
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  request.mutable_timing()->set_clock(v1::CLOCK_FAST);
  request.mutable_timing()->set_speed(0);
  request.mutable_view()->set_width(640);
  request.mutable_view()->set_height(480);
  request.mutable_method()->set_name("pt");
  request.mutable_method()->set_spp(1 << 16);
  other.setPatience(std::chrono::milliseconds(100));
  EXPECT_THROW(other.tryOpen(request), std::runtime_error);  // it takes longer
  ASSERT_TRUE(subscriber.receive());
  server.process().signal(SIGTERM);
  const Packets packets = subscriber.receiveAll(1)[0];
  EXPECT_EQ(packets.back().header.end_reason(), v1::END_REASON_DRAINING);
  EXPECT_EQ(server.process().finish(), 0);
}

}  // namespace
}  // namespace saccade
