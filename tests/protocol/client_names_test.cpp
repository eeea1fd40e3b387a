// Clients by the names of the server's list: in the metrics, and in the lists of streams.
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "mock/keyed_server.h"
#include "mock/mock_http.h"
#include "mock/wait_until.h"
#include "stream/bounded_peers.h"
#include "stream/endpoint.h"

namespace saccade {
namespace {

class ClientNames : public KeyedServer {
 protected:
  ClientNames() {
    config_.http = "http://127.0.0.1:0";
    std::ofstream(config_.client_keys) << alice_.public_key << " alice\n"
                                       << bob_.public_key << "\n"
                                       << carol_.public_key << " carol admin\n";
    server_process_.emplace(config_, alice_);
  }
  MockClient client(const MockKeys& keys) { return MockClient(app().controlEndpoint(), keys); }
  App& app() { return server_process_->app(); }
  // Replies and packets are counted when they are on their way, so that a client may be faster.
  bool told(const std::string& line) {
    return waitUntil(
        [&] {
          return ("\n" + httpGet(app().httpEndpoint(), "/metrics").body).find("\n" + line + "\n") !=
                 std::string::npos;
        },
        kPatience);
  }
  static v1::StreamList all(MockClient& client) {
    v1::Request request;
    request.mutable_list_streams()->set_all(true);
    return client.call(request).list_streams();
  }
  static v1::Code close(MockClient& client, const std::string& id) {
    v1::StreamOpened stream;
    stream.set_stream_id(id);
    return client.close(stream).code();
  }

  const MockKeys carol_ = makeMockKeys(server_.public_key);
  std::optional<TestServer> server_process_;
};

TEST_F(ClientNames, AreLabelsOfWhatTheyHaveHad) {
  MockClient alice = client(alice_), bob = client(bob_);
  const auto stream = alice.open(tinyRequest());
  bob.open(tinyRequest());
  v1::OpenStream wrong = tinyRequest();
  wrong.set_scene("nowhere");
  for (int i = 0; i < 2; ++i) alice.tryOpen(wrong);
  EXPECT_TRUE(told("saccade_client_streams{client=\"alice\"} 1"));
  EXPECT_TRUE(told("saccade_client_streams{client=\"carol\"} 0"));
  EXPECT_TRUE(told("saccade_client_refused_requests_total{client=\"alice\"} 2"));
  EXPECT_TRUE(told("saccade_client_sent_bytes_total{client=\"alice\"} 0"));
  MockSubscriber subscriber(alice.server().data_endpoint(), alice_);
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  std::size_t bytes = 0;
  const auto packets = subscriber.receiveAll(1);
  for (const auto& packet : packets.at(0)) bytes += packet.bytes;
  EXPECT_TRUE(told("saccade_client_sent_bytes_total{client=\"alice\"} " + std::to_string(bytes)));
  const std::string text = httpGet(app().httpEndpoint(), "/metrics").body;
  EXPECT_EQ(text.find(bob_.public_key.substr(0, 8)), std::string::npos);  // only names of the list
  EXPECT_EQ(text.find("client=\"\""), std::string::npos);
}

TEST_F(ClientNames, RefusedKeysAreCountedButNotThoseOfTheServersProbe) {
  EXPECT_TRUE(told("saccade_refused_keys_total 0"));
  EXPECT_EQ(handshake(app().controlEndpoint(), makeMockKeys(server_.public_key)),
            ZMQ_EVENT_HANDSHAKE_FAILED_AUTH);
  EXPECT_TRUE(told("saccade_refused_keys_total 1"));
}

TEST_F(ClientNames, AnAdminSeesAndClosesWhatOthersMayNot) {
  MockClient alice = client(alice_), bob = client(bob_), carol = client(carol_);
  const std::string hers = alice.open(tinyRequest()).stream_id(), his = bob.open(tinyRequest()).stream_id();
  EXPECT_EQ(all(alice).streams_size(), 1);
  EXPECT_EQ(carol.streams().streams_size(), 0);  // its own
  const v1::StreamList list = all(carol);
  ASSERT_EQ(list.streams_size(), 2);
  for (const auto& stream : list.streams()) {
    EXPECT_EQ(stream.client(), stream.stream_id() == hers ? "alice" : bob_.public_key.substr(0, 8));
    EXPECT_EQ(stream.state(), v1::STREAM_STATE_WAITING);
  }
  EXPECT_EQ(close(alice, his), v1::CODE_PERMISSION_DENIED);
  EXPECT_EQ(close(alice, hers), v1::CODE_OK);
  EXPECT_EQ(close(carol, his), v1::CODE_OK);
  EXPECT_EQ(close(carol, "nothing"), v1::CODE_NOT_FOUND);
}

// Without keys the server cannot tell its clients apart. It trusts all who reach
// loopback with all streams.
TEST_F(ClientNames, WithoutKeysLoopbackAloneClosesWithoutAToken) {
  TestServer open;
  MockClient other(open.app().controlEndpoint());
  EXPECT_EQ(close(other, open.client().open(tinyRequest()).stream_id()), v1::CODE_OK);
  Config config = testConfig();
  config.control = "tcp://0.0.0.0:*";
  config.insecure = true;
  if (!peersAreBounded()) GTEST_SKIP() << "the system's libzmq serves loopback alone";
  App network(config);
  MockClient stranger(reachableHere(network.controlEndpoint()));
  EXPECT_EQ(close(stranger, stranger.open(tinyRequest()).stream_id()), v1::CODE_PERMISSION_DENIED);
}

}  // namespace
}  // namespace saccade
