// What the bounds of the sockets have kept out.
#pragma once

namespace saccade {

// Connections that were refused, or cut for what they sent, since the process started.
int refusedConnections();

}  // namespace saccade
