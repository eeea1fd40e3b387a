// Input from pages to the viewer's WebSocket: frames, and the messages in them.
#include <algorithm>

#include "fuzz/fuzz_target.h"
#include "web/socket_pair.h"
#include "web/viewer_json.h"
#include "web/web_socket.h"

namespace saccade {
namespace {

bool parses(std::string_view text) {
  return accepts<BadViewerMessage>([&] {
    const v1::ViewerMessage message = parseViewerMessage(text);
    SACCADE_CHECK(message.message_case() != v1::ViewerMessage::MESSAGE_NOT_SET);
    SACCADE_CHECK(v1::ViewerMessage().ParseFromString(message.SerializeAsString()));
  });
}

// As Viewer does it, to the end of the bytes. Whether a frame held a message.
bool exchange(std::string_view bytes) {
  const SocketPair pair;
  bool given = false;
  WebSocket socket(pair.server(), [&](std::string_view text) {
    SACCADE_CHECK(text.size() <= WebSocket::kMaxText);
    given = parses(text) || given;
  });
  while (!bytes.empty()) {
    const ssize_t sent = send(pair.client(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
    if (!socket.exchange()) return given;
    pair.received();
  }
  return given;
}

bool read(std::string_view bytes) {
  const bool given = exchange(bytes);
  return parses(bytes) || given;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const std::string open =
      R"({"request":{"requestId":"1","protocolVersion":1,"openStream":{"scene":"a","view":{"width":1},)"
      R"("sensors":[{"threshold":0.1}],"method":{"params":{"alpha":1e-3}}}}})";
  static const FuzzTarget target{
      {open, R"({"attach":{"streamId":"a","token":"b","fromSeqs":["1",2]}})",
       R"({"subscribe":{"streamId":"a","sensor":1}})", clientFrame('\x81', R"({"request":{}})"),
       clientFrame('\x01', R"({"request)") + clientFrame('\x89', "") + clientFrame('\x80', R"(":{}})")},
      {"{",
       "}",
       "[",
       "]",
       ":",
       ",",
       "\"",
       "null",
       "true",
       "1e999",
       "-1",
       "\"NaN\"",
       "\\u0000",
       "\\ud800",
       "{\"request\":",
       "\"keyframes\":",
       "\x81\xfe",
       "\x81\xff",
       "\x88\x80",
       "\x89\x80",
       std::string(4, '\0')},
      read,
      nullptr,
      20000};
  return target;
}

}  // namespace saccade
