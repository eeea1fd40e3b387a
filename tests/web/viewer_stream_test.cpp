// The part of a stream that is sent to a page; the server's socket is a ROUTER of this test.
#include <iterator>

#include "web/viewer_stream.h"

#include <gtest/gtest.h>

#include <zmq_addon.hpp>

#include "mock/mock_client.h"
#include "saccade/v1/events.pb.h"
#include "web/socket_pair.h"

namespace saccade {
namespace {

class ViewerStreamTest : public testing::Test {
 protected:
  ViewerStreamTest() {
    router_.set(zmq::sockopt::linger, 0);
    router_.set(zmq::sockopt::rcvtimeo, static_cast<int>(kPatience.count()));
    router_.bind("tcp://127.0.0.1:*");
    stream_.emplace(
        context_,
        ViewerStream::Source{.data = router_.get(zmq::sockopt::last_endpoint), .broadcast = {}, .keys = {}},
        v1::Attach());
    name_ = receive().front().to_string();
    receive();  // the first credit
  }

  std::vector<zmq::message_t> receive() {
    std::vector<zmq::message_t> parts;
    EXPECT_TRUE(zmq::recv_multipart(router_, std::back_inserter(parts)));
    return parts;
  }
  // Sends a packet, and forwards it to the page. Returns the bytes that the page has to take more.
  std::size_t forward(std::size_t payload_bytes) {
    v1::PacketHeader header;
    header.set_kind(v1::KIND_TRUTH);
    const std::string text = header.SerializeAsString();
    router_.send(zmq::buffer(name_), zmq::send_flags::sndmore);
    router_.send(zmq::buffer(text), zmq::send_flags::sndmore);
    router_.send(zmq::message_t(payload_bytes), zmq::send_flags::none);
    zmq::pollitem_t items[] = {{stream_->handle(), 0, ZMQ_POLLIN, 0}};
    zmq::poll(items, 1, kPatience);
    const std::size_t before = page_.queuedBytes();
    stream_->forwardTo(&page_);
    return page_.queuedBytes() - before;
  }

  SocketPair pair_;
  WebSocket page_{pair_.server(), [](std::string_view) {}};
  zmq::context_t context_;
  zmq::socket_t router_{context_, zmq::socket_type::router};
  std::optional<ViewerStream> stream_;
  std::string name_;
};

// A page that takes nothing would hold it, in each of its streams.
TEST_F(ViewerStreamTest, EndsAtAPacketThatIsTooLargeAndSaysWhy) {
  EXPECT_GT(forward(ViewerStream::kMostPayload), ViewerStream::kMostPayload);
  EXPECT_FALSE(stream_->ended());
  const std::size_t refusal = forward(ViewerStream::kMostPayload + 1);
  EXPECT_TRUE(stream_->ended());
  EXPECT_GT(refusal, 0u);
  EXPECT_LT(refusal, 1000u);
  EXPECT_EQ(forward(10), 0u);
  std::string received;
  while (page_.queuedBytes() > 0) {
    ASSERT_TRUE(page_.exchange());
    received += pair_.received();
  }
  EXPECT_NE(received.find("CODE_RESOURCE_EXHAUSTED"), std::string::npos);
  EXPECT_NE(received.find(std::to_string(ViewerStream::kMostPayload + 1) + " bytes"), std::string::npos);
}

}  // namespace
}  // namespace saccade
