#include "eval/bench/progress.h"

#include <unistd.h>

#include <cstdio>

namespace saccade::eval {

using std::chrono::steady_clock;

Progress::Progress(std::string what, double total)
    : what_(std::move(what)),
      total_(total),
      terminal_(isatty(2)),
      start_(steady_clock::now()),
      printed_(start_) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() const {
  if (terminal_) std::fprintf(stderr, "\r\033[K");
}

void Progress::add(double done) {
  done_ += done;
  const auto now = steady_clock::now();
  if (now - printed_ < (terminal_ ? std::chrono::milliseconds(200) : std::chrono::milliseconds(10'000)))
    return;
  printed_ = now;
  print();
}

void Progress::print() {
  const double elapsed = std::chrono::duration<double>(printed_ - start_).count();
  const double left = done_ > 0 ? elapsed * (total_ - done_) / done_ : 0;
  std::fprintf(stderr, terminal_ ? "\r\033[K%s: %.0f %%, %.0f s left" : "%s: %.0f %%, %.0f s left\n",
               what_.c_str(), 100 * done_ / total_, left);
  std::fflush(stderr);
}

}  // namespace saccade::eval
