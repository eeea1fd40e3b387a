// Ctrl-C as a question that a loop can ask.
#pragma once

namespace saccade::client {

// Makes SIGINT and SIGTERM set interrupted(). A second one, at least a second later, ends the program.
void watchInterrupt();
bool interrupted();
void throwIfInterrupted();  // throws StreamFault

}  // namespace saccade::client
