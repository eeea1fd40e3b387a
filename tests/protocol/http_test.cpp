// The pages that machines watch.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "mock/loopback.h"
#include "mock/mock_http.h"
#include "mock/needs_libzmq.h"
#include "mock/test_server.h"
#include "ops/http_server.h"

namespace saccade {
namespace {

Config withHttp() {
  Config config = testConfig();
  config.http = "http://127.0.0.1:0";
  return config;
}

class Http : public testing::Test {
 protected:
  HttpReply get(const std::string& path) { return httpGet(server_.app().httpEndpoint(), path); }
  // The value of a line of /metrics, such as saccade_lag_seconds or saccade_streams{delivery="live"}.
  double metric(const std::string& name) {
    const std::string text = "\n" + get("/metrics").body;
    const auto line = text.find("\n" + name + " ");
    if (line == std::string::npos) ADD_FAILURE() << name << " is not in\n" << text;
    return line == std::string::npos ? 0 : std::atof(text.c_str() + line + name.size() + 2);
  }
  TestServer server_{withHttp()};
};

TEST_F(Http, CountsWhatClientsHaveReceived) {
  const auto packets = server_.run(tinyRequest())[0];
  double bytes = 0, events = 0;
  for (const auto& packet : packets) {
    bytes += static_cast<double>(packet.bytes);
    events += packet.header.count();
  }
  EXPECT_EQ(metric("saccade_frames_total"), 20);
  EXPECT_EQ(metric("saccade_events_total"), events);
  EXPECT_EQ(metric("saccade_sent_packets_total"), static_cast<double>(packets.size()));
  EXPECT_EQ(metric("saccade_sent_bytes_total"), bytes);
  EXPECT_EQ(metric("saccade_dropped_packets_total"), 0);
  EXPECT_EQ(metric("saccade_scene_loads_total{result=\"ok\"}"), 1);
  EXPECT_GT(metric("saccade_frame_cpu_seconds_total{stage=\"trace\"}"), 0);
  EXPECT_GT(metric("process_open_fds"), 3);
}

// A LIVE stream with credit for its first packet only: what it was sent and what was dropped is all there
// was.
TEST_F(Http, CountsWhatWasDropped) {
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_LIVE);
  request.mutable_view()->set_width(256);
  request.mutable_view()->set_height(192);
  request.mutable_sensors(0)->set_threshold(0.005);
  request.mutable_timing()->set_duration_s(0.04);
  const auto stream = server_.client().open(request);
  MockSubscriber subscriber = server_.dataSubscriber();
  subscriber.attach(stream);
  subscriber.giveCredit(1);
  ASSERT_TRUE(subscriber.receive());
  while (server_.client().info(stream.stream_id()).frames_done() < 20) std::this_thread::yield();
  while (metric("saccade_streams{delivery=\"live\"}") > 0) std::this_thread::yield();
  const double dropped = static_cast<double>(server_.client().info(stream.stream_id()).dropped_packets());
  EXPECT_GT(dropped, 0);
  EXPECT_EQ(metric("saccade_dropped_packets_total"), dropped);
}

TEST_F(Http, CountsStreamsByDelivery) {
  NEEDS_PATCHED_LIBZMQ();
  v1::OpenStream request = tinyRequest();
  request.set_delivery(v1::DELIVERY_BROADCAST);
  const auto stream = server_.client().open(request);
  EXPECT_EQ(metric("saccade_streams{delivery=\"broadcast\"}"), 1);
  EXPECT_EQ(metric("saccade_streams{delivery=\"lossless\"}"), 0);
  EXPECT_EQ(get("/metrics").body.find(stream.stream_id()), std::string::npos);
}

TEST_F(Http, CountsRequestsByCallAndCode) {
  v1::OpenStream wrong = tinyRequest();
  wrong.set_scene("no such scene");
  server_.run(tinyRequest());
  for (int i = 0; i < 2; ++i) server_.client().tryOpen(wrong);
  server_.client().call({});
  const std::string name = "saccade_requests_total";
  EXPECT_EQ(metric(name + "{call=\"open_stream\",code=\"ok\"}"), 1);
  EXPECT_EQ(metric(name + "{call=\"open_stream\",code=\"not_found\"}"), 2);
  EXPECT_EQ(metric(name + "{call=\"none\",code=\"unimplemented\"}"), 1);
}

TEST_F(Http, PromtoolFindsNoFault) {
  if (std::system("command -v promtool >/dev/null") != 0) GTEST_SKIP() << "promtool is not installed";
  server_.run(tinyRequest());
  const std::string file = testing::TempDir() + "http_test.metrics";
  std::ofstream(file) << get("/metrics").body;
  EXPECT_EQ(std::system(("promtool check metrics < " + file).c_str()), 0);
}

TEST_F(Http, IsNotReadyAsSoonAsItStops) {
  EXPECT_EQ(get("/healthz").status, 200);
  EXPECT_EQ(get("/readyz").status, 200);
  const auto stream = server_.client().open(tinyRequest());
  MockSubscriber subscriber = server_.dataSubscriber();
  subscriber.attach(stream);  // and takes nothing: stop() waits for it
  subscriber.giveCredit(1);
  ASSERT_TRUE(subscriber.receive());
  std::thread stop([&] { EXPECT_TRUE(server_.app().stop()); });
  while (server_.app().ready()) std::this_thread::yield();
  EXPECT_EQ(get("/readyz").status, 503);
  EXPECT_EQ(get("/healthz").status, 200);
  for (const std::string page : {"/", "/viewer.js", "/viewer"}) {
    EXPECT_EQ(get(page).status, 503) << page;
    EXPECT_EQ(get(page).body, "the server is stopping\n");
  }
  EXPECT_EQ(metric("saccade_ready"), 0);  // a last scrape
  EXPECT_EQ(server_.client().tryOpen(tinyRequest()).code(), v1::CODE_UNAVAILABLE);
  subscriber.giveCredit(1 << 20);
  subscriber.receiveAll(1);
  stop.join();
}

TEST_F(Http, AnswersWhatItKnows) {
  EXPECT_EQ(get("/nothing").status, 404);
  EXPECT_EQ(get("/metrics/more").status, 404);
  const std::string endpoint = server_.app().httpEndpoint();
  const auto post =
      httpSend(endpoint, "POST /metrics HTTP/1.1\r\nHost: a\r\nContent-Length: 9\r\n\r\n");  // and no body
  EXPECT_EQ(post.status, 405);
  EXPECT_NE(post.head.find("\r\nAllow: GET, HEAD\r\n"), std::string::npos) << post.head;
  const auto head = httpSend(endpoint, "HEAD /healthz HTTP/1.1\r\nHost: a\r\n\r\n");
  EXPECT_EQ(head.status, 200);
  EXPECT_NE((head.head + "\r\n").find("\r\nContent-Length: 6\r\n"), std::string::npos) << head.head;
  EXPECT_EQ(head.body, "");
  EXPECT_EQ(httpSend(endpoint, "\x16\x03\x01 garbage\r\n\r\n").status / 100 % 4, 0);  // 400, or none
  EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(Http, AnAddressInUseIsAnError) {
  const std::string endpoint = server_.app().httpEndpoint();
  try {
    HttpServer again(endpoint, {});
    ADD_FAILURE() << "two servers have one address";
  } catch (const std::runtime_error& fault) {
    EXPECT_EQ(fault.what(), "cannot listen on " + endpoint + ": Address already in use");
  }
  EXPECT_THROW(HttpServer("127.0.0.1:0", {}), std::runtime_error);
}

TEST(HttpServer, APageThatThrowsIsAnError) {
  const HttpServer server("http://127.0.0.1:0",
                          {{"/page", []() -> HttpAnswer { throw std::runtime_error("no memory"); }}});
  EXPECT_EQ(httpGet(server.endpoint(), "/page").status, 500);
}

// At once, and not when the oldest has been silent for too long: it may send a byte now and then.
TEST(HttpServer, CutsOffTheOldestOfTooMany) {
  rlimit before{};
  getrlimit(RLIMIT_NOFILE, &before);
  const rlimit few{64, before.rlim_max};
  setrlimit(RLIMIT_NOFILE, &few);  // a quarter: 16 clients
  {
    const HttpServer server("http://127.0.0.1:0", {{"/page", [] { return HttpAnswer{}; }}});
    const auto began = std::chrono::steady_clock::now();
    std::vector<int> clients;
    for (int i = 0; i < 17; ++i) clients.push_back(connectLoopback(portOf(server.endpoint())));
    char byte;
    EXPECT_EQ(recv(clients.front(), &byte, 1, 0), 0);
    EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(1));
    EXPECT_EQ(recv(clients.back(), &byte, 1, MSG_DONTWAIT), -1);
    EXPECT_EQ(httpGet(server.endpoint(), "/page").status, 200);
    for (const int client : clients) close(client);
  }
  setrlimit(RLIMIT_NOFILE, &before);
}

}  // namespace
}  // namespace saccade
