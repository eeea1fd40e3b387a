// Credit, loss, and who may have a stream.
#include <gtest/gtest.h>

#include <optional>

#include "mock/needs_libzmq.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

// Pictures large enough, and thresholds low enough, that the stream is much larger than the server's queue.
v1::OpenStream largeRequest(v1::Delivery delivery) {
  v1::OpenStream request = tinyRequest();
  request.set_delivery(delivery);
  request.mutable_view()->set_width(192);
  request.mutable_view()->set_height(144);
  request.mutable_quality()->set_bounces(0);
  request.mutable_method()->set_name("pt");
  request.mutable_timing()->set_duration_s(0.12);
  request.mutable_sensors(0)->set_threshold(0.02);
  return request;
}

constexpr std::uint64_t kEventBytes = 9;

std::uint64_t totalBytes(const Packets& packets) {
  std::uint64_t bytes = 0;
  for (const auto& packet : packets) bytes += packet.bytes;
  return bytes;
}

std::uint64_t largestFrameBytes(const Packets& packets) {
  std::map<std::uint64_t, std::uint64_t> bytes;
  for (const auto& packet : packets) bytes[packet.header.frame()] += packet.bytes;
  std::uint64_t largest = 0;
  for (const auto& [frame, of_frame] : bytes) largest = std::max(largest, of_frame);
  return largest;
}

TEST(Delivery, LosslessHoldsTheFeedWithoutCreditAndLosesNothing) {
  TestServer server(2);
  const auto stream = server.client().open(largeRequest(v1::DELIVERY_LOSSLESS));
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  constexpr std::uint64_t kCredit = 600'000;
  subscriber.giveCredit(kCredit);

  // Wait for the queue to fill, then give the server time to do wrong.
  Packets packets;
  const auto events = [&] { return server.client().info(stream.stream_id()).events(); };
  while (events() * kEventBytes < kQueueBytes) {
    if (const auto packet = subscriber.receive(std::chrono::milliseconds(20))) packets.push_back(*packet);
  }
  while (const auto packet = subscriber.receive(std::chrono::milliseconds(1000))) packets.push_back(*packet);
  const std::uint64_t received = totalBytes(packets), made = events() * kEventBytes;
  EXPECT_LT(received, kCredit + packets.back().bytes);  // the last one may overdraw it
  EXPECT_LT(server.client().info(stream.stream_id()).frames_done(), stream.frames());

  subscriber.giveCredit(1 << 20);
  const auto rest = subscriber.receiveAll(1)[0];
  packets.insert(packets.end(), rest.begin(), rest.end());
  EXPECT_EQ(checkPackets(packets).end_ns, 120'000'000);
  EXPECT_LE(made, received + kQueueBytes + largestFrameBytes(packets));
}

// Less than a packet's worth must not stall a stream in silence.
TEST(Delivery, AnyCreditThatIsGivenBackKeepsAStreamGoing) {
  TestServer server;
  const auto stream = server.client().open(tinyRequest());
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1);
  const auto first = subscriber.receive();
  ASSERT_TRUE(first);
  EXPECT_FALSE(subscriber.receive(std::chrono::milliseconds(200)));
  subscriber.giveCredit(first->bytes - 1);  // 1 - bytes + (bytes - 1): what was overdrawn is paid, no more
  EXPECT_FALSE(subscriber.receive(std::chrono::milliseconds(200)));
  subscriber.giveCredit(1);
  auto packets = subscriber.receiveAll(1)[0];
  packets.insert(packets.begin(), *first);
  checkPackets(packets);
}

TEST(Delivery, LiveDropsTheOldestAndTheCountsAddUp) {
  TestServer server(2);
  const auto stream = server.client().open(largeRequest(v1::DELIVERY_LIVE));
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  while (server.client().info(stream.stream_id()).frames_done() < stream.frames()) {
    ASSERT_FALSE(subscriber.receive(std::chrono::milliseconds(50)));  // there is no credit
  }
  subscriber.giveCredit(1 << 20);
  const auto packets = subscriber.receiveAll(1)[0];
  const Summary summary = checkPackets(packets, true);
  const auto info = server.client().info(stream.stream_id());
  EXPECT_GT(summary.dropped, 0u);
  EXPECT_EQ(summary.dropped, info.dropped_packets());
  EXPECT_EQ(summary.packets + summary.dropped, packets.back().header.seq());
  // The index of the first event after the last is the number of events made.
  EXPECT_EQ(packets.back().header.first_event_index(), info.events());
  EXPECT_LT(summary.events, info.events());
}

