#include "eval/bench/interrupt.h"

#include <csignal>

namespace saccade::eval {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

}  // namespace

void watchInterrupt() {
  std::signal(SIGINT, [](int) { g_interrupted = 1; });
  std::signal(SIGTERM, [](int) { g_interrupted = 1; });
}

bool interrupted() {
  return g_interrupted != 0;
}

}  // namespace saccade::eval
