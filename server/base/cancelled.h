// Work that was stopped before its end.
#pragma once

#include <exception>
#include <stop_token>

namespace saccade {

struct Cancelled : std::exception {
  const char* what() const noexcept override { return "cancelled"; }
};

inline void throwIfStopped(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
}

}  // namespace saccade
