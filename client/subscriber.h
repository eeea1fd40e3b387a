// One connection to a stream: batches of events, decoded.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client/socket.h"
#include "client/stream_fault.h"
#include "saccade/v1/events.pb.h"
#include "wire/packet.h"

namespace saccade::client {

struct Batch : PacketContent {
  v1::PacketHeader header;
};

class Subscriber {
 public:
  static constexpr std::uint64_t kCredit = 4 << 20;  // bytes that may be under way

  struct Attachment {
    std::string endpoint, stream_id, token;
    std::vector<std::uint64_t> from_seqs = {};  // by sensor; empty: from the beginning
    std::uint64_t credit = kCredit;             // given at once, and topped up whenever half of it is used
    CurveKeys keys = {};
  };
  // LOSSLESS and LIVE, on the data socket.
  Subscriber(zmq::context_t& context, const Attachment& attachment);
  // BROADCAST: the topics of StreamOpened.
  Subscriber(zmq::context_t& context, const std::string& endpoint, const std::vector<std::string>& topics,
             const CurveKeys& keys = {});

  // The next batch of any sensor, heartbeats too; nothing when `timeout` has passed or a signal came first.
  // The call says that the batch before is safe: the server may be told that it need not keep it. Throws
  // StreamRefused at a packet of KIND_ERROR, StreamFault at one that fails its checks.
  std::optional<Batch> receive(std::chrono::milliseconds timeout);

 private:
  void send(const v1::DataRequest& request);
  void giveCredit(std::uint64_t bytes);
  void giveBack();

  zmq::socket_t socket_;
  bool has_topic_;            // broadcast: a part in front of the header
  std::uint64_t credit_ = 0;  // 0: this socket works without
  // Since credit was last given: the bytes that came, and by sensor the newest packet.
  std::uint64_t used_ = 0;
  std::map<std::uint32_t, std::uint64_t> safe_;
};

}  // namespace saccade::client
