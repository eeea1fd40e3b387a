#include "web/web_handshake.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace saccade {
namespace {

using Headers = std::map<std::string, std::string>;

// The headers that a browser sends from a page of the server.
Headers headersAt(const std::string& host) {
  return {{"Host", host},
          {"Origin", "http://" + host},
          {"Upgrade", "WebSocket"},
          {"Sec-WebSocket-Version", "13"},
          {"Sec-WebSocket-Key", "dGhlIHNhbXBsZSBub25jZQ=="}};
}

HttpAnswer answerTo(const Headers& headers, bool loopback_only = true) {
  return answerHandshake(
      [&](const char* name) { return headers.contains(name) ? headers.at(name) : std::string(); },
      loopback_only);
}

int statusWithout(const char* name) {
  Headers headers = headersAt("localhost:5773");
  headers.erase(name);
  return answerTo(headers).status;
}

TEST(WebHandshake, AcceptsTheExampleOfTheStandard) {  // [RFC 6455, section 1.3]
  EXPECT_EQ(acceptOf("dGhlIHNhbXBsZSBub25jZQ=="), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
  const HttpAnswer answer = answerTo(headersAt("localhost:5773"));
  EXPECT_EQ(answer.status, 101);
  EXPECT_EQ(answer.headers.at("Sec-WebSocket-Accept"), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
}

TEST(WebHandshake, NeedsEachHeader) {
  EXPECT_EQ(statusWithout("Host"), 403);
  EXPECT_EQ(statusWithout("Origin"), 403);
  EXPECT_EQ(statusWithout("Upgrade"), 426);
  EXPECT_EQ(statusWithout("Sec-WebSocket-Version"), 426);
  EXPECT_EQ(statusWithout("Sec-WebSocket-Key"), 400);
}

TEST(WebHandshake, TakesPagesOfTheSameHostAlone) {
  Headers headers = headersAt("render7:5773");
  headers["Origin"] = "https://render7:5773";  // behind a proxy with TLS
  EXPECT_EQ(answerTo(headers, false).status, 101);
  for (const char* origin : {"http://render7", "http://render7:5774", "http://evil/render7:5773", "null"}) {
    headers["Origin"] = origin;
    EXPECT_EQ(answerTo(headers, false).status, 403) << origin;
  }
}

TEST(WebHandshake, OnLoopbackTakesNamesOfLoopbackAlone) {
  for (const char* host : {"localhost", "localhost:8080", "127.0.0.1:5773", "[::1]:5773", "[::1]"})
    EXPECT_EQ(answerTo(headersAt(host)).status, 101) << host;
  for (const char* host : {"render7:5773", "localhost.evil.example", "127.0.0.1.evil.example:5773"})
    EXPECT_EQ(answerTo(headersAt(host)).status, 403) << host;
}

}  // namespace
}  // namespace saccade
