// Clients that send more than they may: the server neither obeys nor swells.
#include <gtest/gtest.h>

#include "mock/needs_libzmq.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"

namespace saccade {
namespace {

constexpr std::int64_t kMaxGrowthBytes = 20 << 20;

class GreedyClient : public testing::Test {
 protected:
  GreedyClient() {
    client_.close(client_.open(tinyRequest()));  // the scene is loaded, and all threads have run
    before_ = server_.usage();
  }
  ~GreedyClient() override {
    EXPECT_LT(server_.usage().resident_bytes - before_.resident_bytes, kMaxGrowthBytes);
    EXPECT_EQ(client_.server().threads(), 1u);
  }

  // Sends `parts` parts of `bytes` as one message to a ROUTER. Returns the last part of the answer; nothing
  // where the server has cut the connection.
  std::optional<std::string> send(const std::string& endpoint, int parts, std::size_t bytes) {
    zmq::context_t context;
    zmq::socket_t socket(context, zmq::socket_type::dealer), monitor(context, zmq::socket_type::pair);
    socket.set(zmq::sockopt::linger, 0);
    zmq_socket_monitor(socket.handle(), "inproc://greedy", ZMQ_EVENT_DISCONNECTED);
    monitor.connect("inproc://greedy");
    socket.connect(endpoint);
    const std::string part(bytes, 'x');
    for (int left = parts; left > 0; --left) {
      socket.send(zmq::buffer(part), left > 1 ? zmq::send_flags::sndmore : zmq::send_flags::none);
    }
    zmq::pollitem_t items[] = {{socket, 0, ZMQ_POLLIN, 0}, {monitor, 0, ZMQ_POLLIN, 0}};
    zmq::poll(items, 2, kPatience);
    zmq_socket_monitor(socket.handle(), nullptr, 0);
    EXPECT_TRUE(items[0].revents || items[1].revents) << "neither an answer nor the end of the connection";
    if (!items[0].revents) return std::nullopt;
    zmq::message_t answer;
    do {
      if (!socket.recv(answer)) return std::nullopt;
    } while (answer.more());
    return answer.to_string();
  }

  ServerProcess server_;
  MockClient client_{server_.control()};
  Usage before_;
};

TEST_F(GreedyClient, IsCutOffWhereARequestIsTooLarge) {
  EXPECT_FALSE(send(server_.data(), 1, 70 << 10));          // 64 KiB
  EXPECT_FALSE(send(server_.control(), 1, (9 << 20) + 1));  // 9 MiB
}

TEST_F(GreedyClient, IsRefusedWhereARequestHasTwoParts) {
  v1::Reply reply;
  const auto answer = send(server_.control(), 2, 60'000);
  ASSERT_TRUE(answer && reply.ParseFromString(*answer));
  EXPECT_EQ(reply.status().code(), v1::CODE_INVALID_ARGUMENT);
  EXPECT_NE(reply.status().message().find("one part"), std::string::npos);
  EXPECT_NE(send(server_.data(), 2, 60'000).value_or("").find("one part"), std::string::npos);
}

TEST_F(GreedyClient, IsCutOffWhereARequestHasManyParts) {
  NEEDS_PATCHED_LIBZMQ();
  for (const std::string& endpoint : {server_.control(), server_.data()})
    EXPECT_FALSE(send(endpoint, 200, 60'000));
}

// ZeroMQ's own table takes any topic of any length: ours only those of streams.
TEST_F(GreedyClient, MaySubscribeToAnythingAndGetsWhatThereIs) {
  NEEDS_PATCHED_LIBZMQ();
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_BROADCAST);
  const auto stream = client_.open(request);
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::sub);
  socket.set(zmq::sockopt::linger, 0);
  socket.connect(server_.broadcast());
  for (int i = 0; i < 10'000; ++i)
    socket.set(zmq::sockopt::subscribe, "s/" + std::to_string(i) + std::string(200, 'x'));
  MockSubscriber good(server_.broadcast(), stream);
  checkPackets(good.receiveAll(1)[0]);
}

}  // namespace
}  // namespace saccade
