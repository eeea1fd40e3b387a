// Settings of a server socket: its address, its access rules, and the bounds of its queues.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "stream/client_keys.h"

namespace saccade {

// CURVE keys: only clients with a key on the list may connect.
struct ServerKeys {
  std::string secret;  // the server's own
  std::shared_ptr<ClientKeys> clients;
};

// The access rules of a socket.
struct Access {
  std::optional<ServerKeys> keys;  // none: everybody may connect
  int connections = 1024;          // at once
  int client_connections = 512;    // of one key, or of one address where there are no keys
  int inbound_mib = 256;           // messages on their way in, of all sockets of the process
};

struct SocketOptions {
  std::string endpoint;                    // port 0 or * takes a free one; IPv6 where the host is in brackets
  bool for_subscribers = false;            // true: SUB sockets connect; false: DEALERs
  std::int64_t max_part_bytes = 64 << 10;  // a peer that sends a larger part is disconnected
  int send_queue = 64;                     // messages that wait for one peer
  std::size_t send_queue_bytes = 16 << 20;  // their bytes; the last message may exceed it
  Access access;
};

}  // namespace saccade
