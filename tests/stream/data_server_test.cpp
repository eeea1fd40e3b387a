// Receivers that go without a word.
#include "stream/data_server.h"

#include <gtest/gtest.h>

#include <csignal>

#include "mock/mock_subscriber.h"
#include "mock/remote_subscriber.h"

namespace saccade {
namespace {

constexpr std::int64_t kMaxCredit = 1 << 20;

class LostReceiver : public testing::TestWithParam<int> {
 protected:
  LostReceiver() { server_.start(); }
  ~LostReceiver() override { server_.stop(); }

  std::shared_ptr<Session> add(const std::string& id) {
    auto session =
        std::make_shared<Session>(id, v1::DELIVERY_LOSSLESS, 1, server_.wake(), notifier_, traffic_);
    sessions_.add(session);
    return session;
  }
  static v1::StreamOpened opened(const Session& session) {
    v1::StreamOpened stream;
    stream.set_stream_id(session.id());
    stream.set_token(session.token());
    return stream;
  }
  static void push(Session& session, std::uint64_t seq) {
    v1::PacketHeader header;
    header.set_stream_id(session.id());
    header.set_seq(seq);
    header.set_kind(v1::KIND_EVENTS);
    session.push(sealPacket(std::move(header), {}));
  }

  RemoteSubscriber remote_;  // before the server's threads
  SessionDirectory sessions_;
  Traffic traffic_;
  DataServer server_{"tcp://127.0.0.1:*", sessions_, kMaxCredit};
  std::shared_ptr<ChangeNotifier> notifier_ = std::make_shared<ChangeNotifier>();
};

// One that stands still keeps its connection open: only heartbeats tell.
TEST_P(LostReceiver, IsNoticedAndDisturbsNoOther) {
  const auto lost = add("lost"), other = add("other");
  for (std::uint64_t seq : {0, 1}) push(*lost, seq);
  remote_.attach(server_.endpoint(), opened(*lost), 1);  // enough for one packet
  MockSubscriber subscriber(server_.endpoint());
  subscriber.attach(opened(*other));
  subscriber.giveCredit(1 << 20);
  lost->finish();
  ASSERT_FALSE(lost->settled());  // its receiver may still give credit

  remote_.signal(GetParam());
  for (std::uint64_t seq = 0; seq < 100; ++seq) {
    push(*other, seq);
    const auto packet = subscriber.receive();
    ASSERT_TRUE(packet);
    EXPECT_EQ(packet->header.seq(), seq);
  }
  EXPECT_TRUE(
      notifier_->waitUntil(ChangeNotifier::Clock::now() + kPatience, [&] { return lost->settled(); }));
  EXPECT_FALSE(lost->drained());
}

INSTANTIATE_TEST_SUITE_P(Killed, LostReceiver, testing::Values(SIGKILL));
INSTANTIATE_TEST_SUITE_P(Stopped, LostReceiver, testing::Values(SIGSTOP));

// A client that has attached to a stream which sends nothing.
class QuietStream : public testing::Test {
 protected:
  QuietStream() {
    sessions_.add(session_);
    session_->setProgress(9, 18'000'000);
    server_.start();
    v1::StreamOpened stream;
    stream.set_stream_id(session_->id());
    stream.set_token(session_->token());
    subscriber_.attach(stream);
  }
  ~QuietStream() override { server_.stop(); }

  SessionDirectory sessions_;
  Traffic traffic_;
  DataServer server_{"tcp://127.0.0.1:*", sessions_, kMaxCredit};
  std::shared_ptr<Session> session_ = std::make_shared<Session>("a", v1::DELIVERY_LOSSLESS, 1, server_.wake(),
                                                                std::make_shared<ChangeNotifier>(), traffic_);
  MockSubscriber subscriber_{server_.endpoint()};
};

// Rendering again what a client already has sends nothing for a long time.
TEST_F(QuietStream, TellsHowFarItIsWhenThereIsNothingToSend) {
  for (int i = 0; i < 2; ++i) {
    const auto packet = subscriber_.receiveAny();
    ASSERT_TRUE(packet);
    EXPECT_EQ(packet->header.kind(), v1::KIND_HEARTBEAT);
    EXPECT_EQ(packet->header.frame(), 9u);
    EXPECT_EQ(packet->header.t0_ns(), 18'000'000);
  }
}

TEST_F(QuietStream, NamesTheLimitOfCredit) {
  subscriber_.giveCredit(kMaxCredit);
  for (const std::uint64_t more : {std::uint64_t{1}, ~std::uint64_t{0}}) {
    subscriber_.giveCredit(more);
    const auto refused = subscriber_.receive();
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->header.kind(), v1::KIND_ERROR);
    EXPECT_NE(refused->payload.find("limit credit"), std::string::npos) << refused->payload;
  }
}

TEST(DataServer, StatesItsEndpointAsItWasAskedFor) {
  SessionDirectory none;
  EXPECT_EQ(DataServer("tcp://127.0.0.1:*", none, kMaxCredit).endpoint().find("tcp://127.0.0.1:"), 0u);
}

}  // namespace
}  // namespace saccade
