// Faults of networks on connections between a server and a client that attaches anew when its connection is
// lost.
#include <gtest/gtest.h>

#include "mock/fault_proxy.h"
#include "mock/resuming_subscriber.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr std::uint64_t kCredit = 64 << 10;

// About a megabyte, in packets of a few kilobytes.
v1::OpenStream noisyRequest(v1::Delivery delivery) {
  v1::OpenStream request = tinyRequest();
  request.set_delivery(delivery);
  request.mutable_view()->set_width(48);
  request.mutable_view()->set_height(36);
  request.mutable_quality()->set_bounces(0);
  request.mutable_method()->set_name("pt");
  request.mutable_timing()->set_duration_s(0.1);
  request.mutable_sensors(0)->set_threshold(0.1);
  return request;
}

class FlakyNetwork : public testing::Test {
 protected:
  // A packet that was under way when the connection was cut comes again on the next one.
  std::function<bool()> cutSince() {
    return [this] { return std::exchange(cuts_, proxy_.cuts()) != proxy_.cuts(); };
  }
  ResumingSubscriber attach(const v1::StreamOpened& stream) { return {proxy_.endpoint(), stream, kCredit}; }

  TestServer server_{2};
  FaultProxy proxy_{server_.client().server().data_endpoint()};
  int cuts_ = 0;
};

// The faults of a connection that a dataset has to survive, byte by byte.
class Dataset : public FlakyNetwork, public testing::WithParamInterface<Faults> {};

TEST_P(Dataset, ComesWholeAndUnchanged) {
  const auto request = noisyRequest(v1::DELIVERY_LOSSLESS);
  const std::string expected = comparableBytes(server_.run(request)[0]);
  ASSERT_GT(expected.size(), 4 * kCredit);
  proxy_.set(GetParam());
  const auto stream = server_.client().open(request);
  ResumingSubscriber subscriber = attach(stream);
  const Packets packets = subscriber.receiveAll(cutSince());
  checkPackets(packets);
  EXPECT_TRUE(comparableBytes(packets) == expected) << "not the bytes of an undisturbed stream";
  EXPECT_GT(subscriber.attached(), GetParam().cut == Faults::Cut::kNone ? 0 : 3);
  EXPECT_EQ(server_.client().info(stream.stream_id()).dropped_packets(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Reset, Dataset,
                         testing::Values(Faults{.cut = Faults::Cut::kReset, .cut_after = 100'000}));
INSTANTIATE_TEST_SUITE_P(Truncated, Dataset,
                         testing::Values(Faults{.cut = Faults::Cut::kTruncate, .cut_after = 100'000}));
INSTANTIATE_TEST_SUITE_P(HalfClosed, Dataset,
                         testing::Values(Faults{.cut = Faults::Cut::kHalfClose, .cut_after = 100'000}));
INSTANTIATE_TEST_SUITE_P(Slow, Dataset, testing::Values(Faults{.bytes_per_s = 1'000'000}));
INSTANTIATE_TEST_SUITE_P(Late, Dataset, testing::Values(Faults{.delay = std::chrono::milliseconds(20)}));

class Live : public FlakyNetwork {
 protected:
  // Its stream is over before the network is well again.
  v1::StreamOpened outlive(ResumingSubscriber& subscriber, Packets& packets, const v1::StreamOpened& stream,
                           const Faults& faults) {
    packets.push_back(subscriber.receive(cutSince()));
    proxy_.set(faults);
    while (server_.client().info(stream.stream_id()).frames_done() < stream.frames())
      std::this_thread::yield();
    proxy_.set({});
    const Packets rest = subscriber.receiveAll(cutSince());
    packets.insert(packets.end(), rest.begin(), rest.end());
    return stream;
  }
  // Nothing is missing that was not counted.
  void expectAccounted(const Packets& packets, const v1::StreamOpened& stream) {
    const Summary summary = checkPackets(packets, true);
    const v1::StreamInfo info = server_.client().info(stream.stream_id());
    EXPECT_EQ(summary.dropped, info.dropped_packets());
    EXPECT_EQ(summary.packets + summary.dropped, packets.back().header.seq());
    EXPECT_EQ(packets.back().header.first_event_index(), info.events());
    EXPECT_EQ(summary.dropped == 0, summary.events == info.events());
  }
  // More than the server's queue holds.
  static v1::OpenStream longRequest() {
    v1::OpenStream request = noisyRequest(v1::DELIVERY_LIVE);
    request.mutable_sensors(0)->set_threshold(0.02);
    request.mutable_timing()->set_duration_s(0.4);
    return request;
  }
};

TEST_F(Live, AStallIsAGapThatIsCounted) {
  for (const Faults& faults : {Faults{.stall = true}, Faults{.bytes_per_s = 1}}) {
    const auto stream = server_.client().open(longRequest());
    ResumingSubscriber subscriber = attach(stream);
    Packets packets;
    outlive(subscriber, packets, stream, faults);
    expectAccounted(packets, stream);
    EXPECT_GT(server_.client().info(stream.stream_id()).dropped_packets(), 0u);
  }
}

TEST_F(Live, ConnectionsThatAreResetLoseNothingUncounted) {
  const auto stream = server_.client().open(longRequest());
  proxy_.set({.cut = Faults::Cut::kReset, .cut_after = 1 << 20});
  ResumingSubscriber subscriber = attach(stream);
  expectAccounted(subscriber.receiveAll(cutSince()), stream);
  EXPECT_GT(subscriber.attached(), 2);
}

}  // namespace
}  // namespace saccade
