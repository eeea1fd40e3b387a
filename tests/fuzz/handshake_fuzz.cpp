// Bytes of a peer from the beginning of its connection: greeting, metadata, a request. In any case, the
// server answers the next client.
#include <algorithm>
#include <zmq.hpp>

#include "fuzz/fuzz_target.h"
#include "mock/raw_peer.h"
#include "mock/zmtp.h"
#include "stream/data_server.h"

namespace saccade {
namespace {

constexpr char kAsked[] = "mutant";
constexpr std::size_t kGreetingBytes = 64;

// Its answer names the stream.
std::string request(const std::string& stream_id) {
  v1::DataRequest request;
  request.mutable_attach()->set_stream_id(stream_id);
  return request.SerializeAsString();
}

struct World {
  World() {
    server.start();
    client.set(zmq::sockopt::linger, 0);
    client.set(zmq::sockopt::rcvtimeo, 10'000);
    client.connect(server.endpoint());
  }

  void expectServed() {
    zmq::message_t head, payload;
    client.send(zmq::buffer(request("none")));
    SACCADE_CHECK(client.recv(head) && head.more() && client.recv(payload) && !payload.more());
  }

  SessionDirectory sessions;
  DataServer server{"tcp://127.0.0.1:*", sessions, std::int64_t{1} << 32};
  zmq::context_t context;
  zmq::socket_t client{context, zmq::socket_type::dealer};
};

// Whether the answer to the request comes. An input that waits for more bytes is not waited for.
bool isAnswered(RawPeer& peer, std::chrono::milliseconds patience) {
  std::string answer;
  for (std::string byte = "?"; !byte.empty() && answer.find(kAsked) == answer.npos; answer += byte)
    byte = peer.hear(1, patience);
  return answer.find(kAsked) != answer.npos;
}

bool read(std::string_view bytes) {
  static World world;
  const auto& seeds = fuzzTarget().seeds;
  const bool seed = std::find(seeds.begin(), seeds.end(), bytes) != seeds.end();
  const std::chrono::milliseconds patience(seed ? 10'000 : 5);
  bool answered = false;
  {
    RawPeer peer(world.server.endpoint());
    peer.say(std::string(bytes.substr(0, kGreetingBytes)));
    peer.hear(kGreetingBytes, patience);  // libzmq refuses who says more before it has said as much
    peer.say(std::string(bytes.substr(std::min(bytes.size(), kGreetingBytes))));
    answered = isAnswered(peer, patience);
  }
  world.expectServed();
  return answered;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  using namespace zmtp;
  using namespace std::string_literals;
  const std::string asks = frame(0, request(kAsked));
  static const FuzzTarget target{
      {greeting() + ready("DEALER") + asks, greeting() + ready("DEALER", property("Identity", "")) + asks,
       greeting() + ready("REQ", property("X-Name", "value")) + frame(kCommand, "\x04PING\0\x0A"s) + asks},
      {"\xFF",
       "\x7F",
       "\x03",
       "\x02",
       "\x01",
       "NULL",
       "PLAIN",
       "CURVE",
       "GSSAPI",
       "DEALER",
       "ROUTER",
       "SUB",
       "REQ",
       frame(kCommand, "\x05READY"),
       frame(kCommand, "\x05HELLO"),
       frame(kCommand,
             "\x05"
             "ERROR\x03"
             "why"),
       frame(kCommand, "\x09SUBSCRIBE"),
       frame(kCommand, "\x04PING"),
       property("Identity", "alice"),
       property("Identity", std::string(300, 'a')),
       property("User-Id", "alice"),
       property("", ""),
       property("Socket-Type", "DEALER"),
       bigEndian(std::uint64_t{1} << 63, 8),
       bigEndian(0xFFFFFFFF, 4),
       frame(kMore, "part"),
       asks,
       std::string(1, '\0')},
      read,
      nullptr,
      400};
  return target;
}

}  // namespace saccade