// 476 KB in each of 60 frames, of which the queue holds nine.
TEST(Delivery, LiveDropsTruthAsItDropsEvents) {
  TestServer server(2);
  v1::OpenStream request = largeRequest(v1::DELIVERY_LIVE);
  for (const char* name : {"intensity", "normals", "frame"}) request.add_truth()->set_name(name);
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  while (server.client().info(stream.stream_id()).frames_done() < stream.frames()) {
    ASSERT_FALSE(subscriber.receive(std::chrono::milliseconds(50)));  // there is no credit
  }
  subscriber.giveCredit(64 << 20);
  std::uint64_t dropped = 0, bytes = 0, largest_frame = 0;
  for (const auto& [channel, packets] : subscriber.receiveAll(4)) {
    std::uint64_t seq = 0;
    for (const Received& packet : packets) {
      EXPECT_EQ(packet.header.seq(), seq + packet.header.dropped_before()) << channel;
      seq = packet.header.seq() + 1;
      dropped += packet.header.dropped_before();
    }
    EXPECT_GT(packets.front().header.seq(), 0u) << channel;
    if (channel > 0) {
      EXPECT_EQ(packets.back().header.first_event_index(), channel == 3 ? 60u : 61u);
    }
    bytes += totalBytes(packets);
    largest_frame += largestFrameBytes(packets);
  }
  EXPECT_EQ(dropped, server.client().info(stream.stream_id()).dropped_packets());
  EXPECT_LE(bytes, kQueueBytes + 2 * largest_frame);  // the newest frame, and what is left at the end
}

TEST(Delivery, OnlyTheTokenOpensTheDoor) {
  TestServer server;
  const auto stream = server.client().open(tinyRequest());
  auto forged = stream;
  forged.set_token(std::string(32, '0'));
  MockSubscriber thief = server.dataSubscriber(), owner = server.dataSubscriber();
  owner.attach(stream);
  thief.attach(forged);
  const auto refusal = thief.receive();
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->header.kind(), v1::KIND_ERROR);
  EXPECT_FALSE(refusal->payload.empty());
  for (const std::string& bytes : {std::string("\xff\xff\xff"), std::string()}) {
    thief.sendRaw(bytes);
    EXPECT_EQ(thief.receive()->header.kind(), v1::KIND_ERROR);
  }
  thief.giveCredit(1000);
  EXPECT_EQ(thief.receive()->header.kind(), v1::KIND_ERROR);
  owner.giveCredit(1 << 20);
  checkPackets(owner.receiveAll(1)[0]);
}

TEST(Delivery, AnotherConnectionOfTheClientResumesWithoutLoss) {
  TestServer server;
  const auto stream = server.client().open(tinyRequest());
  MockSubscriber first = server.dataSubscriber(), second = server.dataSubscriber();
  first.attach(stream);
  first.giveCredit(1 << 20);
  Packets packets;
  for (int i = 0; i < 5; ++i) packets.push_back(*first.receive());
  first.acknowledge(0, 2);
  second.attach(stream, {packets.back().header.seq() + 1});
  second.giveCredit(1 << 20);
  const auto rest = second.receiveAll(1)[0];
  packets.insert(packets.end(), rest.begin(), rest.end());
  checkPackets(packets);
}

TEST(Delivery, AResumeNamesEverySensorAndWhatIsHeld) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.add_sensors();
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1);
  ASSERT_TRUE(subscriber.receive());
  subscriber.acknowledge(0, 0);
  subscriber.acknowledge(2, 0);  // there is no such sensor
  subscriber.attach(stream, {0});
  subscriber.attach(stream, {0, 0});
  for (const char* told : {"no sensor 2", "2 sensors", "before seq 1"}) {
    const auto refusal = subscriber.receive();
    ASSERT_TRUE(refusal);
    EXPECT_NE(refusal->payload.find(told), std::string::npos) << refusal->payload;
  }
}

