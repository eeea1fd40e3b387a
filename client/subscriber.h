// The data plane as a client sees it: batches of events, checked and decoded.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "client/sequence_check.h"
#include "client/socket.h"
#include "saccade/v1/events.pb.h"
#include "wire/packet.h"

namespace saccade {

struct Batch : PacketContent {
  v1::PacketHeader header;
};

// The stream cannot go on, or what arrives cannot be trusted.
struct StreamFault : std::runtime_error {
  using runtime_error::runtime_error;
};

class Subscriber {
 public:
  static constexpr std::uint64_t kCredit = 4 << 20;  // bytes that may be under way

  struct Attachment {
    std::string endpoint, stream_id, token;
    std::uint64_t credit = kCredit;  // given at once, and topped up whenever half of it has arrived
    CurveKeys keys = {};
  };
  // LOSSLESS and LIVE, on the data socket.
  Subscriber(zmq::context_t& context, const Attachment& attachment);
  // BROADCAST: the topics of StreamOpened.
  Subscriber(zmq::context_t& context, const std::string& endpoint, const std::vector<std::string>& topics,
             const CurveKeys& keys = {});

  // The next batch of any sensor; nothing when `timeout` has passed or a signal came first. Throws
  // StreamFault at a packet of KIND_ERROR or one that fails its checks.
  std::optional<Batch> receive(std::chrono::milliseconds timeout);

  const Losses& losses() const { return sequence_.losses(); }

 private:
  void send(const v1::DataRequest& request);
  void giveCredit(std::uint64_t bytes);
  void takeCredit(std::uint64_t bytes);

  zmq::socket_t socket_;
  bool has_topic_;            // broadcast: a part in front of the header
  std::uint64_t credit_ = 0;  // 0: this socket works without
  std::uint64_t used_ = 0;    // bytes that arrived since credit was last given
  SequenceCheck sequence_;
};

}  // namespace saccade
