// Access rules of the sockets, from the configuration.
#pragma once

#include "app/config/config.h"
#include "stream/socket_loop.h"

namespace saccade {

// The keys and connection limits of all sockets. Throws std::runtime_error or std::invalid_argument naming
// the option: only one of the two key files is given, a key file cannot be read, or an address is open to
// other machines without keys and without `insecure`.
Access openAccess(const Config& config);

}  // namespace saccade
