#include "farm/worker/crew.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/thread_time.h"
#include "base/units.h"

namespace saccade::farm {
namespace {

constexpr int kBroken = 70;  // exit status of a worker that could not begin

// The answer of a worker.
struct Result {
  std::uint64_t number;
  double cpu_s;
  Made made;
};

[[noreturn]] void failSystem(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

// Reads a record; false where the other end is closed.
template <class Record>
bool readRecord(int socket, Record& record) {
  ssize_t count = 0;
  do {
    count = recv(socket, &record, sizeof record, 0);
  } while (count < 0 && errno == EINTR);
  return count == static_cast<ssize_t>(sizeof record);
}

// Raises no SIGPIPE where the other end is closed.
template <class Record>
bool writeRecord(int socket, const Record& record) {
  ssize_t count = 0;
  do {
    count = send(socket, &record, sizeof record, MSG_NOSIGNAL);
  } while (count < 0 && errno == EINTR);
  return count == static_cast<ssize_t>(sizeof record);
}

// The life of a worker.
[[noreturn]] void live(const Crew::Begin& begin, int index, int socket, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kBroken);
  signal(SIGINT, SIG_IGN);  // of the whole terminal; the parent decides
  signal(SIGTERM, SIG_DFL);
  try {
    const Crew::Work work = begin(index);
    std::uint64_t number = 0;
    while (readRecord(socket, number)) {
      Result result{};
      const auto before = processCpuTime();
      result.number = number, result.made = work(number), result.cpu_s = seconds(processCpuTime() - before);
      if (!writeRecord(socket, result)) break;
    }
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "saccade-farm: a worker ends: %s\n", fault.what());
    _exit(kBroken);
  }
  _exit(0);
}

std::string deathText(int status) {
  if (WIFSIGNALED(status))
    return "the worker was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  return "the worker ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Crew::Crew(int workers, Begin begin) : begin_(std::move(begin)), workers_(static_cast<std::size_t>(workers)) {
  for (std::size_t i = 0; i < workers_.size(); ++i) start(i);
}

Crew::~Crew() {
  stop();
}

void Crew::start(std::size_t index) {
  Worker& worker = workers_[index];
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) failSystem("socketpair");
  const pid_t parent = getpid();
  std::fflush(nullptr);  // the child must not print what waits
  worker.process = fork();
  if (worker.process < 0) failSystem("fork");
  if (worker.process == 0) {
    for (const Worker& other : workers_)
      if (other.socket >= 0) close(other.socket);
    close(ends[0]);
    live(begin_, static_cast<int>(index), ends[1], parent);
  }
  close(ends[1]);
  worker.socket = ends[0];
  worker.number.reset();
}

bool Crew::isIdle() const {
  return busy() < workers_.size();
}

std::size_t Crew::busy() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(workers_, [](const Worker& w) { return w.number.has_value(); }));
}

void Crew::give(std::uint64_t number) {
  const auto idle = std::ranges::find_if(workers_, [](const Worker& w) { return !w.number; });
  idle->number = number;
  writeRecord(idle->socket, number);  // where it has died, next() finds out
}

std::optional<Outcome> Crew::next(int wait_ms) {
  std::vector<pollfd> sockets;
  for (const Worker& worker : workers_) sockets.push_back({worker.socket, POLLIN, 0});
  if (poll(sockets.data(), sockets.size(), wait_ms) <= 0) return std::nullopt;
  for (std::size_t i = 0; i < workers_.size(); ++i) {
    if (sockets[i].revents == 0) continue;
    if (auto outcome = outcomeOf(i)) return outcome;
  }
  return std::nullopt;
}

std::optional<Outcome> Crew::outcomeOf(std::size_t index) {
  Worker& worker = workers_[index];
  Result result{};
  if (!readRecord(worker.socket, result)) return replace(index);
  worker.number.reset();
  return Outcome{result.number, result.made, result.cpu_s};
}

// An answer that a worker gave before it died has been read by now.
std::optional<Outcome> Crew::replace(std::size_t index) {
  Worker& worker = workers_[index];
  const std::optional<std::uint64_t> number = worker.number;
  int status = 0;
  while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
  }
  close(std::exchange(worker.socket, -1));
  if (WIFEXITED(status) && WEXITSTATUS(status) == kBroken) throw std::runtime_error("no worker can begin");
  start(index);
  if (!number) return std::nullopt;
  return Outcome{*number, Made::kRetry, 0, deathText(status)};
}

void Crew::stop() {
  for (Worker& worker : workers_) {
    if (worker.process <= 0) continue;
    kill(worker.process, SIGKILL);
    waitpid(worker.process, nullptr, 0);
    if (worker.socket >= 0) close(worker.socket);
    worker = {};
  }
}

}  // namespace saccade::farm
