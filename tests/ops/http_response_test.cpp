#include "ops/http_response.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace saccade {
namespace {

std::string responseTo(const std::string& head) {
  const HttpPages pages{{"/page", [] { return HttpAnswer{.body = "text"}; }},
                        {"/broken", []() -> HttpAnswer { throw std::runtime_error("no memory"); }}};
  return httpResponse(head + "\r\n\r\n", pages);
}

int statusOf(const std::string& head) {
  return std::stoi(responseTo(head).substr(9));
}

TEST(HttpResponse, IsThePageThatWasAsked) {
  for (const char* line :
       {"GET /page HTTP/1.1", "GET /page HTTP/1.0\r\nHost: x", "GET /page?a=%20 HTTP/1.1"}) {
    const std::string response = responseTo(line);
    EXPECT_TRUE(response.starts_with("HTTP/1.1 200 OK\r\n")) << response;
    EXPECT_NE(response.find("\r\nContent-Length: 4\r\n"), response.npos);
    EXPECT_TRUE(response.ends_with("\r\nConnection: close\r\n\r\ntext")) << response;
  }
}

TEST(HttpResponse, ToHeadIsTheHeadAlone) {
  const std::string response = responseTo("HEAD /page HTTP/1.1");
  EXPECT_NE(response.find("\r\nContent-Length: 4\r\n"), response.npos);
  EXPECT_TRUE(response.ends_with("\r\n\r\n"));
}

TEST(HttpResponse, SaysWhatItCannotDo) {
  EXPECT_EQ(statusOf("GET /none HTTP/1.1"), 404);
  EXPECT_EQ(statusOf("GET /page/ HTTP/1.1"), 404);
  EXPECT_EQ(statusOf("GET /../page HTTP/1.1"), 404);
  EXPECT_EQ(statusOf("GET /broken HTTP/1.1"), 500);
  EXPECT_EQ(statusOf("POST /page HTTP/1.1"), 405);
  EXPECT_NE(responseTo("POST /page HTTP/1.1").find("\r\nAllow: GET, HEAD\r\n"), std::string::npos);
  for (const char* line : {"", "GET", "GET /page", "GET /page FTP/1.1", "GET  HTTP/2"})
    EXPECT_EQ(statusOf(line), 400);
  EXPECT_TRUE(httpTooLong().starts_with("HTTP/1.1 431 "));
}

}  // namespace
}  // namespace saccade
