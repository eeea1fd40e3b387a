// A stream whose connection and server come and go as a test says: both ends of the server are played by it.
#include "client/subscription.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <future>

#include "fake_server.h"

namespace saccade::client {
namespace {

using std::chrono::milliseconds;

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

class SubscriptionTest : public testing::Test {
 protected:
  // The server's part. Answers what is asked on control until a stream is opened, as `stream`; what was
  // asked.
  // `lie`: changes the reply.
  using Lie = std::function<void(v1::StreamOpened&)>;
  v1::OpenStream open(
      const std::string& stream, std::uint64_t epoch = 0, const Lie& lie = [](v1::StreamOpened&) {}) {
    while (true) {
      const auto request = answerNext(stream, epoch, lie);
      if (request.has_open_stream() || testing::Test::HasFailure()) return request.open_stream();
    }
  }
  v1::Request answerNext(
      const std::string& stream, std::uint64_t epoch, const Lie& lie = [](v1::StreamOpened&) {}) {
    const auto request = control_.receive<v1::Request>();
    v1::Reply reply;
    reply.set_request_id(request.request_id());
    reply.mutable_status()->set_code(v1::CODE_OK);
    if (request.has_list_streams()) reply.mutable_list_streams();  // it knows of none
    if (request.has_server_info()) reply.mutable_server_info()->set_data_endpoint(data_.endpoint());
    if (request.has_open_stream()) {
      v1::StreamOpened& opened = *reply.mutable_open_stream();
      opened.set_stream_id(stream);
      opened.set_epoch(epoch);
      opened.set_frames(20);
      *opened.mutable_resolved() = request.open_stream();
      lie(opened);
    }
    if (!request.has_close_stream()) control_.send(reply);
    return request;
  }
  v1::Attach attached() {
    v1::DataRequest request;
    while (!request.has_attach() && !testing::Test::HasFailure()) request = data_.receive();
    return request.attach();
  }
  void send(const std::vector<Packet>& packets, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i <= last; ++i) data_.send(packets.at(i));
  }

  // The client's part: its batches until END, while the server does `script`.
  void record(const std::function<void()>& script,
              Subscription::RetryPolicy retry_policy = {.retry_time = milliseconds(5000)}) {
    auto server = std::async(std::launch::async, script);
    retry_policy.silence = milliseconds(500);
    ControlClient control(context_, control_.endpoint());
    StreamHandle stream(control, request_);
    Subscription subscription(context_, stream, retry_policy);
    for (bool ended = false; !ended;) {
      const auto batch = subscription.receive(milliseconds(1000));
      if (!batch) continue;
      if (batch->header.kind() == v1::KIND_HEARTBEAT) {
        EXPECT_TRUE(subscription.catchingUp());
        ++heartbeats_;
        continue;
      }
      EXPECT_FALSE(subscription.catchingUp());
      EXPECT_EQ(batch->header.first_event_index(), events_.size() + subscription.losses().events);
      EXPECT_EQ(batch->header.count(), batch->events.size());
      events_.insert(events_.end(), batch->events.begin(), batch->events.end());
      suppressed_ += batch->header.suppressed();
      ended = batch->header.kind() == v1::KIND_END;
    }
    losses_ = subscription.losses();
  }
  std::string faultOf(const std::function<void()>& script,
                      const Subscription::RetryPolicy& retry_policy = {.retry_time = milliseconds(5000)}) {
    try {
      record(script, retry_policy);
    } catch (const std::runtime_error& fault) {
      return fault.what();
    }
    return "no fault";
  }

  zmq::context_t context_;
  FakeServer control_{context_}, data_{context_};
  v1::OpenStream request_ = [] {
    v1::OpenStream request;
    request.set_delivery(v1::DELIVERY_LOSSLESS);
    request.mutable_view()->set_width(346);
    request.mutable_view()->set_height(260);
    request.mutable_timing()->set_frame_rate_hz(1000);
    request.add_sensors()->set_threshold(0.25);
    return request;
  }();
  Events events_;
  Losses losses_;
  std::uint64_t suppressed_ = 0;
  int heartbeats_ = 0;
};

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

TEST_F(SubscriptionTest, RepliesThatCannotBeAreFaults) {
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
    const std::string fault = faultOf([&] { open("s1", 0, lie); });
    EXPECT_NE(fault.find("reply to open_stream cannot be: "), std::string::npos) << text << ": " << fault;
    EXPECT_NE(fault.find(text), std::string::npos) << fault;
  }
}

TEST_F(SubscriptionTest, TruthOfAViewThatIsNotThereIsAFault) {
  request_.add_truth()->set_name("depth");
  const std::string fault = faultOf([&] {
    open("s1", 0, [](v1::StreamOpened& o) { o.mutable_resolved()->mutable_truth(0)->set_view(9); });
  });
  EXPECT_NE(fault.find("truth of view 9 of 1"), std::string::npos) << fault;
}

TEST_F(SubscriptionTest, AnEndpointThatIsNoneIsAFault) {
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
TEST_F(SubscriptionTest, AnOpenWaitsForAServerThatRestarts) {
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

TEST_F(SubscriptionTest, AnOpenDoesNotWaitForASceneThatCannotBeOpened) {
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
