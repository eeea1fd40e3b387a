// Asks a server again that does not answer, or that cannot yet do what it is asked.
#pragma once

#include <chrono>
#include <functional>

#include "client/control_client.h"

namespace saccade::client {

// Calls `attempt` until it returns. It may take `deadline`, which doubles from one attempt to the next, as
// the pause between them. Throws what it throws: NoAnswer, or Refused for want of resources, once `until` has
// passed; anything else at once.
void retry(const std::function<void(std::chrono::milliseconds deadline)>& attempt,
           std::chrono::steady_clock::time_point until, const Waiting& waiting);

}  // namespace saccade::client
