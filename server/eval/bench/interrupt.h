// Lets SIGINT and SIGTERM stop a long command that keeps its results so far.
#pragma once

namespace saccade::eval {

// True once SIGINT or SIGTERM was received; the handler is installed by watchInterrupt().
void watchInterrupt();
bool interrupted();

// Thrown by a long command that was stopped.
struct Interrupted {};

}  // namespace saccade::eval
