#include "client/terminal/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "client/terminal/console.h"

namespace saccade::client {
namespace {

constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::chrono::seconds kNextLine{5};

std::string barOf(double fraction) {
  constexpr int kWidth = 24;
  const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kWidth);
  return "[" + std::string(full, '#') + std::string(kWidth - full, '.') + "] ";
}

}  // namespace

std::string timeText(double seconds) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g s", seconds);
  if (seconds < 99.5) return text;
  const auto whole = std::llround(seconds);
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min";
}

Progress::Progress(double duration_s) : duration_s_(duration_s), terminal_(isatty(STDERR_FILENO) != 0) {}

// "34 %, 0.68 of 2 s, 21 s left"
std::string Progress::share(double stream_s) const {
  char text[96];
  if (duration_s_ <= 0) {
    std::snprintf(text, sizeof(text), "%.3f s", stream_s);
    return text;
  }
  const double done = std::clamp(stream_s / duration_s_, 0.0, 1.0);
  std::snprintf(text, sizeof(text), "%3.0f %%, %.3f of %g s", 100 * done, stream_s, duration_s_);
  std::string shown = (terminal_ ? barOf(done) : "") + text;
  if (done > 0) shown += ", " + timeText(elapsed_s() * (1 - done) / done) + " left";
  return shown;
}

void Progress::update(double stream_s, double recorded_s, std::uint64_t events) {
  if (!due()) return;
  char rates[128];
  std::snprintf(rates, sizeof(rates), ", %llu events (%.3g per second of the stream), %.3gx real time",
                static_cast<unsigned long long>(events), recorded_s > 0 ? events / recorded_s : 0.0,
                recorded_s / elapsed_s());
  show(share(stream_s) + rates);
}

void Progress::note(const std::string& text) {
  if (due()) show(text);
}

void Progress::tell(const std::string& text) {
  finish();
  print(stderr, "%s\n", text.c_str());
}

bool Progress::due() {
  const auto now = Clock::now();
  if (now - shown_ < (terminal_ ? Clock::duration(kRedraw) : Clock::duration(kNextLine))) return false;
  shown_ = now;
  return true;
}

void Progress::show(const std::string& text) {
  std::fprintf(stderr, terminal_ ? "\r%s\x1b[K" : "%s\n", printable(text).c_str());
  open_line_ = terminal_;
}

void Progress::finish() {
  if (open_line_) std::fputc('\n', stderr);
  open_line_ = false;
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

}  // namespace saccade::client
