// Ctrl-C, asked for instead of handled.
#pragma once

namespace saccade {

void watchInterrupt();  // from now on the first Ctrl-C is only noted; the second ends the program
bool interrupted();

}  // namespace saccade
