// Opening a stream: replies that cannot be, and servers that are not ready.
#include <cmath>

#include "subscription_fixture.h"

namespace saccade::client {
namespace {

struct OpeningTest : SubscriptionTest {};

TEST_F(OpeningTest, RepliesThatCannotBeAreFaults) {
  using Opened = v1::StreamOpened;
  const std::vector<std::pair<std::string, Lie>> lies{
      {"without stream_id", [](Opened& o) { o.clear_stream_id(); }},
      {"0 sensors instead of 1", [](Opened& o) { o.mutable_resolved()->clear_sensors(); }},
      {"2 sensors instead of 1", [](Opened& o) { o.mutable_resolved()->add_sensors(); }},
      {"1 truth channels instead of 0", [](Opened& o) { o.mutable_resolved()->add_truth(); }},
      {"1 further views instead of 0", [](Opened& o) { o.mutable_resolved()->add_further_views(); }},
      {"a sensor of view 7 of 1", [](Opened& o) { o.mutable_resolved()->mutable_sensors(0)->set_view(7); }},
      {"view.width is 0", [](Opened& o) { o.mutable_resolved()->mutable_view()->set_width(0); }},
      {"a view of 346x261", [](Opened& o) { o.mutable_resolved()->mutable_view()->set_height(261); }},
      {"frame_rate_hz is nan",
       [](Opened& o) { o.mutable_resolved()->mutable_timing()->set_frame_rate_hz(NAN); }},
      {"duration_s is inf",
       [](Opened& o) { o.mutable_resolved()->mutable_timing()->set_duration_s(INFINITY); }},
      {"delivery 99", [](Opened& o) { o.mutable_resolved()->set_delivery(static_cast<v1::Delivery>(99)); }},
      {"delivery 3", [](Opened& o) { o.mutable_resolved()->set_delivery(v1::DELIVERY_BROADCAST); }},
  };
  for (const auto& [text, lie] : lies) {
    const std::string fault = faultOf([&, lie = lie] { open("s1", 0, lie); });
    EXPECT_NE(fault.find("reply to open_stream cannot be: "), std::string::npos) << text << ": " << fault;
    EXPECT_NE(fault.find(text), std::string::npos) << fault;
  }
}

TEST_F(OpeningTest, TruthOfAViewThatIsNotThereIsAFault) {
  request_.add_truth()->set_name("depth");
  const std::string fault = faultOf([&] {
    open("s1", 0, [](v1::StreamOpened& o) { o.mutable_resolved()->mutable_truth(0)->set_view(9); });
  });
  EXPECT_NE(fault.find("truth of view 9 of 1"), std::string::npos) << fault;
}

TEST_F(OpeningTest, AnEndpointThatIsNoneIsAFault) {
  const std::string fault = faultOf([&] {
    const auto info = control_.receive<v1::Request>();
    v1::Reply reply;
    reply.set_request_id(info.request_id());
    reply.mutable_status()->set_code(v1::CODE_OK);
    reply.mutable_server_info();
    control_.send(reply);
    open("s1");
  });
  EXPECT_NE(fault.find("announces an endpoint for packets that is none: ''"), std::string::npos) << fault;
}

// It stops, or has not its streams yet; and then another takes its place.
TEST_F(OpeningTest, AnOpenWaitsForAServerThatRestarts) {
  const auto stop = [&](bool knows) {
    const auto request = control_.receive<v1::Request>();
    v1::Reply reply;
    reply.set_request_id(request.request_id());
    reply.mutable_status()->set_code(knows ? v1::CODE_OK : v1::CODE_UNAVAILABLE);
    if (knows) reply.mutable_server_info();
    control_.send(reply);
  };
  auto server = std::async(std::launch::async, [&] { stop(false), stop(true), stop(false), open("s1"); });
  ControlClient control(context_, control_.endpoint());
  int away = 0;
  const StreamHandle stream(
      control, request_,
      {.retry_time = milliseconds(10'000), .away = [&away](const std::exception&) { ++away; }});
  EXPECT_EQ(stream.opened().stream_id(), "s1");
  EXPECT_EQ(away, 2);
}

TEST_F(OpeningTest, AnOpenDoesNotWaitForASceneThatCannotBeOpened) {
  auto server = std::async(std::launch::async, [&] {
    const auto request = control_.receive<v1::Request>();
    v1::Reply reply;
    reply.set_request_id(request.request_id());
    reply.mutable_status()->set_code(v1::CODE_UNAVAILABLE);
    reply.mutable_status()->set_field("scene");
    control_.send(reply);
  });
  ControlClient control(context_, control_.endpoint());
  EXPECT_THROW(StreamHandle(control, request_, {.retry_time = std::chrono::minutes(10)}), Refused);
}

// The server's part tells of the stream once, and then is gone.
TEST_F(OpeningTest, TheInfoOfAStreamOutlastsTheServersMemoryOfIt) {
  auto server = std::async(std::launch::async, [&] {
    open("s1");
    v1::Reply reply;
    reply.set_request_id(control_.receive<v1::Request>().request_id());
    reply.mutable_status()->set_code(v1::CODE_OK);
    v1::StreamInfo& info = *reply.mutable_list_streams()->add_streams();
    info.set_stream_id("s1");
    info.set_frame_cpu_ms(3);
    control_.send(reply);
    EXPECT_TRUE(control_.receive<v1::Request>().has_close_stream());
  });
  ControlClient control(context_, control_.endpoint());
  StreamHandle stream(control, request_);
  stream.closeKnown();
  server.get();
  const auto info = stream.info();
  ASSERT_TRUE(info);
  EXPECT_EQ(info->frame_cpu_ms(), 3);
}

}  // namespace
}  // namespace saccade::client
