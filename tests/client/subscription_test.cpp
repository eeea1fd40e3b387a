// A stream whose connection and server come and go as a test says: both ends of the server are played by it.
#include "saccade/subscription.h"

#include <gtest/gtest.h>

#include <functional>

#include "subscription_fixture.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kMs = 1'000'000;

// The packets of a stream of 20 ms, an event each ms and another that is withheld, cut every 5 ms, and END.
std::vector<Packet> packetsOf(const std::string& stream, std::int64_t until_ms = 20,
                              v1::EndReason reason = v1::END_REASON_FINISHED) {
  PacketCutter cutter(PacketSource{stream, 9, 0, 346, 260});
  std::vector<Packet> packets;
  const auto add = [&](std::vector<Packet> more) { packets.insert(packets.end(), more.begin(), more.end()); };
  for (std::int64_t t = 0; t < until_ms; ++t) {
    const Event event{t * kMs, static_cast<std::uint16_t>(t), 2, 1};
    add(cutter.cut(Events{event}, {t * kMs, (t + 1) * kMs, static_cast<std::uint64_t>(t), 1}));
  }
  add(cutter.end(until_ms * kMs, static_cast<std::uint64_t>(until_ms), reason));
  return packets;
}

Events eventsOf(std::int64_t until_ms) {
  Events events;
  for (std::int64_t t = 0; t < until_ms; ++t)
    events.push_back({t * kMs, static_cast<std::uint16_t>(t), 2, 1});
  return events;
}

TEST_F(SubscriptionTest, AfterSilenceAnotherConnectionGoesOn) {
  const auto packets = packetsOf("s1");
  record([&] {
    open("s1");
    EXPECT_EQ(attached().from_seqs(0), 0u);
    send(packets, 0, 1);
    EXPECT_EQ(attached().from_seqs(0), 2u);
    send(packets, 1, 4);  // the first of them was under way already
  });
  EXPECT_EQ(events_, eventsOf(20));
}

TEST_F(SubscriptionTest, AServerThatKnowsNothingOfTheConnectionIsAskedAgain) {
  const auto packets = packetsOf("s1");
  record([&] {
    open("s1");
    attached();
    send(packets, 0, 1);
    data_.send(makeErrorPacket("", "attach to a stream before giving credit"));
    EXPECT_EQ(attached().from_seqs(0), 2u);
    send(packets, 2, 4);
  });
  EXPECT_EQ(events_, eventsOf(20));
}

TEST_F(SubscriptionTest, AStreamThatIsLostIsOpenedAgainAndGoesOnWhereItWas) {
  const auto packets = packetsOf("s1"), again = packetsOf("s2");
  record([&] {
    open("s1");
    attached();
    send(packets, 0, 1);
    attached();
    data_.send(makeErrorPacket("s1", "no stream of this name"));
    const v1::OpenStream request = open("s2");
    EXPECT_EQ(request.sensors(0).from_event(), 10u);
    EXPECT_EQ(request.sensors(0).threshold(), 0.25);
    const v1::Attach attach = attached();
    EXPECT_EQ(attach.stream_id(), "s2");
    EXPECT_EQ(attach.from_seqs(0), 0u);
    v1::PacketHeader heartbeat;
    heartbeat.set_kind(v1::KIND_HEARTBEAT);
    data_.send(sealPacket(heartbeat, {}));
    send(again, 2, 4);
  });
  EXPECT_EQ(events_, eventsOf(20));
  EXPECT_EQ(heartbeats_, 1);
}

TEST_F(SubscriptionTest, EventsCutShortByADrainedServerComeOnce) {
  const auto packets = packetsOf("s1", 7, v1::END_REASON_DRAINING), again = packetsOf("s2");
  record([&] {
    open("s1");
    attached();
    send(packets, 0, 2);
    EXPECT_EQ(open("s2").sensors(0).from_event(), 7u);
    attached();
    send(again, 1, 4);
  });
  EXPECT_EQ(events_, eventsOf(20));
  EXPECT_EQ(suppressed_, 20u);
}

TEST_F(SubscriptionTest, AStreamThatIsNotWhatItWasIsAFault) {
  const auto packets = packetsOf("s1", 7, v1::END_REASON_DRAINING);
  PacketCutter cutter(PacketSource{"s2", 9, 0, 346, 260});
  const std::int64_t t = 5 * kMs;
  cutter.cut(eventsOf(5), {0, t, 0, 0});
  const Events early{{t, 1, 2, 1}, {t, 1, 2, 1}, {t, 1, 2, 1}};
  const auto other = cutter.cut(early, {t, 2 * t, 5, 0});
  EXPECT_NE(faultOf([&] {
              open("s1");
              attached();
              send(packets, 0, 2);
              open("s2");
              attached();
              send(other, 0, 0);
            }).find("does not come out as it did"),
            std::string::npos);
}

