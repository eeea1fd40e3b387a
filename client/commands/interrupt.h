// Ctrl-C, asked for instead of handled.
#pragma once

namespace saccade::client {

// From now on Ctrl-C is only noted; another one, a second or more later, ends the program.
void watchInterrupt();
bool interrupted();

}  // namespace saccade::client
