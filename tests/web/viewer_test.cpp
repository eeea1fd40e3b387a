// One page and its sockets, of which a test holds the other ends.
#include "web/viewer.h"

#include <gtest/gtest.h>

#include <thread>

#include "mock/fault_proxy.h"
#include "mock/mock_client.h"
#include "mock/wait_until.h"
#include "web/socket_pair.h"

namespace saccade {
namespace {

// A socket of a server, and the way to it, which can be cut.
struct End {
  explicit End(zmq::context_t& context) : socket(context, zmq::socket_type::router), proxy(bind(socket)) {}
  static std::string bind(zmq::socket_t& socket) {
    socket.set(zmq::sockopt::linger, 0);
    socket.set(zmq::sockopt::rcvtimeo, static_cast<int>(kPatience.count()));
    socket.bind("tcp://127.0.0.1:*");
    return socket.get(zmq::sockopt::last_endpoint);
  }
  bool hears() {
    zmq::message_t part;
    return socket.recv(part).has_value();
  }

  zmq::socket_t socket;
  FaultProxy proxy;
};

class ViewerTest : public testing::Test {
 protected:
  ~ViewerTest() override { leave(); }
  void say(const std::string& text) const { page_.send(clientFrame('\x81', text)); }
  void leave() {
    shutdown(page_.client(), SHUT_WR);
    if (thread_.joinable()) thread_.join();
  }
  // The output to the page when the viewer has ended by itself.
  std::string lastWords() {
    thread_.join();
    return page_.received();
  }

  zmq::context_t context_;
  End control_{context_}, data_{context_};
  const ViewerStream::Source source_{
      .data = data_.proxy.endpoint(), .broadcast = data_.proxy.endpoint(), .keys = {}};
  const SocketPair page_;
  std::jthread thread_{[this](std::stop_token stopped) {
    Viewer(page_.server(), context_, control_.proxy.endpoint(), source_).run(std::move(stopped));
  }};
};

constexpr const char* kLost = "\x03\xf3the viewer's connection to the server was lost";  // 1011

// libzmq connects again, but nobody attached again: the page waited for ever, untold.
TEST_F(ViewerTest, SaysThatTheConnectionOfAStreamIsLost) {
  say(R"({"attach":{"streamId":"a","token":"b"}})");
  ASSERT_TRUE(data_.hears());
  data_.proxy.resetAll();
  EXPECT_NE(lastWords().find(kLost), std::string::npos);
}

TEST_F(ViewerTest, SaysThatTheConnectionForRequestsIsLost) {
  say(R"({"request":{"requestId":"1","protocolVersion":1,"serverInfo":{}}})");
  ASSERT_TRUE(control_.hears());
  control_.proxy.resetAll();
  EXPECT_NE(lastWords().find(kLost), std::string::npos);
}

// All pages are one client, which might close the streams of each other by their ids.
TEST_F(ViewerTest, ClosesNoStreamWithoutItsToken) {
  say(R"({"request":{"requestId":"1","protocolVersion":1,"closeStream":{"streamId":"a"}}})");
  std::string received;
  ASSERT_TRUE(waitUntil(
      [&] {
        received += page_.received();
        return received.find("CODE_PERMISSION_DENIED") != std::string::npos;
      },
      kPatience));
  say(R"({"request":{"requestId":"2","protocolVersion":1,"serverInfo":{}}})");
  zmq::message_t peer, request;
  ASSERT_TRUE(control_.socket.recv(peer) && control_.socket.recv(request));
  v1::Request heard;
  EXPECT_TRUE(heard.ParseFromString(request.to_string()) && heard.has_server_info());
}

// Each join takes a socket, which closes later: a page that joined without pause took all that there are.
TEST_F(ViewerTest, RefusesJoinsWithoutPause) {
  constexpr std::size_t kJoins = 200;
  const auto began = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < kJoins; ++i) say(R"({"subscribe":{"streamId":"a"}})");
  say("{}");  // the answer to it is the last
  std::string received;
  ASSERT_TRUE(waitUntil(
      [&] {
        received += page_.received();
        return received.find("CODE_INVALID_ARGUMENT") != std::string::npos;
      },
      kPatience));
  std::size_t refused = 0;
  for (std::size_t at = 0; (at = received.find("CODE_RESOURCE_EXHAUSTED", at)) != std::string::npos; ++at)
    ++refused;
  const auto pauses = (std::chrono::steady_clock::now() - began) / Viewer::kJoinPause;
  EXPECT_LE(kJoins - refused, Viewer::kMaxStreams + static_cast<std::size_t>(pauses) + 1);
  EXPECT_GE(kJoins - refused, Viewer::kMaxStreams);
}

}  // namespace
}  // namespace saccade
