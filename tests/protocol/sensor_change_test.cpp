// Sensors that change while their stream runs.
#include <gtest/gtest.h>

#include "mock/bad_request.h"
#include "mock/control_calls.h"
#include "mock/events_of.h"

namespace saccade {
namespace {

v1::SensorChange halved(double time_s) {
  v1::SensorChange change;
  change.set_time_s(time_s);
  change.set_threshold(0.05);
  change.set_threshold_off(0.05);
  return change;
}

v1::SensorChange brighter(double time_s) {
  v1::SensorChange change;
  change.set_time_s(time_s);
  change.set_bias(0.1);
  return change;
}

v1::OpenStream withChanges() {
  v1::OpenStream request = tinyRequest();
  *request.mutable_sensors(0)->add_changes() = halved(0.0135);
  *request.mutable_sensors(0)->add_changes() = brighter(0.03);
  return request;
}

v1::SensorChange noisier(double time_s) {
  v1::SensorChange change;
  change.set_time_s(time_s);
  change.mutable_noise()->set_shot_hz(100);
  return change;
}

// How many lie before a time of stream; the events are in order.
std::ptrdiff_t countBefore(const Events& events, std::int64_t t_ns) {
  return std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.t_ns < t_ns; });
}

class SensorChanges : public testing::Test {
 protected:
  v1::Reply call(const v1::Request& request) { return server_.client().call(request); }
  TestServer server_{2};
};

TEST_F(SensorChanges, ApplyFromTheFirstIntervalThatBeginsThen) {
  v1::OpenStream request = tinyRequest();
  *request.mutable_sensors(0)->add_changes() = halved(0.0135);
  const Events plain = eventsOf(server_.run(tinyRequest())[0]), changed = eventsOf(server_.run(request)[0]);
  const std::int64_t at = 14'000'000;  // the first frame after 13.5 ms
  const auto before = countBefore(plain, at);
  ASSERT_EQ(before, countBefore(changed, at));
  EXPECT_TRUE(std::equal(plain.begin(), plain.begin() + before, changed.begin()));
  // Half the thresholds: pixels beyond them fire at once, and then about twice as often.
  EXPECT_GT(countBefore(changed, at + 1000) - before, countBefore(plain, at + 1000) - before + 50);
  EXPECT_GT(changed.size(), plain.size() * 5 / 4);
}

TEST_F(SensorChanges, OfARunningStreamAreThoseOfTheRequest) {
  const auto stream = server_.client().open(tinyRequest());
  const v1::Reply first = call(changeOf(stream, 0, brighter(0.03))),
                  second = call(changeOf(stream, 0, halved(0.0135)));
  EXPECT_EQ(first.change_sensor().frame(), 15u);
  EXPECT_EQ(second.change_sensor().frame(), 7u);
  EXPECT_EQ(second.change_sensor().t_ns(), 14'000'000);
  MockSubscriber subscriber = server_.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 24);
  const std::string bytes = comparableBytes(subscriber.receiveAll(1)[0]);
  EXPECT_EQ(bytes, comparableBytes(server_.run(withChanges())[0]));
  EXPECT_EQ(bytes, comparableBytes(server_.run(describe(server_.client(), stream))[0]));
}

TEST_F(SensorChanges, OfTheNoiseKeepTheSignalAndWhatTheyLeaveOut) {
  v1::OpenStream plain = tinyRequest();
  plain.mutable_sensors(0)->set_labels(true);
  plain.mutable_sensors(0)->mutable_noise()->set_leak_hz(50);
  v1::OpenStream request = plain;
  *request.mutable_sensors(0)->add_changes() = noisier(0.0135);
  const auto before = server_.run(plain)[0], after = server_.run(request)[0];
  const auto part = [](const std::vector<Received>& packets, int source) {
    Events events = eventsOf(packets);
    std::erase_if(events, [&](const Event& e) { return e.source != source; });
    return events;
  };
  EXPECT_EQ(part(before, 0), part(after, 0));
  const Events leak = part(before, 1), noise = part(after, 1);
  // Leak goes on; 100 Hz of 768 pixels for 26 ms are 2000 events in the dark, and 500 in bright light.
  const auto more = static_cast<std::ptrdiff_t>(noise.size()) - static_cast<std::ptrdiff_t>(leak.size());
  EXPECT_GT(more, 500);
  EXPECT_LT(more, 2200);
  EXPECT_EQ(countBefore(noise, 14'000'000), countBefore(leak, 14'000'000));

  const auto stream = server_.client().open(plain);
  EXPECT_EQ(call(changeOf(stream, 0, noisier(0.0135))).change_sensor().frame(), 7u);
  MockSubscriber subscriber = server_.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 24);
  EXPECT_EQ(comparableBytes(subscriber.receiveAll(1)[0]), comparableBytes(after));
  const v1::OpenStream told = describe(server_.client(), stream);
  EXPECT_EQ(told.sensors(0).changes(0).noise().leak_hz(), 50);
  EXPECT_EQ(comparableBytes(server_.run(told)[0]), comparableBytes(after));
}

