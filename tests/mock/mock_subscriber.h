// The data and broadcast sockets as a test sees them.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>
#include <zmq.hpp>

#include "mock/mock_client.h"
#include "saccade/wire/packet.h"

namespace saccade {

struct Received {
  std::string topic;  // broadcast only
  v1::PacketHeader header;
  std::string payload;
  std::uint64_t bytes;  // header and payload parts together
};
using Packets = std::vector<Received>;

class MockSubscriber {
 public:
  explicit MockSubscriber(const std::string& data_endpoint, const MockKeys& keys = {});  // DEALER
  MockSubscriber(const std::string& broadcast_endpoint, const v1::StreamOpened& stream,
                 const MockKeys& keys = {});  // SUB to all topics

  // `from_seqs`: by sensor; none: from the beginning.
  void attach(const v1::StreamOpened& stream, const std::vector<std::uint64_t>& from_seqs = {});
  void giveCredit(std::uint64_t bytes);
  void acknowledge(std::uint32_t sensor, std::uint64_t seq);
  void sendRaw(const std::string& bytes);

  // The next packet but for heartbeats; nothing after `timeout`.
  std::optional<Received> receive(std::chrono::milliseconds timeout = kPatience);
  std::optional<Received> receiveAny(std::chrono::milliseconds timeout = kPatience);  // heartbeats too
  // Packets by sensor, up to the END of `sensors` of them; gives credit back for each. Throws
  // std::runtime_error at an ERROR and where nothing comes.
  std::map<std::uint32_t, Packets> receiveAll(int sensors);

 private:
  zmq::context_t context_;
  zmq::socket_t socket_;
  const bool broadcast_;
};

struct Summary {
  std::uint64_t packets = 0, events = 0, dropped = 0;  // without END
  std::int64_t end_ns = 0;
};

// Decodes the packets of one sensor and adds a test failure for whatever the schema does not allow. Such
// faults are a seq or event index that the drops told do not explain, and time that runs backwards or has
// holes. A pixel outside the view and a missing END are others. `lossy`: packets may be missing, if told.
// `begin_ns`: a stream that joins a feed begins where it joined.
Summary checkPackets(const Packets& packets, bool lossy = false, std::int64_t begin_ns = 0);

// The packets as sent, but for what names the stream and the run of the server, and its lag.
std::string comparableBytes(const Packets& packets);

}  // namespace saccade
