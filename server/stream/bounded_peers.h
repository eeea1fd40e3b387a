// Which libzmq this is.
#pragma once

namespace saccade {

// Whether libzmq bounds what peers send, as the one that deploy/libzmq/build makes does. Without bounds, a
// peer can end the process or fill its memory, SUB sockets cannot connect, and a peer's end is not told.
bool peersAreBounded();

// The warning where they are not.
inline constexpr const char* kUnboundedPeers =
    "this saccaded has the system's libzmq. It serves this machine alone, and has no broadcast streams. Any "
    "program of this machine can end it or fill its memory: the limits connections, client-connections and "
    "inbound do nothing. deploy/libzmq/README.md says how to have the rest";

}  // namespace saccade
