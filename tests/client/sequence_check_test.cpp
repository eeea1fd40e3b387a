#include "saccade/sequence_check.h"

#include <gtest/gtest.h>

#include "saccade/stream_fault.h"

namespace saccade::client {
namespace {

v1::PacketHeader headerOf(std::uint32_t sensor, std::uint64_t seq, std::uint64_t first, std::uint32_t count,
                          std::int64_t t0_ns, std::int64_t t1_ns) {
  v1::PacketHeader header;
  header.set_kind(v1::KIND_EVENTS);
  header.set_sensor(sensor);
  header.set_seq(seq);
  header.set_first_event_index(first);
  header.set_count(count);
  header.set_t0_ns(t0_ns);
  header.set_t1_ns(t1_ns);
  return header;
}

v1::OpenStream requestFrom(const std::vector<std::uint64_t>& events) {
  v1::OpenStream request;
  for (const std::uint64_t event : events) request.add_sensors()->set_from_event(event);
  return request;
}

// A packet is new as a whole from its t0 on.
void expectNext(SequenceCheck& check, const v1::PacketHeader& header) {
  const auto fresh = check.add(header);
  ASSERT_TRUE(fresh);
  EXPECT_EQ(fresh->known_items, 0u);
  EXPECT_EQ(fresh->t0_ns, header.t0_ns());
}

TEST(SequenceCheck, SensorsAreFollowedApart) {
  SequenceCheck check(requestFrom({0, 0}));
  expectNext(check, headerOf(0, 0, 0, 5, 0, 1000));
  expectNext(check, headerOf(1, 0, 0, 2, 0, 1000));
  expectNext(check, headerOf(0, 1, 5, 0, 1000, 2000));
  expectNext(check, headerOf(1, 1, 2, 0, 1000, 2000));
  EXPECT_EQ(check.losses().gaps, 0u);
  EXPECT_EQ(check.seqs(), (std::vector<std::uint64_t>{2, 2}));
  EXPECT_EQ(check.items(), (std::vector<std::uint64_t>{5, 2}));
  EXPECT_THROW(check.add(headerOf(2, 0, 0, 0, 0, 1000)), StreamFault);
}

TEST(SequenceCheck, AStreamMayBeginAtAnyTime) {
  SequenceCheck check(requestFrom({0, 0}));
  expectNext(check, headerOf(0, 0, 0, 5, 8000, 9000));
  expectNext(check, headerOf(1, 0, 0, 2, 8000, 9000));
  expectNext(check, headerOf(0, 1, 5, 1, 9000, 9500));
  EXPECT_THROW(check.add(headerOf(1, 1, 2, 1, 9500, 9900)), StreamFault);  // from then on without holes
}

TEST(SequenceCheck, AGapIsCountedOnce) {
  SequenceCheck check(requestFrom({0}));
  expectNext(check, headerOf(0, 3, 70, 5, 4000, 5000));  // seq 0, 1 and 2 are missing
  expectNext(check, headerOf(0, 4, 75, 5, 5000, 6000));
  EXPECT_EQ(check.losses().gaps, 1u);
  EXPECT_EQ(check.losses().packets, 3u);
  EXPECT_EQ(check.losses().events, 70u);
}

// A LIVE stream drops truth as it drops events.
TEST(SequenceCheck, CountsTheSamplesOfMissingTruthApart) {
  v1::OpenStream request = requestFrom({0});
  request.add_truth();
  SequenceCheck check(request);
  expectNext(check, headerOf(0, 2, 70, 5, 4000, 5000));
  expectNext(check, headerOf(1, 3, 9, 5, 4000, 5000));
  EXPECT_EQ(check.losses().gaps, 2u);
  EXPECT_EQ(check.losses().packets, 5u);
  EXPECT_EQ(check.losses().events, 70u);
  EXPECT_EQ(check.losses().samples, 9u);
}

TEST(SequenceCheck, HeartbeatsTakeNoSeq) {
  SequenceCheck check(requestFrom({0}));
  auto heartbeat = headerOf(0, 0, 0, 0, 0, 0);
  heartbeat.set_kind(v1::KIND_HEARTBEAT);
  EXPECT_FALSE(check.add(heartbeat));
  expectNext(check, headerOf(0, 0, 0, 0, 0, 1000));
  EXPECT_FALSE(check.add(heartbeat));
  expectNext(check, headerOf(0, 1, 0, 0, 1000, 2000));
  EXPECT_EQ(check.losses().gaps, 0u);
}

TEST(SequenceCheck, PacketsThatCameBeforeAreSkipped) {
  SequenceCheck check(requestFrom({0}));
  expectNext(check, headerOf(0, 0, 0, 5, 0, 1000));
  expectNext(check, headerOf(0, 1, 5, 5, 1000, 2000));
  EXPECT_FALSE(check.add(headerOf(0, 0, 0, 5, 0, 1000)));
  EXPECT_FALSE(check.add(headerOf(0, 1, 5, 5, 1000, 2000)));
  expectNext(check, headerOf(0, 2, 10, 5, 2000, 3000));
  auto end = headerOf(0, 3, 15, 0, 3000, 3000);
  end.set_kind(v1::KIND_END);
  expectNext(check, end);
  EXPECT_FALSE(check.add(end));
  EXPECT_EQ(check.losses().gaps, 0u);
}

TEST(SequenceCheck, APacketThatDoesNotFollowIsAFault) {
  const auto second = [](const v1::PacketHeader& header) {
    SequenceCheck check(requestFrom({0}));
    expectNext(check, headerOf(0, 0, 0, 5, 0, 1000));
    EXPECT_THROW(check.add(header), StreamFault) << header.ShortDebugString();
  };
  second(headerOf(0, 1, 5, 5, 2000, 3000));  // a hole in time
  second(headerOf(0, 1, 6, 5, 1000, 2000));  // a hole in the events
  second(headerOf(0, 2, 4, 5, 2000, 3000));  // events run backwards
}

TEST(SequenceCheck, AStreamBeginsWithTheEventThatWasAskedFor) {
  const auto first = [](const v1::PacketHeader& header) {
    SequenceCheck check(requestFrom({100}));
    const auto fresh = check.add(header);
    if (fresh)
      expectNext(check, headerOf(0, header.seq() + 1, header.first_event_index() + header.count(), 1,
                                 header.t1_ns(), header.t1_ns() + 1000));
    return fresh;
  };
  EXPECT_EQ(first(headerOf(0, 9, 90, 20, 8000, 9000)).value().known_items, 10u);
  EXPECT_EQ(first(headerOf(0, 9, 100, 20, 8000, 9000)).value().known_items, 0u);
  EXPECT_EQ(first(headerOf(0, 9, 100, 0, 8000, 9000)).value().t0_ns, 8000);  // nothing happened, and then it
  EXPECT_FALSE(first(headerOf(0, 9, 90, 10, 8000, 9000)));
  EXPECT_THROW(first(headerOf(0, 9, 101, 20, 8000, 9000)), StreamFault);
  auto end = headerOf(0, 9, 100, 0, 9000, 9000);
  end.set_kind(v1::KIND_END);
  EXPECT_TRUE(SequenceCheck(requestFrom({100})).add(end));
  EXPECT_THROW(SequenceCheck(requestFrom({101})).add(end), StreamFault);
}

TEST(SequenceCheck, AStreamThatIsOpenedAgainGoesOnInTimeToo) {
  const auto again = [](const v1::PacketHeader& header) {
    SequenceCheck check(requestFrom({0}));
    expectNext(check, headerOf(0, 0, 0, 5, 0, 5000));
    auto cut_short = headerOf(0, 1, 5, 5, 5000, 7000);
    cut_short.set_suppressed(3);
    cut_short.set_artefacts(2);
    cut_short.set_lost_in_readout(1);
    expectNext(check, cut_short);
    check.restart();
    EXPECT_EQ(check.seqs(), (std::vector<std::uint64_t>{0}));
    EXPECT_EQ(check.items(), (std::vector<std::uint64_t>{10}));
    const auto fresh = check.add(header);
    EXPECT_EQ(check.seqs(), (std::vector<std::uint64_t>{header.seq() + 1}));  // where a connection goes on
    return fresh;
  };
  const auto rest = again(headerOf(0, 1, 5, 9, 5000, 10000));  // that packet had been cut short
  EXPECT_EQ(rest.value().known_items, 5u);
  EXPECT_EQ(rest.value().t0_ns, 7000);
  EXPECT_EQ(rest.value().known_withheld.suppressed, 3u);
  EXPECT_EQ(rest.value().known_withheld.artefacts, 2u);
  EXPECT_EQ(rest.value().known_withheld.lost_in_readout, 1u);
  EXPECT_FALSE(again(headerOf(0, 1, 10, 0, 5000, 7000)));
  EXPECT_FALSE(again(headerOf(0, 0, 0, 5, 0, 5000)));
  EXPECT_EQ(again(headerOf(0, 1, 10, 0, 5000, 10000)).value().t0_ns, 7000);
  const auto later = again(headerOf(0, 2, 10, 1, 10000, 15000));  // nothing happened until then
  EXPECT_EQ(later.value().t0_ns, 10000);
  EXPECT_EQ(later.value().known_withheld.suppressed, 0u);
}

}  // namespace
}  // namespace saccade::client
