// Which endpoints of ZeroMQ are addresses of IPv6.
#pragma once

#include <string_view>

namespace saccade {

// Whether a socket with this endpoint needs ZMQ_IPV6: its host is in brackets, as in tcp://[::1]:5770. Others
// go without. With it a name is looked up as IPv6 alone, and a bound address of IPv4 is told in a form that
// few clients understand.
inline bool isIpv6(std::string_view endpoint) {
  return endpoint.find('[') != std::string_view::npos;
}

}  // namespace saccade
