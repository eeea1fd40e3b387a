// One client opens what takes a quarter of an hour: the others do not notice, and it can be ended.
#include <gtest/gtest.h>

#include <csignal>
#include <future>

#include "mock/needs_libzmq.h"
#include "mock/server_process.h"
#include "mock/test_server.h"
#include "mock/wait_until.h"

namespace saccade {
namespace {

constexpr std::chrono::milliseconds kSoon{5000};
constexpr std::uint64_t kId = 77;

v1::OpenStream heavyRequest() {
  v1::OpenStream request = tinyRequest();
  request.mutable_view()->set_width(256);
  request.mutable_view()->set_height(256);
  request.mutable_method()->set_spp(4096);
  return request;
}

// A client with a heavy open under way.
class HeavyOpen {
 public:
  explicit HeavyOpen(const std::string& control) : socket_(context_, zmq::socket_type::dealer) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvtimeo, static_cast<int>(kPatience.count()));
    socket_.connect(control);
    v1::Request request;
    *request.mutable_open_stream() = heavyRequest();
    send(kId, request);
  }
  void send(std::uint64_t id, v1::Request request) {
    request.set_request_id(id);
    request.set_protocol_version(1);
    socket_.send(zmq::buffer(request.SerializeAsString()));
  }
  v1::Reply receive() {
    zmq::message_t part;
    v1::Reply reply;
    if (!socket_.recv(part) || !reply.ParseFromString(part.to_string())) throw std::runtime_error("no reply");
    return reply;
  }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

v1::StreamList list(MockClient& client) {
  v1::Request request;
  request.mutable_list_streams();
  return client.call(request).list_streams();
}

bool renders(MockClient& client) {
  const v1::StreamList all = list(client);
  return all.opening_size() == 1 && all.opening(0).doing() == "rendering frame 0";
}

class HeavyOpenTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(waitUntil([&] { return renders(client_); }, kPatience));
  }

  ServerProcess server_{{"--limit-requests", "2"}};
  MockClient client_{server_.control()};
  std::optional<HeavyOpen> heavy_{server_.control()};
};

TEST_F(HeavyOpenTest, IsSeenAndCancelled) {
  const v1::OpeningInfo info = list(client_).opening(0);
  EXPECT_EQ(info.request_id(), kId);
  EXPECT_EQ(info.scene(), "cornell-box");
  EXPECT_GT(info.elapsed_s(), 0);
  v1::Request cancel;
  cancel.mutable_cancel_open()->set_request_id(kId);
  EXPECT_EQ(client_.call(cancel).status().code(), v1::CODE_NOT_FOUND);  // it is another connection's
  const auto began = std::chrono::steady_clock::now();
  heavy_->send(kId + 1, cancel);
  const v1::Reply first = heavy_->receive(), second = heavy_->receive();
  EXPECT_LT(std::chrono::steady_clock::now() - began, kSoon);
  EXPECT_EQ(first.request_id(), kId + 1);
  EXPECT_EQ(first.status().code(), v1::CODE_OK);
  EXPECT_EQ(second.request_id(), kId);
  EXPECT_EQ(second.status().code(), v1::CODE_CANCELLED);
  EXPECT_EQ(list(client_).opening_size(), 0);
}

TEST_F(HeavyOpenTest, EndsWithItsConnection) {
  NEEDS_PATCHED_LIBZMQ();
  heavy_.reset();
  EXPECT_TRUE(waitUntil([&] { return list(client_).opening_size() == 0; }, kSoon));
}

// The only thread that renders works on both in turn.
TEST_F(HeavyOpenTest, LeavesOthersTheirTurns) {
  client_.setPatience(kSoon);
  const auto stream = client_.open(tinyRequest());
  MockSubscriber subscriber(server_.data());
  subscriber.attach(stream);
  subscriber.giveCredit(1 << 20);
  checkPackets(subscriber.receiveAll(1)[0]);
}

// Two are all that may be under way.
TEST_F(HeavyOpenTest, TakesNoPlaceOfOtherCalls) {
  HeavyOpen second(server_.control());
  ASSERT_TRUE(waitUntil([&] { return list(client_).opening_size() == 2; }, kPatience));
  EXPECT_EQ(client_.tryOpen(tinyRequest()).limit(), "requests");
  EXPECT_EQ(client_.server().threads(), 1u);
}

TEST_F(HeavyOpenTest, DoesNotDelayTheEndOfTheServer) {
  const auto began = std::chrono::steady_clock::now();
  server_.process().signal(SIGTERM);
  EXPECT_EQ(heavy_->receive().status().code(), v1::CODE_UNAVAILABLE);
  EXPECT_EQ(server_.process().finish(), 0);
  EXPECT_LT(std::chrono::steady_clock::now() - began, kSoon);
}

TEST(HeavyOpenLimits, RefuseWhatTakesHours) {
  TestServer server;
  v1::OpenStream request = tinyRequest();
  request.mutable_method()->set_spp(65536);
  request.mutable_quality()->set_bounces(64);
  const v1::Status pixel = server.client().tryOpen(request);
  EXPECT_EQ(pixel.code(), v1::CODE_RESOURCE_EXHAUSTED);
  EXPECT_EQ(pixel.limit(), "pixel-rays");
  EXPECT_EQ(pixel.field(), "method.spp");
  request = heavyRequest();
  request.mutable_view()->set_width(2048);
  request.mutable_view()->set_height(2048);
  const v1::Status frame = server.client().tryOpen(request);
  EXPECT_EQ(frame.limit(), "rays");
  EXPECT_EQ(frame.field(), "view");
}

// Their places are free once the reply has come.
TEST(ClosedStreams, TakeNoPlaces) {
  Config config = testConfig();
  config.limits[Limit::kStreams] = 1;
  TestServer server(config);
  for (int i = 0; i < 20; ++i) server.client().close(server.client().open(tinyRequest()));
  for (int i = 0; i < 5; ++i) {
    const auto stream = server.client().open(tinyRequest());
    MockSubscriber subscriber = server.dataSubscriber();
    subscriber.attach(stream);
    subscriber.giveCredit(1 << 20);
    subscriber.receiveAll(1);
    server.client().close(stream);
  }
}

}  // namespace
}  // namespace saccade
