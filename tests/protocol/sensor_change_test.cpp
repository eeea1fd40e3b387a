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