TEST_F(SensorChanges, OfTheNoiseNeedRoom) {
  v1::OpenStream good = tinyRequest();
  *good.mutable_sensors(0)->add_changes() = noisier(0);
  const auto noise = [](v1::OpenStream& r) {
    return r.mutable_sensors(0)->mutable_changes(0)->mutable_noise();
  };
  const std::string field = "sensors[0].changes[0].noise";
  const v1::Code invalid = v1::CODE_INVALID_ARGUMENT;
  expectRefused(
      server_,
      {{good, [&](auto& r) { noise(r)->set_mismatch(0.1); }, invalid, field + ".mismatch", "keep"},
       {good, [&](auto& r) { noise(r)->set_rate_spread(0.1); }, invalid, field + ".rate_spread", "keep"},
       {good, [&](auto& r) { noise(r)->set_shot_hz(1001); }, invalid, field + ".shot_hz", "1001"},
       {good, [&](auto& r) { noise(r)->set_readout_buffer(1025); }, invalid, field + ".readout_buffer",
        "1024"},
       {good, [&](auto& r) { noise(r)->set_hot_fraction(1), noise(r)->set_hot_hz(500); }, invalid, field,
        "room"},
       {good, [&](auto& r) { r.mutable_sensors(0)->set_max_events_per_frame(150); },
        v1::CODE_RESOURCE_EXHAUSTED, field, "154 noise events of a frame exceed 150"}});
  v1::OpenStream open = tinyRequest();
  open.mutable_sensors(0)->set_max_events_per_frame(150);
  const auto stream = server_.client().open(open);
  EXPECT_EQ(call(changeOf(stream, 0, noisier(0))).status().limit(), "events");
  v1::SensorChange change;
  change.mutable_noise()->set_mismatch(0.1);
  EXPECT_EQ(call(changeOf(stream, 0, change)).status().field(), "change.noise.mismatch");
  change.mutable_noise()->clear_mismatch();
  EXPECT_EQ(call(changeOf(stream, 0, change)).status().code(), v1::CODE_OK);
}

TEST_F(SensorChanges, ApplyAtOnceWhereTheirTimeIsOver) {
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_LOCKSTEP);
  const auto stream = server_.client().open(request);
  MockSubscriber subscriber = server_.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 24);
  for (int i = 1; i <= 3; ++i) call(steerTo(stream, 0.02 * i));
  while (subscriber.receive()->header.t1_ns() < 6'000'000) {
  }
  EXPECT_EQ(call(changeOf(stream, 0, halved(0))).change_sensor().frame(), 3u);
  const v1::OpenStream so_far = describe(server_.client(), stream);
  ASSERT_EQ(so_far.sensors(0).changes_size(), 1);
  EXPECT_EQ(so_far.sensors(0).changes(0).time_s(), 0.006);
}

TEST_F(SensorChanges, OfTheBiasMakeNoEventThemselves) {
  v1::OpenStream still = tinyRequest();
  still.mutable_trajectory()->set_name("still");
  *still.mutable_sensors(0)->add_changes() = brighter(0.01);
  EXPECT_EQ(eventsOf(server_.run(still)[0]).size(), 0u);
}

TEST_F(SensorChanges, AreRefusedByField) {
  using Open = v1::OpenStream;
  const Open good = withChanges();
  expectRefused(server_, {{good, [](Open& r) { r.mutable_sensors(0)->mutable_changes(1)->set_time_s(0.001); },
                           v1::CODE_INVALID_ARGUMENT, "sensors[0].changes[1].time_s", "before"},
                          {good, [](Open& r) { r.mutable_sensors(0)->mutable_changes(0)->set_threshold(0); },
                           v1::CODE_INVALID_ARGUMENT, "sensors[0].changes[0].threshold", "0"},
                          {good, [](Open& r) { r.mutable_sensors(0)->mutable_changes(1)->clear_bias(); },
                           v1::CODE_INVALID_ARGUMENT, "sensors[0].changes[1]", "nothing"},
                          {good,
                           [](Open& r) {
                             for (int i = 0; i < 999; ++i)
                               *r.mutable_sensors(0)->add_changes() = brighter(0.03);
                           },
                           v1::CODE_INVALID_ARGUMENT, "sensors[0].changes", "1000"}});
  const auto stream = server_.client().open(tinyRequest());
  EXPECT_EQ(call(changeOf(stream, 1, halved(0))).status().field(), "sensor");
  EXPECT_EQ(call(changeOf(stream, 0, {})).status().field(), "change");
  EXPECT_EQ(call(changeOf(stream, 0, halved(-1))).status().field(), "change.time_s");
  v1::Request stranger = changeOf(stream, 0, halved(0));
  stranger.mutable_change_sensor()->set_token("0");
  EXPECT_EQ(call(stranger).status().code(), v1::CODE_PERMISSION_DENIED);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(call(changeOf(stream, 0, halved(0))).status().code(), v1::CODE_OK);
  EXPECT_EQ(call(changeOf(stream, 0, halved(0))).status().field(), "change");
}

}  // namespace
}  // namespace saccade
