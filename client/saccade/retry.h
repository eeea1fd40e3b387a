// Repeats a call to a server that does not answer or is short of resources.
#pragma once

#include <chrono>
#include <functional>

#include "saccade/control_client.h"

namespace saccade::client {

struct Patience {
  std::chrono::steady_clock::time_point until;
  Waiting waiting = {};                                    // called during pauses
  bool (*mayPass)(const Refused& refused) = nullptr;       // whether the same request may be taken later
  std::function<void(const std::exception&)> failed = {};  // called at each attempt that failed
};

// CODE_UNAVAILABLE or CODE_RESOURCE_EXHAUSTED.
bool isShortage(const Refused& refused);
// CODE_UNAVAILABLE of the whole server, which is stopping or has restarted.
bool isRestart(const Refused& refused);

// Calls `attempt` until it returns. `deadline` is the time that an attempt may take; it doubles from one
// attempt to the next, as does the pause between them. After `until`, passes on NoAnswer, and Refused that
// may pass; passes on any other exception at once.
void retry(const std::function<void(std::chrono::milliseconds deadline)>& attempt, const Patience& patience);

}  // namespace saccade::client
