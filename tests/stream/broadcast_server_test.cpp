// Subscribers who come and go.
#include "stream/broadcast_server.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>

#include "mock/mock_subscriber.h"
#include "mock/needs_libzmq.h"
#include "mock/zmtp_peer.h"

namespace saccade {
namespace {

class Broadcast : public testing::Test {
 protected:
  void SetUp() override { NEEDS_PATCHED_LIBZMQ(); }
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
  // A peer that has asked for an unknown topic hears this while the others hear heartbeats.
  std::string spyHears(ZmtpPeer& spy) {
    MockSubscriber other = subscribe();
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(other.receiveAny());
    spy.say(zmtp::command("PING", std::string(2, '\0')));
    const std::string pong = zmtp::command("PONG", {});
    std::string heard = spy.hear(pong.size());
    const auto ping = zmtp::command("PING", std::string(2, '\0'));  // the server asks, too
    return heard == pong || heard == ping.substr(0, pong.size()) ? "" : heard;
  }

  SessionDirectory sessions_;
  Traffic traffic_;
  BroadcastServer server_{"tcp://127.0.0.1:*", sessions_};
  std::shared_ptr<ChangeNotifier> notifier_ = std::make_shared<ChangeNotifier>();
  std::shared_ptr<Session> session_ =
      std::make_shared<Session>("b", v1::DELIVERY_BROADCAST, 2, server_.wake(), notifier_, traffic_);
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

std::string subscription(const std::string& topic, bool wanted = true) {
  return zmtp::part((wanted ? "\1" : std::string(1, '\0')) + topic);
}

// A subscription that waited behind messages of others was applied to the peer that subscribed after it.
TEST_F(Broadcast, MessagesOfOthersMoveNoSubscription) {
  std::vector<ZmtpPeer> flooders;
  for (int i = 0; i < 40; ++i) flooders.emplace_back(server_.endpoint(), "XSUB");
  ZmtpPeer victim(server_.endpoint(), "SUB"), spy(server_.endpoint(), "SUB");
  std::string junk, other;
  for (int i = 0; i < 1000; ++i) junk += zmtp::part("\2");
  for (int i = 0; i < 1000; ++i) other += subscription("g" + std::to_string(i));
  for (auto& flooder : flooders) flooder.say(junk);
  victim.say(subscription(session_->topic(0)));
  spy.say(other);
  const std::string topic = zmtp::part(session_->topic(0), true);
  EXPECT_EQ(victim.hear(topic.size()), topic);
  EXPECT_EQ(spyHears(spy), "");
}

TEST_F(Broadcast, OnlyWholeTopicsAreServed) {
  MockSubscriber subscriber = subscribe();
  ZmtpPeer spy(server_.endpoint(), "SUB");
  for (const char* topic : {"", "s", "s/", "s/b", "s/b/", "s/b/0", "s/b/2/", "s//0/", "s/b/0/x"})
    spy.say(subscription(topic));
  ASSERT_TRUE(subscriber.receiveAny());
  EXPECT_EQ(spyHears(spy), "");
}

TEST_F(Broadcast, NobodyUnsubscribesAnother) {
  MockSubscriber subscriber = subscribe();
  ASSERT_TRUE(subscriber.receiveAny());
  ZmtpPeer stranger(server_.endpoint(), "SUB");
  for (int i = 0; i < 3; ++i)
    stranger.say(subscription(session_->topic(0), false) + subscription(session_->topic(1), false));
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(subscriber.receiveAny());  // two heartbeats of each topic
  EXPECT_FALSE(session_->unattended());
}

// A peer that subscribes twice is gone when it goes.
TEST_F(Broadcast, TheEndOfAConnectionEndsAllOfItsSubscriptions) {
  {
    ZmtpPeer twice(server_.endpoint(), "SUB");
    for (int i = 0; i < 2; ++i)
      twice.say(subscription(session_->topic(0)) + subscription(session_->topic(1)));
    ASSERT_TRUE(
        notifier_->waitUntil(ChangeNotifier::Clock::now() + kPatience, [&] { return session_->started(); }));
    ASSERT_FALSE(session_->unattended());
  }
  EXPECT_TRUE(notifier_->waitUntil(ChangeNotifier::Clock::now() + kPatience,
                                   [&] { return session_->unattended().has_value(); }));
}

}  // namespace
}  // namespace saccade
