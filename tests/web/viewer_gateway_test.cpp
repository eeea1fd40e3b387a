// Viewers that come and go, over the HTTP server; there is no saccaded behind them.
#include "web/viewer_gateway.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "mock/loopback.h"
#include "mock/wait_until.h"
#include "ops/http_server.h"
#include "web/socket_pair.h"

namespace saccade {
namespace {

using std::chrono::seconds;

ViewerSettings settings() {
  return {.control = "tcp://127.0.0.1:1",
          .source = {.data = "tcp://127.0.0.1:1", .broadcast = "tcp://127.0.0.1:1", .keys = {}},
          .max_viewers = 3};
}

class ViewerGatewayTest : public testing::Test {
 protected:
  ~ViewerGatewayTest() override {
    gateway_.stop();  // before the server, whose sockets it has
    for (const int page : pages_) close(page);
  }
  // Sends a handshake, with more bytes after it.
  int connect(const std::string& more = {}, const std::string& headers = {}) {
    const int page = connectLoopback(portOf(server_.endpoint()));
    const std::string host = server_.endpoint().substr(7);
    const std::string handshake = "GET /viewer HTTP/1.1\r\nHost: " + host + "\r\nOrigin: http://" + host +
                                  "\r\n" + headers +
                                  "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                                  "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n" +
                                  more;
    send(page, handshake.data(), handshake.size(), MSG_NOSIGNAL);
    pages_.push_back(page);
    return page;
  }
  // The output to a page until its connection ends.
  static std::string readAll(int page) {
    std::string all;
    char buffer[4096];
    for (ssize_t n; (n = recv(page, buffer, sizeof buffer, 0)) > 0;)
      all.append(buffer, static_cast<std::size_t>(n));
    return all;
  }
  bool seated(std::size_t viewers) {
    return waitUntil([&] { return gateway_.viewers() == viewers; }, seconds(5));
  }

  ViewerGateway gateway_{settings()};
  HttpServer server_{"http://127.0.0.1:0", {}, {{ViewerGateway::kPath, gateway_.upgrade()}}};
  std::vector<int> pages_;
};

TEST_F(ViewerGatewayTest, StopTellsAllViewersAndClosesThem) {
  const std::vector<int> pages{connect(), connect(), connect()};
  ASSERT_TRUE(seated(3));
  gateway_.stop();
  for (const int page : pages) {
    const std::string received = readAll(page);
    EXPECT_TRUE(received.starts_with("HTTP/1.1 101 ")) << received;
    EXPECT_NE(received.find("\x03\xe9the server stops"), std::string::npos) << received;  // 1001
  }
  const std::string late = readAll(connect());
  EXPECT_EQ(late.substr(late.find("\r\n\r\n")), "\r\n\r\n");
}

TEST_F(ViewerGatewayTest, AnswersWhereNoServerIsBehindIt) {
  const int page = connect();
  ASSERT_TRUE(seated(1));
  const std::string nonsense = clientFrame('\x81', "{}");
  send(page, nonsense.data(), nonsense.size(), MSG_NOSIGNAL);
  std::string received;
  char byte;
  while (received.find("CODE_INVALID_ARGUMENT") == std::string::npos && recv(page, &byte, 1, 0) == 1)
    received += byte;
  EXPECT_NE(received.find("CODE_INVALID_ARGUMENT"), std::string::npos) << received;
  shutdown(page, SHUT_RDWR);
  EXPECT_TRUE(seated(0));
}

TEST_F(ViewerGatewayTest, SeatsAreGivenAgain) {
  for (int again = 0; again < 20; ++again) {
    const int page = connect();
    ASSERT_TRUE(seated(1));
    shutdown(page, SHUT_RDWR);
    ASSERT_TRUE(seated(0));
  }
}

TEST_F(ViewerGatewayTest, ManyAtOnceTakeNoMoreSeatsThanThereAre) {
  std::vector<int> pages;
  for (int i = 0; i < 10; ++i) pages.push_back(connect());
  ASSERT_TRUE(seated(3));
  gateway_.stop();
  int told = 0;
  for (const int page : pages) told += readAll(page).find("the server stops") != std::string::npos;
  EXPECT_EQ(told, 3);
}

// The HTTP server cuts off the oldest of too many clients; a viewer is none.
TEST_F(ViewerGatewayTest, ACrowdOfClientsCutsOffNoViewer) {
  const int page = connect();
  ASSERT_TRUE(seated(1));
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const rlimit few{128, before.rlim_max};
  setrlimit(RLIMIT_NOFILE, &few);  // a quarter: 32 clients
  for (int i = 0; i < 33; ++i) pages_.push_back(connectLoopback(portOf(server_.endpoint())));
  char byte;
  EXPECT_EQ(recv(pages_[1], &byte, 1, 0), 0);  // the oldest client
  setrlimit(RLIMIT_NOFILE, &before);
  const std::string ping = clientFrame('\x89', "still here");
  send(page, ping.data(), ping.size(), MSG_NOSIGNAL);
  std::string received;
  while (received.find("still here") == std::string::npos && recv(page, &byte, 1, 0) == 1) received += byte;
  EXPECT_NE(received.find("still here"), std::string::npos);
}

TEST_F(ViewerGatewayTest, BytesBeforeTheAnswerEndTheConnection) {
  EXPECT_EQ(readAll(connect("x", "Content-Length: 1\r\n")).find("HTTP/1.1 101"), std::string::npos);
  readAll(connect(clientFrame('\x81', "{}")));
  EXPECT_TRUE(seated(0));
}

}  // namespace
}  // namespace saccade
