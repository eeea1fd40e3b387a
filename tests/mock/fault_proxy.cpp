#include "mock/fault_proxy.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <deque>
#include <vector>

#include "mock/loopback.h"

namespace saccade {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kHeldBytes = 64 << 10;  // in each direction; more stays with the sender
constexpr int kTickMs = 1;                    // while bytes wait for their time

}  // namespace

struct FaultProxy::Direction {
  struct Chunk {
    Clock::time_point arrived;
    std::string bytes;
  };
  int from, to;
  std::deque<Chunk> held = {};
  std::size_t held_bytes = 0;
  std::uint64_t passed = 0;
  bool ended = false, closed = false;  // FIN has come; has been passed on

  bool readable() const { return !ended && held_bytes < kHeldBytes; }
};

struct FaultProxy::Connection {
  Direction up, down;
  Clock::time_point began = Clock::now();  // since then bytes_per_s is counted
  std::uint64_t passed_before = 0;
  bool over = false;
};

FaultProxy::FaultProxy(const std::string& target) : target_port_(portOf(target)) {
  std::uint16_t port = 0;
  listener_ = listenOnLoopback(port);
  endpoint_ = "tcp://127.0.0.1:" + std::to_string(port);
  thread_ = std::thread([this] { run(); });
}

FaultProxy::~FaultProxy() {
  stop_ = true;
  wake_.wake();
  thread_.join();
  for (auto& connection : connections_) cut(connection, Faults::Cut::kReset);
  close(listener_);
}

void FaultProxy::set(const Faults& faults) {
  std::lock_guard lock(mutex_);
  faults_ = faults;
  wake_.wake();
}

void FaultProxy::resetAll() {
  reset_all_ = true;
  wake_.wake();
}

std::string FaultProxy::seen() const {
  std::lock_guard lock(mutex_);
  return seen_;
}

void FaultProxy::run() {
  while (!stop_) {
    std::vector<pollfd> fds{{listener_, POLLIN, 0}, {wake_.fd(), POLLIN, 0}};
    bool waiting = false;
    for (const auto& connection : connections_) {
      for (const Direction* direction : {&connection.up, &connection.down}) {
        if (direction->readable()) fds.push_back({direction->from, POLLIN, 0});
        waiting |= !direction->held.empty() || (direction->ended && !direction->closed);
      }
    }
    poll(fds.data(), fds.size(), waiting ? kTickMs : -1);
    if (fds[1].revents) wake_.clear();
    if (fds[0].revents) accept();
    std::unique_lock lock(mutex_);
    const Faults faults = faults_;
    lock.unlock();
    const bool reset = reset_all_.exchange(false);
    for (auto& connection : connections_) {
      if (reset) cut(connection, Faults::Cut::kReset);
      if (!connection.over) turn(connection, faults);
    }
    std::erase_if(connections_, [](const auto& connection) { return connection.over; });
  }
}

void FaultProxy::accept() {
  const int client = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  if (client < 0) return;
  const int server = connectLoopback(target_port_);
  if (server < 0) {  // nobody is there: nor are we
    resetOnClose(client);
    close(client);
    return;
  }
  fcntl(server, F_SETFL, O_NONBLOCK);
  connections_.push_back({{client, server}, {server, client}});
  ++accepted_;
}

void FaultProxy::turn(Connection& connection, const Faults& faults) {
  for (Direction* direction : {&connection.up, &connection.down}) {
    if (direction->readable()) read(*direction);
    if (!faults.stall && !connection.over) write(connection, *direction, faults);
  }
  if (!connection.over && connection.up.closed && connection.down.closed) cut(connection, Faults::Cut::kNone);
}

void FaultProxy::read(Direction& direction) {
  char buffer[16 << 10];
  const ssize_t n = recv(direction.from, buffer, sizeof buffer, 0);
  if (n < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (n <= 0) {
    direction.ended = true;
    return;
  }
  direction.held.push_back({Clock::now(), std::string(buffer, static_cast<std::size_t>(n))});
  direction.held_bytes += static_cast<std::size_t>(n);
  std::lock_guard lock(mutex_);
  seen_.append(buffer, static_cast<std::size_t>(n));
}

// How many bytes may pass now.
std::uint64_t FaultProxy::allowance(Connection& connection, const Direction& direction,
                                    const Faults& faults) {
  if (&direction == &connection.up) return direction.held_bytes;
  std::uint64_t allowed = direction.held_bytes;
  if (faults.bytes_per_s > 0) {
    const std::chrono::duration<double> since = Clock::now() - connection.began;
    const auto due = static_cast<std::uint64_t>(since.count() * static_cast<double>(faults.bytes_per_s));
    const std::uint64_t passed = direction.passed - connection.passed_before;
    allowed = std::min(allowed, due > passed ? due - passed : 0);
  } else {
    connection.began = Clock::now();
    connection.passed_before = direction.passed;
  }
  if (faults.cut == Faults::Cut::kNone) return allowed;
  return std::min(allowed, faults.cut_after - std::min(faults.cut_after, direction.passed));
}

void FaultProxy::write(Connection& connection, Direction& direction, const Faults& faults) {
  std::uint64_t allowed = allowance(connection, direction, faults);
  while (allowed > 0 && !direction.held.empty()) {
    Direction::Chunk& chunk = direction.held.front();
    if (Clock::now() - chunk.arrived < faults.delay) break;
    const ssize_t n = send(direction.to, chunk.bytes.data(),
                           std::min<std::size_t>(allowed, chunk.bytes.size()), MSG_NOSIGNAL);
    if (n < 0 && errno != EAGAIN) return cut(connection, Faults::Cut::kNone);  // who was to have it is gone
    if (n <= 0) break;
    const auto sent = static_cast<std::size_t>(n);
    chunk.bytes.erase(0, sent);
    if (chunk.bytes.empty()) direction.held.pop_front();
    direction.held_bytes -= sent;
    direction.passed += sent;
    allowed -= sent;
  }
  const bool down = &direction == &connection.down;
  if (down && faults.cut != Faults::Cut::kNone && direction.passed >= faults.cut_after) {
    return cut(connection, faults.cut);
  }
  if (!direction.ended || direction.closed || !direction.held.empty()) return;
  shutdown(direction.to, SHUT_WR);
  direction.closed = true;
}

void FaultProxy::cut(Connection& connection, Faults::Cut how) {
  if (how == Faults::Cut::kHalfClose) {
    Direction& down = connection.down;
    if (down.closed) return;
    ++cuts_;
    shutdown(down.to, SHUT_WR);
    down.ended = down.closed = true;
    down.held.clear();
    down.held_bytes = 0;
    return;
  }
  connection.over = true;
  cuts_ += how != Faults::Cut::kNone;
  for (const int fd : {connection.up.from, connection.down.from}) {
    if (how == Faults::Cut::kReset) resetOnClose(fd);
    close(fd);
  }
}

}  // namespace saccade
