#include "stream/control_server.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>

#include "mock/mock_client.h"
#include "mock/wait_until.h"
#include "saccade/wire/protocol.h"

namespace saccade {
namespace {

const ControlServer::Options kOptions{.endpoint = "tcp://127.0.0.1:*", .request_bytes = 1 << 20};

// An answer that takes its time, as a scene that is being loaded does, keeps nobody else waiting.
TEST(ControlServer, ASlowAnswerDelaysNoOther) {
  RequestCounts counts;
  ControlServer server(kOptions, counts);
  std::promise<Answer> slow;
  server.start([&](const RawRequest& request, const Peer&, Answer answer) {
    if (request.call == v1::Request::kOpenStream) return slow.set_value(std::move(answer));
    v1::Reply reply;
    reply.mutable_server_info()->set_version("quick");
    answer(std::move(reply));
  });
  MockClient patient(server.endpoint()), hasty(server.endpoint());
  auto opened = std::async(std::launch::async, [&] { return patient.tryOpen({}); });
  const Answer answer = slow.get_future().get();  // the server has it
  EXPECT_EQ(hasty.server().version(), "quick");
  v1::Reply late;
  *late.mutable_status() = makeStatus(v1::CODE_UNAVAILABLE, "late");
  answer(late);
  EXPECT_EQ(opened.get().message(), "late");
}

// The message cites scene files and their names.
TEST(ControlServer, AStatusCanBeReadWhateverItsMessageCites) {
  const v1::Status status = makeStatus(v1::CODE_UNAVAILABLE, "x\xFF" + std::string(1 << 20, '\xC3'));
  EXPECT_TRUE(v1::Status().ParseFromString(status.SerializeAsString()));
  EXPECT_LT(status.ByteSizeLong(), 5000u);
}

v1::Reply replyOf(std::size_t bytes) {
  v1::Reply reply;
  *reply.mutable_status() = okStatus();
  reply.mutable_server_info()->set_version(std::string(bytes, 'x'));
  return reply;
}

// A DEALER that takes one reply, and lets the others wait.
class LazyPeer {
 public:
  explicit LazyPeer(const std::string& endpoint) : socket_(context_, zmq::socket_type::dealer) {
    socket_.set(zmq::sockopt::linger, 0);
    socket_.set(zmq::sockopt::rcvhwm, 1);
    socket_.set(zmq::sockopt::rcvtimeo, static_cast<int>(kPatience.count()));
    socket_.connect(endpoint);
  }
  void ask() {
    v1::Request request;
    request.set_protocol_version(kProtocolVersion);
    request.mutable_server_info();
    socket_.send(zmq::buffer(request.SerializeAsString()));
  }
  v1::Status read() {
    zmq::message_t part;
    v1::Reply reply;
    if (!socket_.recv(part) || !reply.ParseFromArray(part.data(), static_cast<int>(part.size())))
      throw std::runtime_error("no reply");
    return reply.status();
  }

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
};

// Replies that fit into the buffers between the two are not counted: these are larger.
TEST(ControlServer, RefusesAClientThatDoesNotReadItsReplies) {
  constexpr int kRequests = 200;
  constexpr std::size_t kReplyBytes = 1 << 20;
  RequestCounts counts;
  ControlServer server(kOptions, counts);
  std::atomic<int> handled = 0;
  server.start([&](const RawRequest&, const Peer&, Answer answer) {
    ++handled;
    answer(replyOf(kReplyBytes));
  });
  LazyPeer lazy(server.endpoint());
  MockClient other(server.endpoint());
  for (int i = 0; i < kRequests; ++i) lazy.ask();
  ASSERT_TRUE(waitUntil(
      [&] {
        std::uint64_t answered = 0;
        for (const auto& [kind, count] : counts.all()) answered += count;
        return answered == kRequests;
      },
      kPatience));
  EXPECT_LT(handled, kRequests / 2);
  EXPECT_EQ(other.server().version().size(), kReplyBytes);
  int refused = 0;
  for (int i = 0; i < kRequests; ++i) {
    const v1::Status status = lazy.read();
    if (status.code() == v1::CODE_OK) continue;
    ++refused;
    EXPECT_EQ(status.code(), v1::CODE_RESOURCE_EXHAUSTED);
    EXPECT_EQ(status.limit(), "replies");
  }
  EXPECT_EQ(refused, kRequests + 1 - handled);
  lazy.ask();
  EXPECT_EQ(lazy.read().code(), v1::CODE_OK);
}

// A large answer counts before it is made, so that a burst of short requests cannot ask for many.
TEST(ControlServer, CountsWhatAnAnswerIsExpectedToTake) {
  RequestCounts counts;
  ControlServer server(kOptions, counts);
  std::vector<Answer> late;
  server.start([&](const RawRequest&, const Peer&, Answer answer) {
    answer.expect(10 << 20);  // of 16 MiB
    late.push_back(std::move(answer));
  });
  LazyPeer peer(server.endpoint());
  for (int i = 0; i < 100; ++i) peer.ask();
  for (int i = 0; i < 98; ++i) EXPECT_EQ(peer.read().limit(), "replies");
  server.stop();
  EXPECT_EQ(late.size(), 2u);
}

// As a thread that answers may keep it, until it runs again.
TEST(ControlServer, AnAnswerThatIsKeptCountsNothing) {
  RequestCounts counts;
  ControlServer server(kOptions, counts);
  std::vector<Answer> kept;
  server.start([&](const RawRequest&, const Peer&, const Answer& answer) {
    kept.push_back(answer);
    answer(replyOf(4 << 20));  // of 16 MiB
  });
  LazyPeer peer(server.endpoint());
  for (int i = 0; i < 12; ++i) {
    peer.ask();
    EXPECT_EQ(peer.read().code(), v1::CODE_OK) << i;
  }
  server.stop();  // its thread puts answers there
}

// Requests whose answers are yet to come count, too. The first ones too many are refused, the rest counted.
TEST(ControlServer, DropsAndCountsWhatIsAskedWithoutEnd) {
  RequestCounts counts;
  ControlServer server(kOptions, counts);
  std::vector<Answer> late;  // the control thread's until it is stopped
  server.start([&](const RawRequest&, const Peer&, Answer answer) { late.push_back(std::move(answer)); });
  LazyPeer lazy(server.endpoint());
  const auto deadline = std::chrono::steady_clock::now() + kPatience;  // until all buffers are full
  while (counts.dropped() < 10 && std::chrono::steady_clock::now() < deadline) lazy.ask();
  server.stop();
  EXPECT_GE(counts.dropped(), 10u);
  EXPECT_EQ(late.size(), std::size_t{ControlServer::kMaxUnread});
}

TEST(ControlServer, AFaultOfTheHandlerCostsTheRequestOnly) {
  RequestCounts counts;
  ControlServer server(kOptions, counts);
  int calls = 0;
  server.start([&](const RawRequest&, const Peer&, const Answer& answer) {
    if (++calls == 1) throw std::bad_alloc();
    answer(replyOf(1));
  });
  LazyPeer peer(server.endpoint());
  peer.ask();
  peer.ask();
  EXPECT_EQ(peer.read().code(), v1::CODE_OK);
  EXPECT_EQ(counts.dropped(), 1u);
}

TEST(ControlServer, AnEndpointInUseIsNamed) {
  RequestCounts counts;
  ControlServer first(kOptions, counts);
  const std::string endpoint = first.endpoint();
  try {
    ControlServer second({.endpoint = endpoint, .request_bytes = 1 << 20}, counts);
    FAIL();
  } catch (const std::runtime_error& fault) {
    EXPECT_NE(std::string(fault.what()).find(endpoint), std::string::npos);
  }
}

}  // namespace
}  // namespace saccade
