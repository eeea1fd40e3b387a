// Addresses of ZeroMQ and HTTP, such as tcp://127.0.0.1:5770.
#pragma once

#include <string>

namespace saccade {

// Whether only this machine can connect: IP literals of loopback, localhost [RFC 6761], ipc and inproc.
bool isLoopback(const std::string& endpoint);

// The address to bind: ZeroMQ looks up no name of a host, so localhost becomes 127.0.0.1.
std::string bindable(const std::string& endpoint);

// Whether two sockets cannot both have this address: not where a free port or name is asked for.
bool hasOnePlace(const std::string& endpoint);

// Why a socket must not be bound to an address of ipc; empty: it may. ZeroMQ by itself removes whatever file
// has the name, such as the socket of a server that runs.
std::string ipcFault(const std::string& endpoint);

// The address at which this machine reaches a socket bound to `endpoint`: a wildcard becomes loopback.
std::string reachableHere(const std::string& endpoint);

}  // namespace saccade
