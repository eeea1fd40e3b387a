// A server on which streams and their client fill every limit at once: its memory grows by no more than the
// limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "faults/event_bomb.h"
#include "mock/server_process.h"
#include "mock/zmtp_peer.h"

namespace saccade {
namespace {

constexpr double kMemoryMiB = 48, kQueuesMiB = 36, kScenesMiB = 16, kInboundMiB = 16, kReplyMiB = 0.5;
constexpr double kRepliesMiB = 16 * kReplyMiB;  // of all connections
constexpr double kOtherMiB = 16;                // threads, connections, what the heap does not give back
constexpr double kMiB = 1 << 20;

std::string text(double value) {
  return std::to_string(value);
}

// In few long frames, so that each of them is many packets besides.
v1::OpenStream greedyRequest(int seed) {
  v1::OpenStream request = eventBomb(10, 2000);
  request.mutable_timing()->set_frame_rate_hz(1);
  request.mutable_timing()->set_duration_s(0);
  for (v1::Keyframe& key : *request.mutable_trajectory()->mutable_keyframes()->mutable_keys())
    key.set_time_s(100 * key.time_s());
  request.set_seed(static_cast<std::uint64_t>(seed));
  while (request.sensors_size() < 4) *request.add_sensors() = request.sensors(0);
  return request;
}

// Opens streams until a limit is reached; its name.
std::string fill(MockClient& client, std::vector<v1::StreamOpened>& streams) {
  while (true) {
    v1::Request open;
    *open.mutable_open_stream() = greedyRequest(static_cast<int>(streams.size()));
    const v1::Reply reply = client.call(open);
    if (reply.status().code() != v1::CODE_OK) return reply.status().limit();
    streams.push_back(reply.open_stream());
  }
}

// Takes one part of a stream's packets, and never acknowledges any.
void takeSome(MockSubscriber& subscriber, const v1::StreamOpened& stream) {
  subscriber.attach(stream);
  subscriber.giveCredit(static_cast<std::uint64_t>(4 * kMiB));
  while (subscriber.receive(std::chrono::milliseconds(300))) {
  }
}

// Connections that send most of a large request each, more than `inbound` has room for.
std::vector<ZmtpPeer> sendWithoutEnd(const std::string& control) {
  const std::string request = zmtp::part(std::string(static_cast<std::size_t>(7 * kMiB), 'x'));
  std::vector<ZmtpPeer> peers;
  for (int i = 0; i < 4; ++i) peers.emplace_back(control).say(request.substr(0, request.size() - 1));
  return peers;
}

// Connections that ask, and read nothing, until `replies` is full.
std::vector<ZmtpPeer> readNothing(const std::string& control) {
  v1::Request request;
  request.set_protocol_version(1);
  request.mutable_server_info();
  std::string many;
  for (int i = 0; i < 500; ++i) many += zmtp::part(request.SerializeAsString());
  std::vector<ZmtpPeer> peers;
  for (int i = 0; i < 40; ++i) peers.emplace_back(control).say(many);
  return peers;
}

// The first texture brings the libraries that read pictures: they are of the server, and of no limit.
void loadPictures(MockClient& client) {
  v1::OpenStream request = tinyRequest();
  request.set_scene("textured-cornell-box");
  client.close(client.open(request));
}

TEST(FullServer, GrowsByNoMoreThanItsLimits) {
  if (kSanitized) GTEST_SKIP() << "sanitizers keep what is freed";
  ServerProcess server({"--limit-memory", text(kMemoryMiB), "--limit-queues", text(kQueuesMiB),
                        "--limit-queue", "0.5", "--limit-scenes", text(kScenesMiB), "--limit-events", "32768",
                        "--limit-inbound", text(kInboundMiB), "--limit-replies", text(kReplyMiB)});
  MockClient client(server.control());
  loadPictures(client);
  const Usage before = server.usage();
  for (const char* scene : {"cornell-bunny", "textured-cornell-box", "cornell-box"}) {
    v1::OpenStream request = tinyRequest();
    request.set_scene(scene);
    client.close(client.open(request));
  }
  const auto deadline = ChangeNotifier::Clock::now() + kPatience;
  while (client.streams().streams_size() > 0 && ChangeNotifier::Clock::now() < deadline) {
  }
  std::vector<v1::StreamOpened> streams;
  const std::string limit = fill(client, streams);
  EXPECT_TRUE(limit == "memory" || limit == "queues") << limit;
  ASSERT_GE(streams.size(), 8u);
  std::vector<std::unique_ptr<MockSubscriber>> subscribers;
  std::vector<std::thread> threads;
  for (const auto& stream : streams) {
    subscribers.push_back(std::make_unique<MockSubscriber>(server.data()));
    threads.emplace_back([&, i = subscribers.size() - 1] { takeSome(*subscribers[i], stream); });
  }
  const auto senders = sendWithoutEnd(server.control()), askers = readNothing(server.control());
  double top = 0;
  const auto look = [&] {
    const std::int64_t grown = server.usage().resident_bytes - before.resident_bytes;
    top = std::max(top, static_cast<double>(grown) / kMiB);
  };
  for (auto& thread : threads) {
    look();
    thread.join();
  }
  look();
  v1::Request ask;
  ask.mutable_server_info();
  const v1::Reply answer = client.call(ask);  // who reads all replies has room for a short one
  EXPECT_EQ(answer.status().code(), v1::CODE_OK) << answer.status().ShortDebugString();
  std::printf(
      "%zu streams, full by %s: +%.1f MiB; memory %.0f + queues %.0f + scenes %.0f + inbound %.0f + %.0f\n",
      streams.size(), limit.c_str(), top, kMemoryMiB, kQueuesMiB, kScenesMiB, kInboundMiB, kRepliesMiB);
  EXPECT_LT(top, kMemoryMiB + kQueuesMiB + kScenesMiB + kInboundMiB + kRepliesMiB + kOtherMiB);
}

}  // namespace
}  // namespace saccade
