// One connection to a stream; decodes its packets into batches of events.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "saccade/socket.h"
#include "saccade/stream_fault.h"
#include "saccade/v1/events.pb.h"
#include "saccade/wire/packet.h"

namespace saccade::client {

class Subscriber {
 public:
  static constexpr std::uint64_t kCredit = 4 << 20;  // bytes that the server may send ahead

  struct Attachment {
    std::string endpoint, stream_id, token;
    std::vector<std::uint64_t> from_seqs = {};  // the first seq wanted, by sensor; empty: from the beginning
    std::uint64_t credit = kCredit;             // bytes; given at once, and topped up when half is used
    CurveKeys keys = {};
  };
  // For LOSSLESS and LIVE: connects to the data socket.
  Subscriber(zmq::context_t& context, const Attachment& attachment);
  // For BROADCAST: connects to the broadcast socket with the topics of StreamOpened.
  Subscriber(zmq::context_t& context, const std::string& endpoint, const std::vector<std::string>& topics,
             const CurveKeys& keys = {});

  // Returns the next batch of any sensor, or a heartbeat; nothing after `timeout` or a signal. Each call
  // acknowledges the batch before, which the server may then forget. Throws StreamRefused for a packet of
  // KIND_ERROR, and StreamFault for one that fails its checks or was sent without credit.
  std::optional<DecodedPacket> receive(std::chrono::milliseconds timeout);

 private:
  struct Arrived {
    v1::PacketHeader header;
    zmq::message_t payload;
    std::uint64_t cost;  // credit, in bytes
  };
  bool take();
  void add(Arrived arrived);
  bool endsWith(v1::Kind kind) const;  // what has arrived
  void send(const v1::DataRequest& request);
  void giveCredit(std::uint64_t bytes);
  void giveBack();

  zmq::socket_t socket_;
  bool has_topic_;               // broadcast: a message part before the header
  std::uint64_t credit_ = 0;     // bytes; 0: broadcast, which has no credit
  std::deque<Arrived> arrived_;  // and not received yet
  std::uint64_t waiting_ = 0;    // their cost
  // Received since credit was last given: cost, and the newest seq of each sensor.
  std::uint64_t used_ = 0;
  std::map<std::uint32_t, std::uint64_t> safe_;
};

}  // namespace saccade::client
