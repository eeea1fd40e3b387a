// The wall clock of the machine is set, forth and back by an hour, while a server streams.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>

#include "mock/mock_http.h"
#include "mock/server_process.h"
#include "mock/test_server.h"

namespace saccade {
namespace {

constexpr std::int64_t kHour = 3600;
constexpr double kMaxLagSeconds = 60;  // however slow the build; a clock that counted would make 3600

// The offset of the wall clock of programs that are started while it lives.
class SteppedClock {
 public:
  SteppedClock() {
    const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0 || ftruncate(file, sizeof(std::int64_t)) != 0) std::abort();
    offset_ = static_cast<std::atomic<std::int64_t>*>(
        mmap(nullptr, sizeof(std::int64_t), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
    close(file);
  }
  ~SteppedClock() { unlink(path_.c_str()); }
  void set(std::int64_t seconds) { *offset_ = seconds; }
  std::vector<std::string> wrapper() const {
    return {"/usr/bin/env", "SACCADE_TEST_CLOCK=" + path_, "LD_PRELOAD=" CLOCK_SHIM,
            "ASAN_OPTIONS=verify_asan_link_order=0"};
  }

 private:
  const std::string path_ = testing::TempDir() + "clock_step_test_" + std::to_string(getpid());
  std::atomic<std::int64_t>* offset_;
};

class ClockStep : public testing::Test {
 protected:
  // The time in the server's log of a line that it writes now.
  int hourOfLog() {
    v1::OpenStream wrong = tinyRequest();
    wrong.set_scene("nowhere");
    client_.tryOpen(wrong);
    const std::string line = server_.process().lineWith("no scene is named");
    return std::stoi(line.substr(line.find('T') + 1, 2));
  }

  SteppedClock clock_;
  ServerProcess server_{{"--log-format", "json"}, clock_.wrapper()};
  MockClient client_{server_.control()};
};

TEST_F(ClockStep, ChangesNoTimeOutAndNoPace) {
  v1::OpenStream request = tinyRequest();
  request.mutable_timing()->set_clock(v1::CLOCK_PACED);
  request.mutable_timing()->set_duration_s(2);
  const auto paced = client_.open(request);
  const auto waiting = client_.open(tinyRequest());  // nobody has attached to it yet: it has 30 s
  MockSubscriber subscriber(server_.data());
  const auto began = std::chrono::steady_clock::now();
  subscriber.attach(paced);
  subscriber.giveCredit(std::uint64_t{1} << 30);
  Packets packets;
  const int hour = hourOfLog();
  double lag_s = 0;
  for (const std::int64_t offset : {kHour, -kHour}) {
    const std::uint64_t seen = packets.size();
    clock_.set(offset);
    EXPECT_EQ((hourOfLog() - hour + 24) % 24, offset > 0 ? 1 : 23) << "the clock has not been set";
    while (packets.size() < seen + 100) {
      packets.push_back(subscriber.receive().value());
      lag_s = std::max(lag_s, client_.info(paced.stream_id()).lag_s());
    }
    EXPECT_EQ(httpGet(server_.http(), "/healthz").status, 200);
  }
  const auto rest = subscriber.receiveAll(1)[0];
  packets.insert(packets.end(), rest.begin(), rest.end());
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  checkPackets(packets);
  EXPECT_LT(lag_s, kMaxLagSeconds);
  EXPECT_GE(took.count(), 1.9);

  MockSubscriber late(server_.data());
  late.attach(waiting);
  late.giveCredit(1 << 20);
  checkPackets(late.receiveAll(1)[0]);
}

}  // namespace
}  // namespace saccade
