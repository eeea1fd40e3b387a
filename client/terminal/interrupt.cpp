#include "client/terminal/interrupt.h"

#include <time.h>
#include <unistd.h>

#include <csignal>

#include "saccade/stream_fault.h"

namespace saccade::client {
namespace {

volatile std::sig_atomic_t noted =
    0;  // time of the first signal on the monotonic clock, in seconds, plus 1; 0: none

// Some programs pass one Ctrl-C on twice, so a second signal counts only after a second.
void note(int) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (noted != 0 && now.tv_sec > noted) _exit(1);
  if (noted == 0) noted = static_cast<std::sig_atomic_t>(now.tv_sec + 1);
}

}  // namespace

void watchInterrupt() {
  struct sigaction action {};
  action.sa_handler = note;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return noted != 0;
}

void throwIfInterrupted() {
  if (interrupted()) throw StreamFault("interrupted");
}

}  // namespace saccade::client
