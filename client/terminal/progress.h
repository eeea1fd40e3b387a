// Shows on stderr how far a recording is: on a terminal one line that is rewritten, elsewhere a line every 5
// s.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace saccade::client {

// To two digits below 100 s, then as "2 min 10 s".
std::string timeText(double seconds);

class Progress {
 public:
  explicit Progress(double duration_s);  // seconds of the stream; 0: unknown
  ~Progress() { finish(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `stream_s`: stream time reached, seconds. `events` came in the last `recorded_s` of it.
  void update(double stream_s, double recorded_s, std::uint64_t events);
  void note(const std::string& text);  // shown instead of update() while no events come
  void tell(const std::string& text);  // prints a line of its own, at once
  void finish();                       // ends the line

  double elapsed_s() const;  // wall-clock seconds since construction

 private:
  using Clock = std::chrono::steady_clock;
  bool due();
  void show(const std::string& text);
  std::string share(double stream_s) const;

  const double duration_s_;
  const bool terminal_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
  bool open_line_ = false;
};

}  // namespace saccade::client
