// A count of refused connections.
#pragma once

namespace saccade {

// Connections that a limit refused, or that were cut for what they sent, since the process started.
int refusedConnections();

}  // namespace saccade