TEST(Delivery, CompressedStreamsHoldTheSameEvents) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  const auto plain = server.run(request)[0];
  request.set_codec(v1::CODEC_ZSTD);
  const auto packed = server.run(request)[0];
  ASSERT_EQ(plain.size(), packed.size());
  std::uint64_t plain_bytes = 0, packed_bytes = 0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    PacketContent a, b;
    EXPECT_EQ(decodePacket(plain[i].header, plain[i].payload, a), "");
    EXPECT_EQ(decodePacket(packed[i].header, packed[i].payload, b), "");
    EXPECT_EQ(a.events, b.events);
    plain_bytes += plain[i].payload.size();
    packed_bytes += packed[i].payload.size();
  }
  EXPECT_LT(packed_bytes, plain_bytes * 2 / 3);
}

TEST(Delivery, BroadcastStartsWithItsFirstSubscriberAndHasNoGap) {
  NEEDS_PATCHED_LIBZMQ();
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_BROADCAST);
  request.add_sensors()->set_threshold(0.2);
  const auto stream = server.client().open(request);
  ASSERT_EQ(stream.topics_size(), 2);
  EXPECT_EQ(stream.topics(1), "s/" + stream.stream_id() + "/1/");
  EXPECT_EQ(server.client().info(stream.stream_id()).frames_done(), 0u);
  MockSubscriber subscriber = server.broadcastSubscriber(stream);
  auto packets = subscriber.receiveAll(2);
  for (std::uint32_t sensor : {0u, 1u}) {
    EXPECT_EQ(checkPackets(packets[sensor]).end_ns, 40'000'000);
    for (const auto& packet : packets[sensor]) EXPECT_EQ(packet.topic, stream.topics(sensor));
  }
}

TEST(Delivery, BroadcastLivesAsLongAsAnybodySubscribes) {
  NEEDS_PATCHED_LIBZMQ();
  Config config = testConfig();
  config.lease_s = 1;
  TestServer server(config);
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_BROADCAST);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_frame_rate_hz(20);
  request.mutable_timing()->set_duration_s(0);
  const auto stream = server.client().open(request);
  std::optional<MockSubscriber> first(server.broadcastSubscriber(stream));
  ASSERT_TRUE(first->receive());
  std::optional<MockSubscriber> second(server.broadcastSubscriber(stream));
  ASSERT_TRUE(second->receive());
  first.reset();
  const auto begin = second->receive()->header.t0_ns();
  while (second->receive()->header.t1_ns() < begin + 3'000'000'000) {  // some leases, and sweeps
  }
  EXPECT_EQ(server.client().info(stream.stream_id()).stream_id(), stream.stream_id());
  second.reset();
  const auto deadline = ChangeNotifier::Clock::now() + kPatience;
  while (server.client().info(stream.stream_id()).stream_id() == stream.stream_id()) {
    ASSERT_LT(ChangeNotifier::Clock::now(), deadline);
  }
}

// Prefixes would let one subscriber have, and start, the streams of all others.
TEST(Delivery, BroadcastKnowsOnlyExactTopics) {
  NEEDS_PATCHED_LIBZMQ();
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_BROADCAST);
  const auto stream = server.client().open(request);
  MockSubscriber spy = server.broadcastSubscriber({"", "s/", "s/" + stream.stream_id() + "/1/"});
  EXPECT_FALSE(spy.receive(std::chrono::milliseconds(500)));
  EXPECT_EQ(server.client().info(stream.stream_id()).frames_done(), 0u);
  MockSubscriber subscriber = server.broadcastSubscriber(stream);
  checkPackets(subscriber.receiveAll(1)[0]);
  EXPECT_FALSE(spy.receive(std::chrono::milliseconds(100)));
}

TEST(Delivery, StoppingEndsEveryStreamWithEnd) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  const auto stream = server.client().open(request);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(std::uint64_t{1} << 30);
  ASSERT_TRUE(subscriber.receive());
  EXPECT_TRUE(server.app().stop());
  subscriber.receiveAll(1);
}

}  // namespace
}  // namespace saccade
