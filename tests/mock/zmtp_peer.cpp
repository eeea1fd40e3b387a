#include "mock/zmtp_peer.h"

#include "mock/mock_client.h"

namespace saccade {

ZmtpPeer::ZmtpPeer(const std::string& endpoint, const std::string& type, const std::string& identity)
    : peer_(endpoint) {
  constexpr std::size_t kHead = 2;  // of a short frame: flags and length
  say(zmtp::greeting());
  hear(zmtp::greeting().size());
  say(zmtp::ready(type, zmtp::property("Identity", identity)));
  const std::string head = hear(kHead);
  if (head.size() == kHead) hear(static_cast<unsigned char>(head[1]));
}

std::string ZmtpPeer::hear(std::size_t count) {
  return peer_.hear(count, kPatience);
}

}  // namespace saccade
