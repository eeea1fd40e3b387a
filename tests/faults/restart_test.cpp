// A server is killed in the middle of a dataset, and another takes its place: the client goes on at its
// event.
#include <gtest/gtest.h>

#include <csignal>
#include <optional>

#include "mock/resuming_subscriber.h"
#include "mock/server_process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr std::size_t kBefore = 7;  // packets that come before the server is killed

TEST(Restart, ADatasetGoesOnWithoutGapOrRepetition) {
  std::optional<ServerProcess> server(std::in_place);
  const std::vector<std::string> same_ports{"--control", server->control(), "--data", server->data()};
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_duration_s(0.2);
  const auto never = [] { return false; };

  const auto first = MockClient(server->control()).open(request);
  Packets packets;
  ResumingSubscriber before(server->data(), first, 1 << 20);
  while (packets.size() < kBefore) packets.push_back(before.receive(never));
  server->process().signal(SIGKILL);
  EXPECT_EQ(server->process().finish(), -1);
  server.emplace(same_ports);

  const v1::PacketHeader last = packets.back().header;
  const std::uint64_t events = last.first_event_index() + last.count();
  request.mutable_sensors(0)->set_from_event(events);
  MockClient client(server->control());
  const auto second = client.open(request);
  EXPECT_NE(second.epoch(), first.epoch());
  ResumingSubscriber after(server->data(), second, 1 << 20);
  for (const Received& packet : after.receiveAll(never)) {
    if (packet.header.seq() > last.seq()) packets.push_back(packet);
  }
  checkPackets(packets);

  request.mutable_sensors(0)->clear_from_event();
  ResumingSubscriber whole(server->data(), client.open(request), 1 << 20);
  EXPECT_TRUE(comparableBytes(packets) == comparableBytes(whole.receiveAll(never)));
}

}  // namespace
}  // namespace saccade
