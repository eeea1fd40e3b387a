// How soon saccaded answers while four FAST feeds take all of its threads:
//   SACCADE_FULL=1 tests/run -L bench -V
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <latch>
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

TEST(ControlLatency, IsShortWhileFourFeedsRender) {
  if (!std::getenv("SACCADE_FULL")) GTEST_SKIP() << "wants SACCADE_FULL=1 and a quiet machine";
  Process server({SACCADED, "--control", "tcp://127.0.0.1:*", "--data", "tcp://127.0.0.1:*", "--broadcast",
                  "tcp://127.0.0.1:*", "--http", "off"});
  MockClient client(controlEndpoint(server.lineWith("ready")));
  const std::string data = client.server().data_endpoint();
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(256);
  request.mutable_view()->set_height(192);
  request.mutable_timing()->set_duration_s(0);
  std::atomic<bool> stop = false;
  std::latch all_render(kFeeds);
  std::vector<std::thread> receivers;
  for (int i = 0; i < kFeeds; ++i) {
    const auto stream = client.open(request);
    receivers.emplace_back([&, stream] { receive(data, stream, all_render, stop); });
  }
  all_render.wait();
  std::vector<float> times;
  for (int i = 0; i < kRequests; ++i) {
    std::this_thread::sleep_for(kPause);
    times.push_back(milliseconds(client, i));
  }
  stop = true;
  for (auto& receiver : receivers) receiver.join();
  const float p99 = quantile(times, 0.99);
  std::printf("%d requests beside %d feeds: p50 %.2f ms, p99 %.2f ms, longest %.2f ms\n", kRequests, kFeeds,
              quantile(times, 0.5), p99, *std::max_element(times.begin(), times.end()));
  EXPECT_LT(p99, kMostP99Ms);
}

}  // namespace
}  // namespace saccade
