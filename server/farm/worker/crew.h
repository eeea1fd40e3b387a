// Processes that make sequences. One that dies takes no other with it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "farm/worker/make_sequence.h"

namespace saccade::farm {

// The end of a sequence.
struct Outcome {
  std::uint64_t number;
  Made made;
  double cpu_s;            // of the worker
  std::string death = {};  // how the worker died of it, or empty
};

class Crew {
 public:
  // `work`: what a worker does with the number of a sequence; called in its own process.
  using Work = std::function<Made(std::uint64_t)>;
  // Called once in each process, before any work.
  using Begin = std::function<Work(int index)>;

  // Forks; no thread may run yet. Throws std::system_error.
  Crew(int workers, Begin begin);
  ~Crew();  // ends the workers at once
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  bool isIdle() const;              // whether a worker has nothing to do
  std::size_t busy() const;         // workers
  void give(std::uint64_t number);  // to an idle worker
  // The next sequence that has ended; nothing after `wait_ms`. Starts a new worker for one that died.
  std::optional<Outcome> next(int wait_ms);
  void stop();  // ends the workers at once: what they are at is lost

 private:
  struct Worker {
    pid_t process = -1;
    int socket = -1;  // to it
    std::optional<std::uint64_t> number = {};
  };
  void start(std::size_t index);
  std::optional<Outcome> outcomeOf(std::size_t index);  // that it has told, or its death
  std::optional<Outcome> replace(std::size_t index);    // a worker that died: what it was at

  const Begin begin_;
  std::vector<Worker> workers_;
};

}  // namespace saccade::farm
