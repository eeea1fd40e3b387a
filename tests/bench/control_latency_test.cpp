// How soon saccaded answers while four FAST feeds take all of its threads, beside clients that ask much:
//   SACCADE_FULL=1 tests/run -L bench -V
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <latch>
#include <optional>
#include <thread>

#include "base/quantile.h"
#include "mock/process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr int kFeeds = 4, kRequests = 2000;
constexpr std::chrono::milliseconds kPause{
    2};  // between requests, so that the feeds render many frames meanwhile
constexpr double kMostP99Ms = 20;

std::string controlEndpoint(const std::string& ready_line) {
  const auto from = ready_line.find("tcp://");
  return ready_line.substr(from, ready_line.find(' ', from) - from);
}

// Takes what comes until `stop`.
void receive(const std::string& data, const v1::StreamOpened& stream, std::latch& all_render,
             const std::atomic<bool>& stop) {
  MockSubscriber subscriber(data);
  subscriber.attach(stream);
  subscriber.giveCredit(4 << 20);
  for (bool first = true; !stop; first = false) {
    const auto packet = subscriber.receive();
    if (first) all_render.count_down();
    if (!packet) return ADD_FAILURE() << "a feed stands still";
    subscriber.giveCredit(packet->bytes);
  }
}

// Clients that ask, each for itself and without pause, until they go.
class Crowd {
 public:
  Crowd(int clients, const std::string& control, const std::function<void(MockClient&)>& ask) {
    for (int i = 0; i < clients; ++i) {
      threads_.emplace_back([=, this] {
        MockClient client(control);
        while (!stop_) {
          ask(client);
          ++asked_;
        }
      });
    }
  }
  ~Crowd() {
    stop_ = true;
    for (auto& thread : threads_) thread.join();
  }
  int asked() const { return asked_; }

 private:
  std::atomic<bool> stop_ = false;
  std::atomic<int> asked_ = 0;
  std::vector<std::thread> threads_;
};

float milliseconds(MockClient& client, int i) {
  v1::Request request;
  if (i % 2 == 0) {
    request.mutable_server_info();
  } else {
    request.mutable_list_streams();
  }
  const auto begin = std::chrono::steady_clock::now();
  client.call(request);
  return std::chrono::duration<float, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void listScenes(MockClient& client) {
  v1::Request request;
  request.mutable_list_scenes();
  client.call(request);
}

// About 2 MB of keyframes.
v1::OpenStream longPath() {
  v1::OpenStream request = tinyRequest();
  v1::Keyframes& path = *request.mutable_trajectory()->mutable_keyframes();
  for (int i = 0; i < 60'000; ++i) {
    v1::Keyframe& key = *path.add_keys();
    key.set_time_s(i);
    key.mutable_position()->set_x(1);
    key.mutable_rotation()->set_w(1);
  }
  return request;
}

class ControlLatency : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::getenv("SACCADE_FULL")) GTEST_SKIP() << "wants SACCADE_FULL=1 and a quiet machine";
    server_.emplace(std::vector<std::string>{SACCADED, "--control", "tcp://127.0.0.1:*", "--data",
                                             "tcp://127.0.0.1:*", "--broadcast", "tcp://127.0.0.1:*",
                                             "--http", "off"});
    control_ = controlEndpoint(server_->lineWith("ready"));
    client_.emplace(control_);
    const std::string data = client_->server().data_endpoint();
    v1::OpenStream request = tinyRequest();
    request.mutable_view()->set_width(256);
    request.mutable_view()->set_height(192);
    request.mutable_timing()->set_duration_s(0);
    for (int i = 0; i < kFeeds; ++i) {
      streams_.push_back(client_->open(request));
      receivers_.emplace_back(
          [=, this, stream = streams_.back()] { receive(data, stream, all_render_, stop_); });
    }
    all_render_.wait();
  }
  void TearDown() override {
    stop_ = true;
    for (auto& receiver : receivers_) receiver.join();
  }

  void measure(const std::string& beside) {
    std::vector<float> times;
    for (int i = 0; i < kRequests; ++i) {
      std::this_thread::sleep_for(kPause);
      times.push_back(milliseconds(*client_, i));
    }
    const float p99 = quantile(times, 0.99);
    std::printf("%d requests beside %d feeds%s: p50 %.2f ms, p99 %.2f ms, longest %.2f ms\n", kRequests,
                kFeeds, beside.c_str(), quantile(times, 0.5), p99,
                *std::max_element(times.begin(), times.end()));
    EXPECT_LT(p99, kMostP99Ms) << beside;
  }
  void getFrame(MockClient& client) {
    v1::Request request;
    request.mutable_get_frame()->set_stream_id(streams_[0].stream_id());
    request.mutable_get_frame()->set_token(streams_[0].token());
    client.call(request);
  }

  std::optional<Process> server_;
  std::string control_;
  std::optional<MockClient> client_;
  std::vector<v1::StreamOpened> streams_;
  std::atomic<bool> stop_ = false;
  std::latch all_render_{kFeeds};
  std::vector<std::thread> receivers_;
};

TEST_F(ControlLatency, IsShortWhileFourFeedsRender) {
  measure("");
}

TEST_F(ControlLatency, IsShortBesideClientsThatAskMuch) {
  const v1::OpenStream long_path = longPath();
  const Crowd lists(8, control_, listScenes);
  const Crowd opens(4, control_, [&](MockClient& client) { client.close(client.open(long_path)); });
  const Crowd pictures(4, control_, [this](MockClient& client) { getFrame(client); });
  measure(", 8 clients that list scenes, 4 that open 2 MB of keyframes, 4 that ask for pictures");
  std::printf("%d lists, %d opens, %d pictures\n", lists.asked(), opens.asked(), pictures.asked());
}

}  // namespace
}  // namespace saccade
