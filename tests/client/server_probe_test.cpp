#include "saccade/server_probe.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>
#include <zmq.hpp>

namespace saccade::client {
namespace {

std::string faultOf(const std::string& endpoint) {
  try {
    checkEndpoint(endpoint);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return {};
}

TEST(ServerProbe, AnEndpointHasAPortAndAHost) {
  EXPECT_EQ(faultOf("tcp://127.0.0.1:5770"), "");
  EXPECT_EQ(faultOf("tcp://[::1]:5770"), "");
  EXPECT_EQ(faultOf("ipc:///run/saccade"), "");
  for (const std::string port : {":99999", ":0", ":-1", ":x", ":", ""})
    EXPECT_NE(faultOf("tcp://127.0.0.1" + port).find("a port from 1 to 65535"), std::string::npos) << port;
  EXPECT_EQ(faultOf("tcp://no-such-host.invalid:5770"), "no host is named 'no-such-host.invalid'");
}

std::string explain(const std::string& endpoint, bool has_keys) {
  return explainSilence(NoAnswer(endpoint, has_keys));
}

// A ROUTER that never answers, as the data socket does to a request.
class SilentSocket {
 public:
  explicit SilentSocket(bool keys) {
    if (keys) {
      char public_key[41], secret_key[41];
      zmq_curve_keypair(public_key, secret_key);
      socket_.set(zmq::sockopt::curve_server, true);
      socket_.set(zmq::sockopt::curve_secretkey, secret_key);
    }
    socket_.bind("tcp://127.0.0.1:*");
  }
  std::string endpoint() const { return socket_.get(zmq::sockopt::last_endpoint); }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_{context_, zmq::socket_type::router};
};

TEST(ServerProbe, WithoutAServerTheAdviceIsToStartIt) {
  EXPECT_EQ(explain("tcp://127.0.0.1:1", false),
            "no saccaded answers at tcp://127.0.0.1:1: start it with `saccaded --control tcp://127.0.0.1:1`");
}

TEST(ServerProbe, AnotherSocketIsTakenForTheDataPort) {
  const SilentSocket data(false);
  EXPECT_NE(explain(data.endpoint(), false).find("is it the data or broadcast port?"), std::string::npos);
}

TEST(ServerProbe, MissingOrNeedlessKeysAreTold) {
  const SilentSocket open(false), closed(true);
  EXPECT_NE(explain(closed.endpoint(), false).find("it wants keys"), std::string::npos);
  EXPECT_NE(explain(closed.endpoint(), true).find("is your key on its list"), std::string::npos);
  EXPECT_NE(explain(open.endpoint(), true).find("it has no keys"), std::string::npos);
}

// It accepts and says nothing, as an HTTP server does.
TEST(ServerProbe, APortThatDoesNotSpeakZeroMqIsTakenForHttp) {
  const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(listen(listener, 1), 0);
  ASSERT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const std::string endpoint = "tcp://127.0.0.1:" + std::to_string(ntohs(address.sin_port));
  EXPECT_NE(explain(endpoint, false).find("is it the HTTP port?"), std::string::npos);
  close(listener);
}

}  // namespace
}  // namespace saccade::client
