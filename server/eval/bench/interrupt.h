// A long command that SIGINT or SIGTERM stops keeps what is done.
#pragma once

namespace saccade::eval {

// True once SIGINT or SIGTERM was received; the handler is installed by watchInterrupt().
void watchInterrupt();
bool interrupted();

// Thrown when a long command was stopped; what was done is kept.
struct Interrupted {};

}  // namespace saccade::eval
