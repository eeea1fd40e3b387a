#include "client/commands/interrupt.h"

#include <time.h>
#include <unistd.h>

#include <csignal>

namespace saccade::client {
namespace {

volatile std::sig_atomic_t noted = 0;  // when, in seconds since the machine started, plus 1

// Some programs hand one Ctrl-C on twice: only a later one means that the user is tired of waiting.
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

}  // namespace saccade::client
