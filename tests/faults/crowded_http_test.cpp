// Four hundred HTTP clients of bad manners: who asks whether we are well gets an answer before he takes us
// for dead.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "mock/loopback.h"
#include "mock/mock_http.h"
#include "mock/server_process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

using Clock = std::chrono::steady_clock;

// Each of them says `greeting`, then `more` again and again, reads nothing, and comes back when it is cut
// off.
class Crowd {
 public:
  Crowd(std::uint16_t port, std::string greeting, std::string more)
      : port_(port), greeting_(std::move(greeting)), more_(std::move(more)) {
    clients_.resize(400, -1);
    for (int& client : clients_) comeBack(client);
    thread_ = std::thread([this] {
      while (!over_) {
        for (int& client : clients_)
          if (!say(client, more_)) comeBack(client);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
    });
  }
  ~Crowd() {
    over_ = true;
    thread_.join();
    for (const int client : clients_) close(client);
  }

 private:
  // False: the server has closed the connection.
  static bool say(int client, const std::string& text) {
    char byte;
    if (recv(client, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0) return false;
    return text.empty() || send(client, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT) >= 0;
  }
  void comeBack(int& client) {
    if (client >= 0) close(client);
    client = connectLoopback(port_);
    say(client, greeting_);
  }

  const std::uint16_t port_;
  const std::string greeting_, more_;
  std::vector<int> clients_;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

struct Manner {
  const char* name;
  std::string greeting, more;
};

class CrowdedHttp : public testing::TestWithParam<Manner> {};

TEST_P(CrowdedHttp, HealthIsAnsweredWithinASecond) {
  Config config = testConfig();
  config.http = "http://127.0.0.1:0";
  TestServer server(config);
  const std::string endpoint = server.app().httpEndpoint();
  const Crowd crowd(portOf(endpoint), GetParam().greeting, GetParam().more);
  for (int i = 0; i < 5; ++i) {
    const auto began = Clock::now();
    EXPECT_EQ(httpGet(endpoint, "/healthz").status, 200);
    EXPECT_LT(Clock::now() - began, std::chrono::seconds(kSanitized ? 5 : 1));  // sanitizers are slow
  }
}

INSTANTIATE_TEST_SUITE_P(Manners, CrowdedHttp,
                         testing::Values(Manner{"Silent", "", ""},
                                         Manner{"HalfARequest", "GET /healthz HTTP/1.1\r\n", "X-a: b\r\n"},
                                         Manner{"ATricklingBody",
                                                "POST /metrics HTTP/1.1\r\nContent-Length: 999999999\r\n\r\n",
                                                "x"},
                                         Manner{"ReadsNothing", "GET /metrics HTTP/1.1\r\n\r\n", ""}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace saccade
