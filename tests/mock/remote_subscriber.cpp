#include "mock/remote_subscriber.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <sstream>
#include <stdexcept>

#include "mock/resuming_subscriber.h"

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kSilence{1500};

// The packets of a stream, one for each call.
std::function<Received()> packetsOf(const std::string& endpoint, const v1::StreamOpened& stream,
                                    std::uint64_t credit, bool refill) {
  if (refill) {
    const auto subscriber = std::make_shared<ResumingSubscriber>(endpoint, stream, credit);
    return [subscriber] { return subscriber->receive(kSilence); };
  }
  const auto subscriber = std::make_shared<MockSubscriber>(endpoint);
  subscriber->attach(stream);
  subscriber->giveCredit(credit);
  return [subscriber] { return subscriber->receive().value(); };
}

// Says a byte at the first packet, and a summary at the END; then waits to be killed. A fault ends the
// process.
[[noreturn]] void subscribe(int orders, int news) noexcept {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  char text[512] = {};
  if (read(orders, text, sizeof text - 1) <= 0) _exit(0);
  std::string endpoint;
  v1::StreamOpened stream;
  std::uint64_t credit = 0;
  bool refill = false;
  std::istringstream(text) >> endpoint >> *stream.mutable_stream_id() >> *stream.mutable_token() >> credit >>
      refill;
  const auto receive = packetsOf(endpoint, stream, credit, refill);
  Packets packets{receive()};
  if (write(news, "1", 1) != 1) _exit(1);
  while (packets.back().header.kind() != v1::KIND_END) packets.push_back(receive());
  const Summary summary = checkPackets(packets, true, packets.front().header.t0_ns());
  std::ostringstream line;
  line << testing::Test::HasFailure() << ' ' << summary.packets << ' ' << summary.events << ' '
       << summary.dropped << ' ' << summary.end_ns << '\n';
  if (write(news, line.str().data(), line.str().size()) < 0) _exit(1);
  while (true) pause();
}

}  // namespace

RemoteSubscriber::RemoteSubscriber() {
  int orders[2], news[2];
  if (pipe(orders) != 0 || pipe(news) != 0) throw std::runtime_error("no pipe");
  pid_ = fork();
  if (pid_ == 0) {
    close(orders[1]);
    close(news[0]);
    subscribe(orders[0], news[1]);
  }
  close(orders[0]);
  close(news[1]);
  orders_ = orders[1];
  news_ = news[0];
}

RemoteSubscriber::~RemoteSubscriber() {
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  close(orders_);
  close(news_);
}

void RemoteSubscriber::attach(const std::string& data_endpoint, const v1::StreamOpened& stream,
                              std::uint64_t credit_bytes, Refill refill) {
  const std::string order = data_endpoint + " " + stream.stream_id() + " " + stream.token() + " " +
                            std::to_string(credit_bytes) + (refill == Refill::kYes ? " 1\n" : " 0\n");
  char byte = 0;
  ASSERT_EQ(write(orders_, order.data(), order.size()), static_cast<ssize_t>(order.size()));
  ASSERT_EQ(read(news_, &byte, 1), 1) << "the other process got no packet";
}

Summary RemoteSubscriber::summary() {
  char text[256] = {};
  EXPECT_GT(read(news_, text, sizeof text - 1), 0) << "the other process got no END";
  bool failed = true;
  Summary summary;
  std::istringstream(text) >> failed >> summary.packets >> summary.events >> summary.dropped >>
      summary.end_ns;
  EXPECT_FALSE(failed) << "in the other process";
  return summary;
}

void RemoteSubscriber::signal(int number) {
  kill(pid_, number);
  if (number == SIGSTOP) waitpid(pid_, nullptr, WUNTRACED);
}

}  // namespace saccade
