#include "farm/worker/crew.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
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

// The answer of a worker. It is shorter than PIPE_BUF, and so is written at once.
struct Result {
  std::uint64_t number;
  double cpu_s;
  Made made;
};

[[noreturn]] void failSystem(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void makePipe(int (&ends)[2]) {
  if (pipe2(ends, O_CLOEXEC) != 0) failSystem("pipe");
}

// Reads all of a record; false where the pipe ends.
template <class Record>
bool readRecord(int pipe, Record& record) {
  ssize_t count = 0;
  do {
    count = read(pipe, &record, sizeof record);
  } while (count < 0 && errno == EINTR);
  return count == static_cast<ssize_t>(sizeof record);
}

template <class Record>
bool writeRecord(int pipe, const Record& record) {
  ssize_t count = 0;
  do {
    count = write(pipe, &record, sizeof record);
  } while (count < 0 && errno == EINTR);
  return count == static_cast<ssize_t>(sizeof record);
}

// The life of a worker.
[[noreturn]] void live(const Crew::Begin& begin, int index, int tasks, int results, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kBroken);
  signal(SIGINT, SIG_IGN);  // of the whole terminal; the parent decides
  signal(SIGTERM, SIG_DFL);
  try {
    const Crew::Work work = begin(index);
    std::uint64_t number = 0;
    while (readRecord(tasks, number)) {
      Result result{};
      const auto before = processCpuTime();
      result.number = number, result.made = work(number), result.cpu_s = seconds(processCpuTime() - before);
      if (!writeRecord(results, result)) break;
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
  makePipe(results_);
  for (std::size_t i = 0; i < workers_.size(); ++i) start(workers_[i], static_cast<int>(i));
}

Crew::~Crew() {
  stop();
  for (const int end : results_) close(end);
}

void Crew::start(Worker& worker, int index) {
  int tasks[2];
  makePipe(tasks);
  const pid_t parent = getpid();
  std::fflush(nullptr);  // the child must not print what waits
  worker.process = fork();
  if (worker.process < 0) failSystem("fork");
  if (worker.process == 0) {
    for (const Worker& other : workers_)
      if (other.tasks >= 0) close(other.tasks);
    close(tasks[1]);
    live(begin_, index, tasks[0], results_[1], parent);
  }
  close(tasks[0]);
  worker.tasks = tasks[1];
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
  writeRecord(idle->tasks, number);  // where it has died, next() finds out
}

std::optional<Outcome> Crew::next(int wait_ms) {
  pollfd results{results_[0], POLLIN, 0};
  if (poll(&results, 1, wait_ms) > 0) return takeResult();
  return takeDeath();
}

std::optional<Outcome> Crew::takeResult() {
  Result result{};
  if (!readRecord(results_[0], result)) failSystem("a worker's pipe");
  for (Worker& worker : workers_)
    if (worker.number == result.number) worker.number.reset();
  return Outcome{result.number, result.made, result.cpu_s};
}

std::optional<Outcome> Crew::takeDeath() {
  for (std::size_t i = 0; i < workers_.size(); ++i) {
    Worker& worker = workers_[i];
    int status = 0;
    if (waitpid(worker.process, &status, WNOHANG) != worker.process) continue;
    const std::optional<std::uint64_t> number = worker.number;
    close(std::exchange(worker.tasks, -1));
    if (WIFEXITED(status) && WEXITSTATUS(status) == kBroken) throw std::runtime_error("no worker can begin");
    start(worker, static_cast<int>(i));
    if (number) return Outcome{*number, Made::kRetry, 0, deathText(status)};
  }
  return std::nullopt;
}

void Crew::stop() {
  for (Worker& worker : workers_) {
    if (worker.process <= 0) continue;
    kill(worker.process, SIGKILL);
    waitpid(worker.process, nullptr, 0);
    if (worker.tasks >= 0) close(worker.tasks);
    worker = {};
  }
}

}  // namespace saccade::farm
