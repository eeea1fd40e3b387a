// Several clients on one server, each with its own wishes.
#include <gtest/gtest.h>

#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr std::int64_t kTinyEndNs = 40'000'000;

TEST(Service, ServesTwoClientsThatWantDifferentThings) {
  TestServer server(2);
  v1::OpenStream left = tinyRequest(), right = tinyRequest();
  right.mutable_trajectory()->set_name("shake");
  right.mutable_timing()->set_frame_rate_hz(250);
  right.mutable_sensors(0)->set_threshold(0.05);
  right.mutable_sensors(0)->set_bias(1e-2);
  const auto stream_l = server.client().open(left), stream_r = server.client().open(right);
  EXPECT_NE(stream_l.stream_id(), stream_r.stream_id());
  EXPECT_NE(stream_l.token(), stream_r.token());
  EXPECT_EQ(stream_l.frames(), 20u);
  EXPECT_EQ(stream_r.frames(), 10u);

  MockSubscriber sub_l = server.dataSubscriber(), sub_r = server.dataSubscriber();
  for (auto& [sub, stream] : {std::pair{&sub_l, stream_l}, std::pair{&sub_r, stream_r}}) {
    sub->attach(stream);
    sub->giveCredit(1 << 20);
  }
  for (MockSubscriber* sub : {&sub_l, &sub_r}) {
    const Summary summary = checkPackets(sub->receiveAll(1)[0]);
    EXPECT_EQ(summary.end_ns, kTinyEndNs);
    EXPECT_GT(summary.events, 0u);
  }
}

// In the accumulating model a pixel fires once per threshold of change. So half the threshold gives twice the
// events, but for the rest in each pixel at the end.
TEST(Service, SensorsOfOneFeedDifferByTheirThresholds) {
  TestServer server(2);
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0.2);
  request.add_sensors()->set_threshold(0.05);
  auto packets = server.run(request);
  const Summary coarse = checkPackets(packets[0]), fine = checkPackets(packets[1]);
  ASSERT_GT(coarse.events, 100u);
  EXPECT_NEAR(static_cast<double>(fine.events) / static_cast<double>(coarse.events), 2, 0.5);
}

TEST(Service, TellsWhatItResolved) {
  TestServer server;
  const v1::StreamOpened opened = server.client().open(tinyRequest());
  const v1::OpenStream& resolved = opened.resolved();
  EXPECT_EQ(resolved.method().name(), "irradiance_cache");
  EXPECT_EQ(resolved.method().spp(), 2u);
  EXPECT_GT(resolved.method().params_size(), 0);
  EXPECT_GT(resolved.view().fov_x_deg(), 1);
  EXPECT_EQ(resolved.quality().bounces(), 3u);
  EXPECT_EQ(resolved.sensors(0).threshold_off(), 0.1);
  EXPECT_EQ(resolved.sensors(0).model(), v1::EVENT_MODEL_ACCUMULATING);
  EXPECT_EQ(resolved.sensors(0).reconstruction(), v1::RECONSTRUCTION_KALMAN);
  EXPECT_EQ(resolved.timing().clock(), v1::CLOCK_FAST);
  EXPECT_EQ(resolved.delivery(), v1::DELIVERY_LOSSLESS);
  EXPECT_GT(opened.luminance_p50(), 0);
  EXPECT_LE(opened.luminance_p01(), opened.luminance_p50());
  EXPECT_EQ(opened.channels(), 3u);
}

TEST(Service, ClosingEndsAStreamThatHasNoEnd) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  const auto stream = server.client().open(request);
  EXPECT_EQ(stream.frames(), 0u);
  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  ASSERT_TRUE(subscriber.receive());
  auto wrong = stream;
  wrong.set_token("0");
  EXPECT_EQ(server.client().close(wrong).code(), v1::CODE_PERMISSION_DENIED);
  EXPECT_EQ(server.client().close(stream).code(), v1::CODE_OK);
  subscriber.receiveAll(1);  // throws unless END comes
  EXPECT_EQ(server.client().close({}).code(), v1::CODE_NOT_FOUND);
}

TEST(Service, ShowsTheNewestFrame) {
  TestServer server;
  const auto stream = server.client().open(tinyRequest());
  v1::Request request;
  request.mutable_get_frame()->set_stream_id(stream.stream_id());
  request.mutable_get_frame()->set_token(stream.token());
  EXPECT_EQ(server.client().call(request).status().code(), v1::CODE_UNAVAILABLE);  // nobody has attached

  MockSubscriber subscriber = server.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  subscriber.receiveAll(1);
  const v1::Reply reply = server.client().call(request);
  EXPECT_EQ(reply.get_frame().frame(), 20u);
  EXPECT_EQ(reply.get_frame().t1_ns(), kTinyEndNs);
  EXPECT_EQ(reply.get_frame().intensity().size(), 32u * 24 * 4);
  EXPECT_EQ(reply.get_frame().brightness_change().size(), 32u * 24 * 4);
  const v1::StreamInfo info = server.client().info(stream.stream_id());
  EXPECT_EQ(info.frames_done(), 20u);
  EXPECT_GT(info.stage_cpu_ms().at("trace"), 0);
}

TEST(Service, APacedStreamTakesItsTime) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_speed(0.2);
  const auto begin = ChangeNotifier::Clock::now();
  const Summary summary = checkPackets(server.run(request)[0]);
  EXPECT_EQ(summary.end_ns, kTinyEndNs);
  EXPECT_GE(ChangeNotifier::Clock::now() - begin,
            std::chrono::milliseconds(200));  // 40 ms at a fifth of the speed
}

// Both look at one feed, so that the second begins in the middle of it.
TEST(Service, PacedLiveStreamsShareTheirFeed) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_LIVE);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_duration_s(0);
  const auto first = server.client().open(request);
  MockSubscriber sub_1 = server.dataSubscriber(), sub_2 = server.dataSubscriber();
  sub_1.attach(first);
  sub_1.giveCredit(1 << 20);
  ASSERT_TRUE(sub_1.receive());
  request.mutable_sensors(0)->set_threshold(0.3);  // the sensor is no part of the feed
  const auto second = server.client().open(request);
  sub_2.attach(second);
  sub_2.giveCredit(1 << 20);
  const auto packet = sub_2.receive();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->header.seq(), 0u);
  EXPECT_GT(packet->header.frame(), 0u);
  server.client().close(first);
  sub_1.receiveAll(1);
  ASSERT_TRUE(sub_2.receive());  // goes on alone
}

}  // namespace
}  // namespace saccade
