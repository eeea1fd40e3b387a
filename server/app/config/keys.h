// Access rules of the sockets and of the viewer, from the configuration.
#pragma once

#include <optional>

#include "app/config/config.h"
#include "saccade/socket.h"
#include "stream/socket_loop.h"

namespace saccade {

// The keys and connection limits of all sockets. Throws std::runtime_error or std::invalid_argument naming
// the option: only one of the two key files is given, or one cannot be read. Throws too if an address is open
// to other machines without keys and without `insecure`.
Access openAccess(const Config& config);

// The keys with which viewers are clients of this server; nothing: there are no viewers. Throws as
// openAccess(), also where a viewer is wanted and cannot be.
std::optional<client::CurveKeys> openViewer(const Config& config, const Access& access);

}  // namespace saccade
