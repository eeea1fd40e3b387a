// Repeats a call to a server that does not answer or is short of resources.
#pragma once

#include <chrono>
#include <functional>

#include "client/control_client.h"

namespace saccade::client {

// Calls `attempt` until it returns. `deadline` is the time that an attempt may take; it doubles from one
// attempt to the next, as does the pause between them. After `until`, passes on NoAnswer and Refused of
// CODE_UNAVAILABLE or CODE_RESOURCE_EXHAUSTED; passes on any other exception at once.
void retry(const std::function<void(std::chrono::milliseconds deadline)>& attempt,
           std::chrono::steady_clock::time_point until, const Waiting& waiting);

}  // namespace saccade::client
