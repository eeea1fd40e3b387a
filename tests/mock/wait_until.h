// Waiting for what no message tells: a condition that is asked again and again.
#pragma once

#include <chrono>
#include <thread>

namespace saccade {

// Whether `ready()` came true within `limit`.
template <class Ready>
bool waitUntil(Ready ready, std::chrono::milliseconds limit) {
  const auto deadline = std::chrono::steady_clock::now() + limit;
  while (!ready()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace saccade
