// How far a recording is, on stderr: one line that is rewritten on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace saccade::client {

class Progress {
 public:
  explicit Progress(double duration_s);  // of the stream; 0: unknown

  void update(double stream_s, std::uint64_t events);
  void note(const std::string& text);  // in the place of update(), where nothing comes
  void tell(const std::string& text);  // a line of its own, at once
  void finish();                       // leaves the line as it is

  double elapsed_s() const;  // wall-clock time since the start

 private:
  using Clock = std::chrono::steady_clock;
  bool due();
  void show(const std::string& text);

  const double duration_s_;
  const bool terminal_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  bool open_line_ = false;
};

}  // namespace saccade::client
