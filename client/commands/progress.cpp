#include "client/commands/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <string>

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

Progress::Progress(double duration_s) : duration_s_(duration_s), terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::update(double stream_s, std::uint64_t events) {
  if (!due()) return;
  const double wall = elapsed_s();
  char numbers[128];
  std::snprintf(numbers, sizeof(numbers), "%.3f s, %llu events, %.3g events/s, %.3gx real time", stream_s,
                static_cast<unsigned long long>(events), events / wall, stream_s / wall);
  show((terminal_ && duration_s_ > 0 ? barOf(stream_s / duration_s_) : "") + numbers);
}

void Progress::note(const std::string& text) {
  if (due()) show(text);
}

void Progress::tell(const std::string& text) {
  finish();
  std::fprintf(stderr, "%s\n", text.c_str());
}

bool Progress::due() {
  const auto now = Clock::now();
  if (now - shown_ < (terminal_ ? Clock::duration(kRedraw) : Clock::duration(kNextLine))) return false;
  shown_ = now;
  return true;
}

void Progress::show(const std::string& text) {
  std::fprintf(stderr, terminal_ ? "\r%s\x1b[K" : "%s\n", text.c_str());
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
