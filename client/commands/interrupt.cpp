#include "client/commands/interrupt.h"

#include <csignal>

namespace saccade {
namespace {

volatile std::sig_atomic_t noted = 0;

}  // namespace

void watchInterrupt() {
  struct sigaction action {};
  action.sa_handler = [](int) { noted = 1; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return noted != 0;
}

}  // namespace saccade
