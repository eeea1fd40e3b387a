#include "client/commands/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kRedraw{200};
constexpr std::chrono::seconds kNextLine{5};

std::string barOf(double fraction) {
  constexpr int kWidth = 24;
  const int full = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kWidth);
  return "[" + std::string(full, '#') + std::string(kWidth - full, '.') + "] ";
}

}  // namespace

Progress::Progress(double duration_s) : duration_s_(duration_s), terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::update(double stream_s, std::uint64_t events) {
  const auto now = Clock::now();
  if (now - shown_ < (terminal_ ? Clock::duration(kRedraw) : Clock::duration(kNextLine))) return;
  shown_ = now;
  const double wall = elapsed_s();
  const std::string bar = terminal_ && duration_s_ > 0 ? barOf(stream_s / duration_s_) : "";
  std::fprintf(stderr, "%s%s%.3f s, %llu events, %.3g events/s, %.3gx real time%s", terminal_ ? "\r" : "",
               bar.c_str(), stream_s, static_cast<unsigned long long>(events), events / wall, stream_s / wall,
               terminal_ ? "\x1b[K" : "\n");
  open_line_ = terminal_;
}

void Progress::finish() {
  if (open_line_) std::fputc('\n', stderr);
  open_line_ = false;
}

double Progress::elapsed_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

}  // namespace saccade
