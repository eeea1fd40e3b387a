// Subscribers who come and go.
#include "stream/broadcast_server.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "mock/mock_subscriber.h"

namespace saccade {
namespace {

class Broadcast : public testing::Test {
 protected:
  Broadcast() {
    sessions_.add(session_);
    server_.start();
  }
  ~Broadcast() override { server_.stop(); }

  MockSubscriber subscribe() {
    v1::StreamOpened stream;
    for (std::uint32_t sensor : {0u, 1u}) stream.add_topics(session_->topic(sensor));
    return {server_.endpoint(), stream};
  }
  SessionDirectory sessions_;
  Traffic traffic_;
  BroadcastServer server_{"tcp://127.0.0.1:*", sessions_};
  std::shared_ptr<Signal> signal_ = std::make_shared<Signal>();
  std::shared_ptr<Session> session_ =
      std::make_shared<Session>("b", v1::DELIVERY_BROADCAST, 2, server_.wake(), signal_, traffic_);
};

TEST_F(Broadcast, TellsHowFarItIsWhenThereIsNothingToSend) {
  MockSubscriber subscriber = subscribe();
  session_->setProgress(9, 18'000'000);
  std::set<std::string> topics;
  while (topics.size() < 2) {
    const auto packet = subscriber.receiveAny();
    ASSERT_TRUE(packet);
    EXPECT_EQ(packet->header.kind(), v1::KIND_HEARTBEAT);
    EXPECT_EQ(packet->header.frame(), 9u);
    EXPECT_EQ(packet->header.t0_ns(), 18'000'000);
    EXPECT_EQ(packet->topic, session_->topic(packet->header.sensor()));
    topics.insert(packet->topic);
  }
}

// A topic taken off, or a subscriber gone, is not the end of the others.
TEST_F(Broadcast, SubscribersComeAndGo) {
  v1::StreamOpened one;
  one.add_topics(session_->topic(1));
  std::optional<MockSubscriber> first(subscribe());
  ASSERT_TRUE(first->receiveAny());
  MockSubscriber second(server_.endpoint(), one);
  ASSERT_TRUE(second.receiveAny());
  first.reset();
  ASSERT_TRUE(second.receiveAny());
  MockSubscriber third = subscribe();
  ASSERT_TRUE(third.receiveAny());
  ASSERT_TRUE(second.receiveAny());
}

}  // namespace
}  // namespace saccade
