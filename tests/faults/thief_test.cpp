// Peers that want what is another's: its place on the data socket, or what it is sent.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "mock/fault_proxy.h"
#include "mock/needs_libzmq.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

using std::chrono::milliseconds;

// A DEALER that says who it is.
class NamedPeer {
 public:
  NamedPeer(const std::string& endpoint, const std::string& name)
      : socket_(context_, zmq::socket_type::dealer) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::routing_id, name);
    socket_.set(zmq::sockopt::rcvtimeo, static_cast<int>(kPatience.count()));
    socket_.connect(endpoint);
  }
  void send(const v1::Request& request) { socket_.send(zmq::buffer(request.SerializeAsString())); }
  v1::Reply call(const v1::Request& request) {
    send(request);
    zmq::message_t part;
    v1::Reply reply;
    EXPECT_TRUE(socket_.recv(part) && reply.ParseFromString(part.to_string()));
    return reply;
  }
  void say(const v1::DataRequest& request) { socket_.send(zmq::buffer(request.SerializeAsString())); }
  std::optional<v1::PacketHeader> receive(milliseconds limit) {
    socket_.set(zmq::sockopt::rcvtimeo, static_cast<int>(limit.count()));
    zmq::message_t head, payload;
    v1::PacketHeader header;
    if (!socket_.recv(head) || !header.ParseFromString(head.to_string()) || !socket_.recv(payload)) return {};
    return header;
  }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

v1::DataRequest attachTo(const v1::StreamOpened& stream) {
  v1::DataRequest request;
  request.mutable_attach()->set_stream_id(stream.stream_id());
  request.mutable_attach()->set_token(stream.token());
  return request;
}

v1::DataRequest credit(std::uint64_t bytes) {
  v1::DataRequest request;
  request.mutable_credit()->set_bytes(bytes);
  return request;
}

// The next peer under the name of one who has gone would have its stream, without its token. So a name that a
// peer gives itself means nothing.
TEST(Thief, CannotTakeTheNameOfAnother) {
  NEEDS_PATCHED_LIBZMQ();
  TestServer server;
  const std::string endpoint = server.client().server().data_endpoint();
  const auto stream = server.client().open(tinyRequest());
  auto victim = std::make_unique<NamedPeer>(endpoint, "alice");
  victim->say(attachTo(stream));
  victim->say(credit(1));
  const auto first = victim->receive(kPatience);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind(), v1::KIND_EVENTS);
  NamedPeer beside(endpoint, "alice");
  victim.reset();
  NamedPeer after(endpoint, "alice");
  for (NamedPeer* thief : {&beside, &after}) {
    thief->say(credit(1 << 20));
    const auto refusal = thief->receive(kPatience);
    ASSERT_TRUE(refusal);
    EXPECT_EQ(refusal->kind(), v1::KIND_ERROR);
    EXPECT_FALSE(thief->receive(milliseconds(200)));
  }
  MockSubscriber owner = server.dataSubscriber();
  owner.attach(stream);
  owner.giveCredit(1 << 20);
  checkPackets(owner.receiveAll(1)[0]);
}

// A reply may come late, and holds the token.
TEST(Thief, CannotWaitForTheReplyOfAnother) {
  NEEDS_PATCHED_LIBZMQ();
  TestServer server;
  v1::Request request;
  request.set_protocol_version(1);
  *request.mutable_open_stream() = tinyRequest();
  {
    NamedPeer victim(server.app().controlEndpoint(), "alice");
    victim.send(request);
  }
  NamedPeer thief(server.app().controlEndpoint(), "alice");
  v1::Request info;
  info.set_protocol_version(1);
  info.mutable_server_info();
  EXPECT_TRUE(thief.call(info).has_server_info());
  EXPECT_FALSE(thief.receive(milliseconds(200)));
}

// Opens a stream and receives it through proxies. Returns all that an eavesdropper has seen.
class Eavesdropper : public testing::Test {
 protected:
  ~Eavesdropper() override { std::filesystem::remove_all(folder_); }

  std::string listen(const Config& config, const MockKeys& keys) {
    TestServer server(config, keys);
    FaultProxy control(server.app().controlEndpoint()), data(server.client().server().data_endpoint()),
        broadcast(server.client().server().broadcast_endpoint());
    MockClient client(control.endpoint(), keys);
    v1::OpenStream request = tinyRequest();
    for (const v1::Delivery delivery : {v1::DELIVERY_LOSSLESS, v1::DELIVERY_BROADCAST}) {
      request.set_delivery(delivery);
      const auto stream = client.open(request);
      secrets_.insert(secrets_.end(), {request.scene(), stream.stream_id(), stream.token()});
      const bool on_data = delivery == v1::DELIVERY_LOSSLESS;
      MockSubscriber subscriber = on_data ? MockSubscriber(data.endpoint(), keys)
                                          : MockSubscriber(broadcast.endpoint(), stream, keys);
      if (on_data) subscriber.attach(stream);
      if (on_data) subscriber.giveCredit(1 << 20);
      const auto packets = subscriber.receiveAll(1)[0];
      checkPackets(packets);
      for (const auto& packet : packets) {
        if (packet.header.count() >= 10) secrets_.push_back(packet.payload);
      }
    }
    return control.seen() + data.seen() + broadcast.seen();
  }
  std::size_t told(const std::string& seen) const {
    return std::count_if(secrets_.begin(), secrets_.end(),
                         [&](const auto& secret) { return seen.find(secret) != std::string::npos; });
  }

  std::vector<std::string> secrets_;
  const std::string folder_ = testing::TempDir() + "thief_test_" + std::to_string(getpid());
};

TEST_F(Eavesdropper, ReadsAllWithoutKeys) {
  NEEDS_PATCHED_LIBZMQ();
  const std::string seen = listen(testConfig(), {});
  ASSERT_GT(secrets_.size(), 10u);
  EXPECT_EQ(told(seen), secrets_.size());
}

TEST_F(Eavesdropper, ReadsNothingWithKeys) {
  NEEDS_PATCHED_LIBZMQ();
  const MockKeys own = makeMockKeys(), client = makeMockKeys(own.public_key);
  std::filesystem::create_directories(folder_);
  Config config = testConfig();
  std::ofstream(config.secret_key = folder_ + "/server.key") << own.secret;
  std::ofstream(config.client_keys = folder_ + "/clients") << client.public_key;
  const std::string seen = listen(config, client);
  ASSERT_GT(secrets_.size(), 10u);
  std::size_t bytes = 0;
  for (const auto& secret : secrets_) bytes += secret.size();
  EXPECT_GT(seen.size(), bytes);
  EXPECT_EQ(told(seen), 0u);
}

}  // namespace
}  // namespace saccade
