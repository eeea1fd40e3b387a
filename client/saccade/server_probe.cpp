#include "saccade/server_probe.h"

#include <netdb.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <stdexcept>
#include <string_view>

namespace saccade::client {
namespace {

constexpr std::string_view kScheme = "tcp://";

struct Address {
  std::string host, port;
};

Address splitEndpoint(const std::string& endpoint) {
  const std::string rest = endpoint.substr(kScheme.size());
  const std::size_t colon = std::min(rest.rfind(':'), rest.size());
  std::string host = rest.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  return {host, rest.substr(std::min(colon + 1, rest.size()))};
}

bool isPort(std::string_view text) {
  int port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port >= 1 && port <= 65535;
}

using AddressList = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

AddressList lookUp(const Address& address) {
  addrinfo hints{}, *found = nullptr;
  hints.ai_socktype = SOCK_STREAM;
  if (getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &found) != 0) found = nullptr;
  return {found, freeaddrinfo};
}

// The opening of ZMTP 3.0, the protocol of ZeroMQ, has 64 bytes: signature, version, mechanism, and more. The
// peer sends the whole of its own once it knows our version.
constexpr std::array<char, 12> kOurVersion{'\xFF', 0, 0, 0, 0, 0, 0, 0, 0, '\x7F', 3, 0};
constexpr std::size_t kGreetingBytes = 64, kMechanismAt = 12;

enum class Peer { kNobody, kNotZeroMq, kWithoutKeys, kWithKeys };

Peer readGreeting(int peer) {
  const timeval timeout{1, 0};
  setsockopt(peer, SOL_SOCKET, SO_RCVTIMEO, &timeout, sizeof timeout);
  std::array<char, kGreetingBytes> greeting{};
  if (send(peer, kOurVersion.data(), kOurVersion.size(), MSG_NOSIGNAL) < 0) return Peer::kNotZeroMq;
  const ssize_t size = recv(peer, greeting.data(), greeting.size(), MSG_WAITALL);
  if (size != ssize_t{kGreetingBytes} || greeting[0] != '\xFF' || greeting[9] != '\x7F')
    return Peer::kNotZeroMq;
  const std::string_view mechanism(&greeting[kMechanismAt], kGreetingBytes - kMechanismAt);
  return mechanism.starts_with("CURVE") ? Peer::kWithKeys : Peer::kWithoutKeys;
}

Peer probe(const Address& address) {
  const AddressList list = lookUp(address);
  if (!list) return Peer::kNobody;
  const int peer = socket(list->ai_family, list->ai_socktype | SOCK_CLOEXEC, list->ai_protocol);
  if (peer < 0) return Peer::kNobody;
  const timeval timeout{1, 0};
  setsockopt(peer, SOL_SOCKET, SO_SNDTIMEO, &timeout, sizeof timeout);  // also of connect()
  const bool connected = connect(peer, list->ai_addr, list->ai_addrlen) == 0;
  const Peer kind = connected ? readGreeting(peer) : Peer::kNobody;
  close(peer);
  return kind;
}

}  // namespace

void checkEndpoint(const std::string& endpoint) {
  if (endpoint.starts_with("ipc://") || endpoint.starts_with("inproc://")) return;
  if (!endpoint.starts_with(kScheme))
    throw std::invalid_argument("'" + endpoint + "' is not an endpoint such as tcp://127.0.0.1:5770");
  const Address address = splitEndpoint(endpoint);
  if (!isPort(address.port))
    throw std::invalid_argument("'" + endpoint +
                                "' needs a port from 1 to 65535, as in tcp://127.0.0.1:5770");
  if (!lookUp(address)) throw std::invalid_argument("no host is named '" + address.host + "'");
}

std::string explainSilence(const NoAnswer& silence) {
  const std::string& endpoint = silence.endpoint;
  const std::string start =
      std::string(silence.what()) + ": start it with `saccaded --control " + endpoint + "`";
  if (!endpoint.starts_with(kScheme)) return start;
  const Peer peer = probe(splitEndpoint(endpoint));
  if (peer == Peer::kNobody) return start;
  const std::string here = "something listens at " + endpoint + ", but ";
  if (peer == Peer::kNotZeroMq)
    return here + "it is not a control socket; is it the HTTP port? The control port is 5770 by default";
  if (peer == Peer::kWithKeys && !silence.has_keys)
    return here + "it wants keys: give --secret-key and --server-key";
  if (peer == Peer::kWithKeys)
    return here + "it does not answer: is your key on its list, and --server-key its public key?";
  if (silence.has_keys) return here + "it has no keys: leave out --secret-key and --server-key";
  return here + "it does not answer; is it the data or broadcast port? The control port is 5770 by default";
}

}  // namespace saccade::client
