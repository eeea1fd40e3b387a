// How far a recording is, on stderr: one line that is rewritten on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>

namespace saccade {

class Progress {
 public:
  explicit Progress(double duration_s);  // of the stream; 0: unknown

  void update(double stream_s, std::uint64_t events);
  void finish();  // leaves the line as it is

  double elapsed_s() const;  // wall-clock time since the start

 private:
  using Clock = std::chrono::steady_clock;
  const double duration_s_;
  const bool terminal_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  bool open_line_ = false;
};

}  // namespace saccade
