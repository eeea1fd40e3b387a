// A stream that goes on from an event, as after the loss of a server.
#include <gtest/gtest.h>

#include "mock/needs_libzmq.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

v1::OpenStream twoSensors() {
  v1::OpenStream request = tinyRequest();
  request.add_sensors()->set_model(v1::EVENT_MODEL_PROBABILISTIC);
  return request;
}

// The packets from the one on that holds event `from`, or begins at it.
Packets restOf(const Packets& whole, std::uint64_t from) {
  Packets rest;
  for (const Received& packet : whole) {
    const std::uint64_t begin = packet.header.first_event_index(), end = begin + packet.header.count();
    if (begin >= from || end > from || packet.header.kind() == v1::KIND_END) rest.push_back(packet);
  }
  return rest;
}

class Resume : public testing::Test {
 protected:
  // Where each of two sensors is to go on.
  void expectRest(std::uint64_t first, std::uint64_t second) {
    v1::OpenStream request = twoSensors();
    request.mutable_sensors(0)->set_from_event(first);
    request.mutable_sensors(1)->set_from_event(second);
    auto rest = again_.run(request);
    EXPECT_EQ(comparableBytes(rest[0]), comparableBytes(restOf(whole_[0], first)));
    EXPECT_EQ(comparableBytes(rest[1]), comparableBytes(restOf(whole_[1], second)));
    EXPECT_NE(rest[0].front().header.epoch(), whole_[0].front().header.epoch());
  }

  TestServer before_, again_;
  std::map<std::uint32_t, Packets> whole_ = before_.run(twoSensors());
};

TEST_F(Resume, FromAnEventGivesTheIdenticalRest) {
  const Packets& first = whole_[0];
  ASSERT_GT(first[3].header.count(), 2u);
  const std::uint64_t at_packet = first[3].header.first_event_index();
  expectRest(at_packet, 0);
  expectRest(at_packet + 1, 1);  // inside of a packet, which comes whole
  const std::uint64_t all = first.back().header.first_event_index();
  expectRest(all, all + 1000);  // END comes in any case
}

// At its pace this one takes 40 s.
TEST_F(Resume, DoesNotKeepThePaceUntilItHasCaughtUp) {
  v1::OpenStream request = twoSensors();
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_speed(1e-3);
  for (const int sensor : {0, 1}) {
    request.mutable_sensors(sensor)->set_from_event(whole_[sensor].back().header.first_event_index());
  }
  const auto began = ChangeNotifier::Clock::now();
  auto rest = again_.run(request);
  EXPECT_LT(ChangeNotifier::Clock::now() - began, std::chrono::seconds(20));
  EXPECT_EQ(comparableBytes(rest[0]),
            comparableBytes(restOf(whole_[0], whole_[0].back().header.first_event_index())));
}

TEST_F(Resume, IsForLosslessStreamsAlone) {
  NEEDS_PATCHED_LIBZMQ();
  v1::OpenStream request = twoSensors();
  request.mutable_sensors(1)->set_from_event(1);
  for (const v1::Delivery delivery : {v1::DELIVERY_LIVE, v1::DELIVERY_BROADCAST}) {
    request.set_delivery(delivery);
    const v1::Status status = again_.client().tryOpen(request);
    EXPECT_EQ(status.code(), v1::CODE_INVALID_ARGUMENT);
    EXPECT_EQ(status.field(), "sensors[1].from_event");
  }
}

TEST(EndReason, SaysWhyAStreamHasEnded) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  EXPECT_EQ(server.run(request)[0].back().header.end_reason(), v1::END_REASON_FINISHED);
  request.mutable_timing()->set_duration_s(0);
  for (const bool drain : {false, true}) {
    const auto stream = server.client().open(request);
    MockSubscriber subscriber = server.dataSubscriber();
    subscriber.attach(stream);
    subscriber.giveCredit(std::uint64_t{1} << 30);
    ASSERT_TRUE(subscriber.receive());
    if (drain) {
      EXPECT_TRUE(server.app().stop());
    } else {
      server.client().close(stream);
    }
    const auto packets = subscriber.receiveAll(1)[0];
    EXPECT_EQ(packets.back().header.end_reason(), drain ? v1::END_REASON_DRAINING : v1::END_REASON_CLOSED);
  }
}

}  // namespace
}  // namespace saccade
