// A real link between a server and its client, which goes down or is narrow. It is a pair of virtual ones,
// each end in a network namespace of its own, and gone with the test.
#include <gtest/gtest.h>
#include <sched.h>

#include <cstdlib>

#include "mock/needs_libzmq.h"
#include "mock/resuming_subscriber.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "stream/session.h"

namespace saccade {
namespace {

using Clock = std::chrono::steady_clock;

const bool kFull = std::getenv("SACCADE_FULL") != nullptr;
const std::chrono::seconds kDown{kFull ? 10 : 2};  // the list's 10
constexpr std::chrono::milliseconds kSilence{
    1500};                                         // a client that has heard no packet so long connects anew
constexpr std::chrono::seconds kRecovered{2 + 1};  // the list's 2, on two busy cores
constexpr std::int64_t kMaxGrowthBytes = 3 * kQueueBytes + (8 << 20);
constexpr std::uint64_t kCredit = 64 << 10;

bool run(const std::string& command) {
  return std::system((command + " >/dev/null 2>&1").c_str()) == 0;
}

class Network : public testing::Test {
 protected:
  void SetUp() override {
    NEEDS_PATCHED_LIBZMQ();
    for (const char* tool : {"ip", "tc", "nsenter", "unshare"}) {
      if (!run(std::string("command -v ") + tool)) GTEST_SKIP() << tool << " is not installed";
    }
    if (unshare(CLONE_NEWNET) != 0) GTEST_SKIP() << "network namespaces are not allowed here: they need root";
    server_.emplace(
        std::vector<std::string>{"--control", "tcp://0.0.0.0:*", "--data", "tcp://0.0.0.0:*", "--insecure"},
        std::vector<std::string>{"/usr/bin/unshare", "-n"});
    const std::string pid = std::to_string(server_->process().pid());
    in_server_ = "nsenter -t " + pid + " -n ";
    if (!run("ip link add name near type veth peer name far netns " + pid)) {
      GTEST_SKIP() << "this kernel has no veth";
    }
    ASSERT_TRUE(run("ip addr add 10.99.0.1/24 dev near && ip link set near up"));
    ASSERT_TRUE(run(in_server_ + "ip addr add 10.99.0.2/24 dev far && " + in_server_ + "ip link set far up"));
    client_.emplace(far(server_->control()));
  }

  static std::string far(const std::string& endpoint) {
    return "tcp://10.99.0.2" + endpoint.substr(endpoint.rfind(':'));
  }
  void expectAccounted(const Packets& packets, const v1::StreamOpened& stream) {
    const Summary summary = checkPackets(packets, true);
    // On a new connection: the server may have cut the old one.
    const v1::StreamInfo info = MockClient(far(server_->control())).info(stream.stream_id());
    EXPECT_EQ(summary.dropped, info.dropped_packets());
    EXPECT_EQ(summary.packets + summary.dropped, packets.back().header.seq());
    EXPECT_EQ(packets.back().header.first_event_index(), info.events());
  }

  std::optional<ServerProcess> server_;
  std::optional<MockClient> client_;
  std::string in_server_;  // runs a command at the server's end
};

TEST_F(Network, AStreamRecoversFromALinkThatWasDown) {
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_LIVE);
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_duration_s(static_cast<double>(kDown.count()) + 2);
  const auto stream = client_->open(request);
  ResumingSubscriber subscriber(far(server_->data()), stream, kCredit);
  Packets packets;
  Clock::time_point heard;
  const auto receive = [&] {
    packets.push_back(subscriber.receive(kSilence));
    heard = Clock::now();
  };
  while (packets.size() < 50) receive();
  const std::int64_t resident = server_->usage().resident_bytes;
  ASSERT_TRUE(run(in_server_ + "ip link set far down"));
  const auto down = Clock::now();
  std::this_thread::sleep_for(kDown);  // nothing can happen meanwhile
  ASSERT_TRUE(run(in_server_ + "ip link set far up"));
  const auto up = Clock::now();
  const std::uint64_t before = packets.size();
  while (heard < up + std::chrono::milliseconds(1) || packets.size() == before) receive();
  EXPECT_LT(heard - up, kRecovered);
  EXPECT_GE(heard - down, kDown);
  EXPECT_LT(server_->usage().resident_bytes - resident, kMaxGrowthBytes);
  while (packets.back().header.kind() != v1::KIND_END) receive();
  expectAccounted(packets, stream);
}

TEST_F(Network, ALiveStreamOnANarrowLinkLosesNothingUncounted) {
  ASSERT_TRUE(run(in_server_ + "tc qdisc add dev far root tbf rate 10mbit burst 32k latency 50ms"));
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_LIVE);
  request.mutable_view()->set_width(48);
  request.mutable_view()->set_height(36);
  request.mutable_quality()->set_bounces(0);
  request.mutable_method()->set_name("pt");  // noise: many events
  request.mutable_timing()->set_duration_s(0.4);
  request.mutable_sensors(0)->set_threshold(0.02);
  const auto stream = client_->open(request);
  ResumingSubscriber subscriber(far(server_->data()), stream, kCredit);
  const auto began = Clock::now();
  std::uint64_t bytes = 0;
  Packets packets;
  while (packets.empty() || packets.back().header.kind() != v1::KIND_END) {
    packets.push_back(subscriber.receive(kSilence));
    bytes += packets.back().bytes;
  }
  expectAccounted(packets, stream);
  EXPECT_GT(client_->info(stream.stream_id()).dropped_packets(), 0u);
  const std::chrono::duration<double> took = Clock::now() - began;
  EXPECT_GT(took.count(), 0.9 * static_cast<double>(bytes) / 1.25e6);
}

}  // namespace
}  // namespace saccade
