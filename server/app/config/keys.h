// Who may connect, by the configuration.
#pragma once

#include "app/config/config.h"
#include "stream/socket_loop.h"

namespace saccade {

// Of all sockets. Throws std::runtime_error or std::invalid_argument naming the option: keys are given by
// halves or cannot be read, or there are none, and an address is open to other machines, and `insecure` does
// not say that this is meant.
Access openAccess(const Config& config);

}  // namespace saccade
