// Whether streams that were accepted keep their pace on a server that takes no more of them, beside a FAST
// one of many paths:
//   SACCADE_FULL=1 tests/run -L bench -V
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "mock/server_process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr std::chrono::seconds kRun{15};
constexpr std::chrono::milliseconds kPause{100};  // between looks at how far they are behind
constexpr double kFramesPerSecond = 20;           // of wall-clock time
constexpr double kMostLagS = 1;

// Streams that take most of their time in the feed, in the sensors, in packets, in viewers of one sensor
// each.
std::vector<v1::OpenStream> kinds() {
  v1::OpenStream feed = tinyRequest();
  feed.mutable_view()->set_width(96);
  feed.mutable_view()->set_height(72);
  feed.mutable_timing()->set_duration_s(0);
  feed.mutable_timing()->set_clock(v1::CLOCK_PACED);
  feed.mutable_timing()->set_speed(kFramesPerSecond / feed.timing().frame_rate_hz());
  v1::OpenStream sensors = feed;
  sensors.set_delivery(v1::DELIVERY_LIVE);  // all share one feed
  sensors.mutable_sensors(0)->set_threshold(0.005);
  while (sensors.sensors_size() < 16) *sensors.add_sensors() = sensors.sensors(0);
  v1::OpenStream packets = sensors;
  packets.set_codec(v1::CODEC_ZSTD);
  v1::OpenStream viewers = feed;
  viewers.mutable_timing()->set_speed(5 * kFramesPerSecond / feed.timing().frame_rate_hz());
  viewers.set_delivery(v1::DELIVERY_LIVE);
  viewers.mutable_method()->set_name("pt");
  viewers.mutable_quality()->set_bounces(0);
  return {feed, sensors, packets, viewers};
}

// Opens streams until the server has no time for another. LOSSLESS ones have a feed each.
std::vector<v1::StreamOpened> fill(MockClient& client, v1::OpenStream request) {
  std::vector<v1::StreamOpened> streams;
  while (true) {
    v1::Request open;
    *open.mutable_open_stream() = request;
    const v1::Reply reply = client.call(open);
    if (reply.status().code() != v1::CODE_OK) {
      EXPECT_EQ(reply.status().limit(), "cpu") << reply.status().message();
      return streams;
    }
    streams.push_back(reply.open_stream());
  }
}

void receive(const std::string& data, const v1::StreamOpened& stream, const std::atomic<bool>& stop) {
  MockSubscriber subscriber(data);
  subscriber.attach(stream);
  subscriber.giveCredit(4 << 20);
  while (!stop) {
    const auto packet = subscriber.receive();
    if (!packet) return ADD_FAILURE() << "a feed stands still";
    subscriber.giveCredit(packet->bytes);
  }
}

class KeptPace : public testing::TestWithParam<int> {};

TEST_P(KeptPace, ByAllThatWereAccepted) {
  if (!std::getenv("SACCADE_FULL")) GTEST_SKIP() << "wants SACCADE_FULL=1 and a quiet machine";
  ServerProcess server({"--threads", std::to_string(hardwareThreads()), "--limit-cpu", "85",
                        "--limit-streams", "1000", "--limit-queues", "100000"});
  MockClient client(server.control());
  const auto streams = fill(client, kinds()[GetParam()]);
  ASSERT_FALSE(streams.empty());
  v1::OpenStream fast = tinyRequest();
  fast.mutable_timing()->set_duration_s(0);
  fast.mutable_method()->set_name("pt");  // whose tiles take a second
  fast.mutable_view()->set_width(320);
  fast.mutable_view()->set_height(240);
  fast.mutable_method()->set_spp(256);
  fast.mutable_quality()->set_bounces(8);
  const auto hog = client.open(fast);
  MockSubscriber hog_receiver(server.data());
  hog_receiver.attach(hog);
  hog_receiver.giveCredit(std::uint64_t{1} << 30);
  std::atomic<bool> stop = false;
  std::vector<std::thread> receivers;
  for (const auto& stream : streams)
    receivers.emplace_back([&, stream] { receive(server.data(), stream, stop); });
  double longest_s = 0, last_s = 0;
  const auto end = std::chrono::steady_clock::now() + kRun;
  while (std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kPause);
    last_s = 0;
    const v1::StreamList list = client.streams();
    for (const auto& stream : list.streams()) last_s = std::max(last_s, stream.lag_s());
    longest_s = std::max(longest_s, last_s);
  }
  stop = true;
  for (auto& receiver : receivers) receiver.join();
  std::printf(
      "%zu streams accepted, and a FAST one: behind their clock by %.3f s at most, by %.3f s at the end\n",
      streams.size(), longest_s, last_s);
  EXPECT_LT(last_s, kMostLagS);
}

std::string kindName(const testing::TestParamInfo<int>& kind) {
  return std::array{"OfManyFeeds", "OfManySensors", "OfManyPackets", "OfManyViewers"}[kind.param];
}
INSTANTIATE_TEST_SUITE_P(Streams, KeptPace, testing::Range(0, 4), kindName);

}  // namespace
}  // namespace saccade