TEST_F(SubscriptionTest, TheSameFailureTwiceIsTheEnd) {
  const auto fail = [&](const std::string& stream) {
    open(stream);
    attached();
    data_.send(makeErrorPacket(stream, "the scene is gone"));
  };
  EXPECT_EQ(faultOf([&] { fail("s1"), fail("s2"), open("s3"); }), "the scene is gone");
}

// Each restart begins another epoch.
TEST_F(SubscriptionTest, AnyNumberOfRestartsIsSurvived) {
  const auto packets = packetsOf("s5");
  record([&] {
    for (int epoch = 1; epoch < 5; ++epoch) {
      const std::string stream = "s" + std::to_string(epoch);
      open(stream, static_cast<std::uint64_t>(epoch));
      attached();
      data_.send(makeErrorPacket(stream, "no stream of this name"));
    }
    open("s5", 5), attached();
    send(packets, 0, 4);
  });
  EXPECT_EQ(events_, eventsOf(20));
}

TEST_F(SubscriptionTest, AServerThatNeverComesFurtherIsGivenUp) {
  std::uint64_t opened = 0;
  const auto restartForEver = [&] {
    while (!control_.saysNothing(milliseconds(1500)))  // silence of 500 ms follows each time
      if (answerNext("s" + std::to_string(opened), opened).has_open_stream()) ++opened;
  };
  EXPECT_EQ(faultOf(restartForEver, {.retry_time = milliseconds(1200)}),
            "the connection to the server is lost");
  EXPECT_GT(opened, 1u);
}

TEST_F(SubscriptionTest, ASteeredStreamIsNotOpenedAgain) {
  request_.mutable_timing()->set_steerable(true);
  EXPECT_EQ(faultOf([&] {
              open("s1");
              attached();
              data_.send(makeErrorPacket("s1", "no stream of this name"));
            }),
            "no stream of this name; a stream that its client steers or pushes is not opened again");
}

TEST_F(SubscriptionTest, WithoutTimeToRetryTheEndIsTakenAsItComes) {
  const auto packets = packetsOf("s1", 7, v1::END_REASON_DRAINING);
  record([&] { open("s1"), attached(), send(packets, 0, 2); }, {.retry_time = milliseconds(0)});
  EXPECT_EQ(events_, eventsOf(7));
}

TEST_F(SubscriptionTest, WithoutTimeToRetrySilenceIsAFault) {
  EXPECT_EQ(faultOf([&] { open("s1"), attached(); }, {.retry_time = milliseconds(0)}),
            "the connection to the server is lost");
}

TEST_F(SubscriptionTest, AServerThatIsAwayIsWaitedForAsLongAsTheCallerLikes) {
  int waits = 0;
  const auto waiting = [&waits] {
    if (++waits == 3) throw StreamFault("enough");
  };
  EXPECT_EQ(faultOf([&] { open("s1"), attached(); }, {.waiting = waiting}), "enough");
}

TEST_F(SubscriptionTest, ALossIsAnnouncedOnce) {
  std::vector<std::string> losses;
  const auto packets = packetsOf("s1");
  record(
      [&] {
        open("s1"), attached(), send(packets, 0, 1);
        attached();
        send(packets, 2, 4);
      },
      {.lost = [&losses](const std::string& loss) { losses.push_back(loss); }});
  EXPECT_EQ(losses, std::vector<std::string>{"the connection to the server is lost"});
}

TEST_F(SubscriptionTest, MissingPacketsOfALosslessStreamAreAFault) {
  const auto packets = packetsOf("s1");
  const auto script = [&] { open("s1"), attached(), send(packets, 0, 0), send(packets, 2, 4); };
  EXPECT_NE(faultOf(script).find("missing"), std::string::npos);
}

class LiveSubscription : public SubscriptionTest {
 protected:
  LiveSubscription() { request_.set_delivery(v1::DELIVERY_LIVE); }
};

TEST_F(LiveSubscription, GoesOnWithWhatIsLeftAndCountsTheGap) {
  const auto packets = packetsOf("s1");
  record([&] {
    open("s1");
    attached();
    send(packets, 0, 0);
    EXPECT_EQ(attached().from_seqs(0), 1u);
    send(packets, 3, 4);
  });
  EXPECT_EQ(losses_.packets, 2u);
  EXPECT_EQ(losses_.events, 10u);
}

TEST_F(LiveSubscription, IsNotOpenedAgain) {
  const auto packets = packetsOf("s1");
  EXPECT_EQ(faultOf([&] {
              open("s1");
              attached();
              send(packets, 0, 0);
              attached();
              data_.send(makeErrorPacket("s1", "no stream of this name"));
            }),
            "no stream of this name");
}

}  // namespace
}  // namespace saccade::client
