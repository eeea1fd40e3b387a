// Peers by the descriptor of their connection. For a libzmq that does not tell the end of a peer: see
// bounded_peers.h.
#pragma once

#include <map>
#include <string>
#include <utility>

namespace saccade {

class DescriptorOwners {
 public:
  // `peer` speaks on the connection with this file descriptor. Returns the peer that had it before and is
  // gone; empty: there was none. Descriptors below 0 are of no connection.
  std::string take(int descriptor, const std::string& peer) {
    if (descriptor < 0) return {};
    std::string& owner = owners_[descriptor];
    return owner == peer ? std::string() : std::exchange(owner, peer);
  }

 private:
  std::map<int, std::string> owners_;  // no more than the process has descriptors
};

}  // namespace saccade
