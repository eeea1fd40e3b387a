// A server with keys: who comes in, who is turned away, and what one client sees of another.
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "mock/keyed_server.h"
#include "mock/needs_libzmq.h"

namespace saccade {
namespace {

TEST_F(KeyedServer, ServesAllSocketsToAListedKey) {
  NEEDS_PATCHED_LIBZMQ();
  TestServer server(config_, alice_);
  v1::OpenStream request = tinyRequest();
  const auto info = server.client().server();
  for (const auto delivery : {v1::DELIVERY_LOSSLESS, v1::DELIVERY_BROADCAST}) {
    request.set_delivery(delivery);
    const auto stream = server.client().open(request);
    MockSubscriber subscriber = delivery == v1::DELIVERY_BROADCAST
                                    ? MockSubscriber(info.broadcast_endpoint(), stream, alice_)
                                    : MockSubscriber(info.data_endpoint(), alice_);
    if (delivery != v1::DELIVERY_BROADCAST) {
      subscriber.attach(stream);
      subscriber.giveCredit(1 << 20);
    }
    checkPackets(subscriber.receiveAll(1)[0]);
  }
}

TEST_F(KeyedServer, TurnsAllOthersAwayOnEverySocket) {
  NEEDS_PATCHED_LIBZMQ();
  TestServer server(config_, alice_);
  const auto info = server.client().server();
  const auto dealer = zmq::socket_type::dealer, sub = zmq::socket_type::sub;
  const MockKeys stranger = makeMockKeys(server_.public_key);
  for (const auto& [endpoint, type] : {std::pair(server.app().controlEndpoint(), dealer),
                                       {info.data_endpoint(), dealer},
                                       {info.broadcast_endpoint(), sub}}) {
    EXPECT_EQ(handshake(endpoint, alice_, 10000, type), ZMQ_EVENT_HANDSHAKE_SUCCEEDED);
    EXPECT_EQ(handshake(endpoint, stranger, 10000, type), ZMQ_EVENT_HANDSHAKE_FAILED_AUTH);
    EXPECT_NE(handshake(endpoint, {}, 200, type), ZMQ_EVENT_HANDSHAKE_SUCCEEDED);
  }
}

TEST_F(KeyedServer, AClientSeesItsOwnStreamsOnly) {
  TestServer server(config_, alice_);
  MockClient& alice = server.client();
  MockClient bob(server.app().controlEndpoint(), bob_);
  const auto stream = alice.open(tinyRequest());
  EXPECT_EQ(seen(alice), std::vector{stream.stream_id()});
  EXPECT_EQ(seen(bob), std::vector<std::string>{});

  auto forged = stream;
  forged.set_token(bob.open(tinyRequest()).token());
  EXPECT_EQ(bob.close(forged).code(), v1::CODE_PERMISSION_DENIED);
  MockSubscriber thief(alice.server().data_endpoint(), bob_);
  thief.attach(forged);
  const auto refused = thief.receive();
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->header.kind(), v1::KIND_ERROR);
  thief.acknowledge(0, 5);  // of no stream, since it is attached to none
  EXPECT_EQ(thief.receive()->header.kind(), v1::KIND_ERROR);

  MockSubscriber owner(alice.server().data_endpoint(), alice_);
  owner.attach(stream);
  owner.giveCredit(1 << 20);
  checkPackets(owner.receiveAll(1)[0]);
}

TEST_F(KeyedServer, ReadsItsListAgain) {
  TestServer server(config_, alice_);
  const std::string endpoint = server.app().controlEndpoint();
  MockClient bob(endpoint, bob_);
  EXPECT_EQ(bob.server().threads(), 1u);
  const MockKeys carol = makeMockKeys(server_.public_key);
  allow({alice_, carol});
  server.app().reloadKeys();
  EXPECT_EQ(MockClient(endpoint, carol).server().threads(), 1u);
  EXPECT_EQ(handshake(endpoint, bob_), ZMQ_EVENT_HANDSHAKE_FAILED_AUTH);
  v1::Request info;  // his connection stands, and is told
  info.mutable_server_info();
  const v1::Reply reply = bob.call(info);
  EXPECT_EQ(reply.status().code(), v1::CODE_PERMISSION_DENIED);
  EXPECT_EQ(reply.status().message(), kRevokedKey);
  EXPECT_FALSE(reply.has_server_info());

  std::ofstream(config_.client_keys) << "nonsense\n";
  server.app().reloadKeys();
  EXPECT_EQ(MockClient(endpoint, carol).server().threads(), 1u);
}

// However much credit it has given.
TEST_F(KeyedServer, AKeyThatIsTakenOffTheListGetsNoPacketMore) {
  TestServer server(config_, alice_);
  MockClient bob(server.app().controlEndpoint(), bob_);
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  const auto stream = bob.open(request);
  MockSubscriber subscriber(bob.server().data_endpoint(), bob_);
  subscriber.attach(stream);
  subscriber.giveCredit(std::uint64_t{1} << 30);
  ASSERT_TRUE(subscriber.receive());
  allow({alice_});
  server.app().reloadKeys();
  const auto deadline = ChangeNotifier::Clock::now() + kPatience;
  std::optional<Received> last;
  while (auto packet = subscriber.receive(std::chrono::milliseconds(500))) {
    ASSERT_LT(ChangeNotifier::Clock::now(), deadline);
    last = std::move(packet);
  }
  ASSERT_TRUE(last);
  EXPECT_EQ(last->header.kind(), v1::KIND_ERROR);
  EXPECT_EQ(last->payload, kRevokedKey);
}

TEST_F(KeyedServer, AnOpenAddressWantsKeysOrAWord) {
  NEEDS_PATCHED_LIBZMQ();
  Config open = testConfig();
  open.data = "tcp://0.0.0.0:*";
  EXPECT_THROW(App{open}, std::runtime_error);
  open.insecure = true;
  EXPECT_NO_THROW(App{open});
  open = config_;
  open.control = "tcp://0.0.0.0:*";
  EXPECT_NO_THROW(App{open});
  open.insecure = true;
  EXPECT_THROW(App{open}, std::runtime_error);
  config_.client_keys.clear();
  EXPECT_THROW(App{config_}, std::runtime_error);
}

}  // namespace
}  // namespace saccade
