// Addresses of ZeroMQ and HTTP, such as tcp://127.0.0.1:5770.
#pragma once

#include <string>

namespace saccade {

// Whether only this machine can connect: IP literals of loopback, the interface lo, and whatever has no
// network.
bool isLoopback(const std::string& endpoint);

// Where this machine reaches a socket that is bound to `endpoint`: loopback instead of a wildcard.
std::string reachableHere(const std::string& endpoint);

}  // namespace saccade
