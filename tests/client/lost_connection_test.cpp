// A client behind a network that cuts its connections: what it gets in the end is what the server made.
#include <gtest/gtest.h>

#include <map>

#include "control_relay.h"
#include "mock/fault_proxy.h"
#include "mock/test_server.h"
#include "saccade/subscription.h"

namespace saccade::client {
namespace {

using std::chrono::milliseconds;

// A client's result: events by sensor, and those that END says there were.
struct Recording {
  std::map<std::uint32_t, Events> events;
  std::uint64_t told = 0;
  Losses losses;
};

// Each connection to the data socket is reset after as many bytes as a test says.
class LostConnection : public testing::Test {
 protected:
  LostConnection() {
    request_.mutable_timing()->set_duration_s(0.1);
    *request_.add_sensors() = request_.sensors(0);
    request_.mutable_sensors(1)->set_threshold(0.2);
  }

  Recording record() {
    Recording got;
    ControlClient control(context_, relay_.endpoint());
    StreamHandle stream(control, request_);
    Subscription subscription(context_, stream, {.silence = milliseconds(300)});
    for (int ended = 0; ended < request_.sensors_size();) {
      const auto batch = subscription.receive(milliseconds(1000));
      if (!batch) continue;
      Events& events = got.events[batch->header.sensor()];
      events.insert(events.end(), batch->events.begin(), batch->events.end());
      if (batch->header.kind() != v1::KIND_END) continue;
      ++ended;
      got.told += batch->header.first_event_index();
    }
    got.losses = subscription.losses();
    return got;
  }

  zmq::context_t context_;
  TestServer server_;
  FaultProxy proxy_{server_.client().server().data_endpoint()};
  ControlRelay relay_{server_.app().controlEndpoint(), proxy_.endpoint()};
  v1::OpenStream request_ = tinyRequest();
};

TEST_F(LostConnection, ALosslessStreamIsWhatTheServerMade) {
  const Recording whole = record();
  const std::uint64_t events = whole.events.at(0).size() + whole.events.at(1).size();
  EXPECT_EQ(events, whole.told);
  proxy_.set({.cut = Faults::Cut::kReset, .cut_after = 9 * events / 3});
  EXPECT_EQ(record().events, whole.events);
  EXPECT_GE(proxy_.cuts(), 2);
}

TEST_F(LostConnection, PacketsThatALiveStreamMissedAreCounted) {
  request_.set_delivery(v1::DELIVERY_LIVE);
  proxy_.set({.cut = Faults::Cut::kReset, .cut_after = 20000});
  const Recording got = record();
  EXPECT_GE(proxy_.cuts(), 2);
  EXPECT_EQ(got.events.at(0).size() + got.events.at(1).size() + got.losses.events, got.told);
}

}  // namespace
}  // namespace saccade::client
