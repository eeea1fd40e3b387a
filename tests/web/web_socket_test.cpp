#include "web/web_socket.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <vector>

#include "web/socket_pair.h"

namespace saccade {
namespace {

constexpr char kText = '\x81', kBinary = '\x82', kClose = '\x88', kPing = '\x89';

class WebSocketTest : public testing::Test {
 protected:
  SocketPair pair_;
  std::vector<std::string> texts_;
  WebSocket socket_{pair_.server(), [this](std::string_view text) { texts_.emplace_back(text); }};
};

TEST_F(WebSocketTest, ReadsTextsWhole) {
  const std::string frame = clientFrame(kText, "hello");
  pair_.send(frame.substr(0, 7));
  EXPECT_TRUE(socket_.exchange());
  EXPECT_TRUE(texts_.empty());
  pair_.send(frame.substr(7) + clientFrame('\x01', "two ") + clientFrame('\x80', "parts"));
  EXPECT_TRUE(socket_.exchange());
  EXPECT_EQ(texts_, (std::vector<std::string>{"hello", "two parts"}));
}

TEST_F(WebSocketTest, WritesFramesOfBothKinds) {  // [RFC 6455, section 5.7]
  socket_.sendText("Hello");
  socket_.sendBinary(std::string(256, 'x'));
  EXPECT_TRUE(socket_.exchange());
  EXPECT_EQ(pair_.received(), "\x81\x05Hello\x82\x7e" + std::string("\x01\x00", 2) + std::string(256, 'x'));
  EXPECT_EQ(socket_.queuedBytes(), 0u);
}

TEST_F(WebSocketTest, AnswersPings) {
  pair_.send(clientFrame(kPing, "a"));
  EXPECT_TRUE(socket_.exchange());
  EXPECT_EQ(pair_.received(),
            "\x8a\x01"
            "a");
}

TEST_F(WebSocketTest, ReadsNothingWhileItsQueueIsFull) {
  while (!socket_.full()) socket_.sendBinary(std::string(64 << 10, 'x'));
  EXPECT_TRUE(socket_.exchange());
  pair_.send(clientFrame(kText, "later"));
  EXPECT_TRUE(socket_.exchange());
  EXPECT_EQ(socket_.events() & POLLIN, socket_.full() ? 0 : POLLIN);
  EXPECT_EQ(texts_.empty(), socket_.full());
  while (socket_.queuedBytes() > 0) {
    EXPECT_FALSE(pair_.received().empty());
    EXPECT_TRUE(socket_.exchange());
  }
  EXPECT_TRUE(socket_.exchange());
  EXPECT_EQ(texts_, std::vector<std::string>{"later"});
}

TEST_F(WebSocketTest, EndsAtWhatIsNoText) {
  pair_.send(clientFrame(kBinary, "x"));
  EXPECT_FALSE(socket_.exchange());
  EXPECT_EQ(pair_.received().substr(0, 4), std::string("\x88\x13\x03\xeb", 4));  // 1003
}

TEST_F(WebSocketTest, EndsWithItsPeer) {
  pair_.send(clientFrame(kClose, ""));
  EXPECT_FALSE(socket_.exchange());
  EXPECT_EQ(pair_.received().at(0), kClose);
}

TEST_F(WebSocketTest, EndsWhereThePeerIsGone) {
  shutdown(pair_.client(), SHUT_RDWR);
  EXPECT_FALSE(socket_.exchange());
}

}  // namespace
}  // namespace saccade
