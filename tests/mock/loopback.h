// TCP on loopback, as plain as sockets are.
#pragma once

#include <cstdint>
#include <string>

namespace saccade {

std::uint16_t portOf(const std::string& endpoint);  // of tcp://host:port
int connectLoopback(std::uint16_t port);            // a socket; -1: refused
int listenOnLoopback(std::uint16_t& port);          // on a free port; aborts where there is none
void resetOnClose(int fd);                          // close() sends RST, not FIN

}  // namespace saccade
