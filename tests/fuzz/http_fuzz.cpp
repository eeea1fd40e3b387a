// Bytes to a server's HTTP port, over a real connection.
#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include "fuzz/fuzz_target.h"
#include "ops/http_server.h"

namespace saccade {
namespace {

constexpr char kBody[] = "a body that is ours";

// Sends the bytes, says that no more will come, and reads to the end.
std::string exchange(const HttpServer& server, std::string_view bytes) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const std::string port = server.endpoint().substr(server.endpoint().rfind(':') + 1);
  address.sin_port = htons(static_cast<std::uint16_t>(std::stoi(port)));
  const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  SACCADE_CHECK(connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  shutdown(fd, SHUT_WR);
  std::string answer;
  char buffer[4096];
  for (ssize_t n; (n = recv(fd, buffer, sizeof buffer, 0)) > 0;) answer.append(buffer, n);
  close(fd);
  return answer;
}

bool read(std::string_view bytes) {
  static const HttpServer server("http://127.0.0.1:0", {{"/page", [] { return HttpAnswer{.body = kBody}; }}});
  const std::string answer = exchange(server, bytes);
  const bool given = answer.starts_with("HTTP/1.1 200 ");
  SACCADE_CHECK(!given || answer.ends_with(kBody) ||
                answer.ends_with("\r\n\r\n"));  // to HEAD: the head alone
  return given;
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"GET /page HTTP/1.1\r\nHost: x\r\n\r\n",
       "HEAD /page?a=%20 HTTP/1.0\r\nContent-Length: 2\r\nConnection: keep-alive\r\n\r\nab"},
      {"GET ",
       "HEAD ",
       "POST ",
       "CONNECT ",
       "/page",
       "/",
       "%2e%2e/",
       "%",
       " HTTP/1.1",
       "\r\n",
       "\r\n\r\n",
       "Host: ",
       "Content-Length: ",
       "Transfer-Encoding: chunked\r\n",
       "Expect: 100-continue\r\n",
       "Upgrade: websocket\r\n",
       "Range: bytes=0-1\r\n",
       "Authorization: Digest ",
       "-1",
       "99999999999999999999",
       std::string(1, '\0')},
      read,
      nullptr,
      300};
  return target;
}

}  // namespace saccade
