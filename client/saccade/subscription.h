// Receives the batches of a stream, and reconnects when the connection or the server is lost.
//
// Heartbeats come every second; after silence a new connection resumes where the old one stopped. If the
// server has lost a LOSSLESS stream, or ended it early, the stream is opened again. The server then renders
// up to the last batch again; no event is missing and none comes twice. Steered and pushed streams are not
// opened again: only their client knows the next poses or frames. Lost packets of a LIVE or BROADCAST stream
// are counted.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "saccade/sequence_check.h"
#include "saccade/stream_handle.h"

namespace saccade::client {

class Subscription {
 public:
  struct RetryPolicy {
    // How long the server may be lost in all, until new data arrives; 0: it is not looked for.
    std::chrono::milliseconds retry_time{60'000};
    std::chrono::milliseconds silence{3000};  // after this much silence a connection counts as lost
    Waiting waiting = {};                     // called while a lost server is awaited
    std::function<void(const std::string& loss)> lost =
        {};  // called once at each loss, before the first retry
  };
  // Connects. `stream` must outlive the subscription.
  Subscription(zmq::context_t& context, StreamHandle& stream, RetryPolicy retry_policy);

  // Returns the next batch of any sensor, or a heartbeat. Returns nothing after `timeout`, after a signal, or
  // after reconnecting, which may take up to the retry time. Each call acknowledges the batch before, which
  // the server may then forget. After a reconnection, a header describes the new part of its batch, with the
  // stream_id, epoch and seq of the new stream. Throws StreamFault or Refused if the stream cannot go on, and
  // whatever `waiting` throws.
  std::optional<DecodedPacket> receive(std::chrono::milliseconds timeout);

  // True while a stream that was opened again is rendering what has already arrived. Heartbeats tell its
  // frame.
  bool catchingUp() const { return !failure_.empty(); }
  const Losses& losses() const { return sequence_.losses(); }

 private:
  using Clock = std::chrono::steady_clock;
  bool broadcast() const { return stream_.delivery() == v1::DELIVERY_BROADCAST; }
  // Whether only this client knows what its frames show.
  bool ownFrames() const {
    const v1::OpenStream& request = stream_.opened().resolved();
    return request.pushed() || request.timing().steerable();
  }
  void connect();
  std::optional<DecodedPacket> receiveFromConnection(std::chrono::milliseconds timeout);
  bool take(DecodedPacket& batch);
  bool endsEarly(const v1::PacketHeader& header) const;
  void reconnect();
  void startAgain(const std::string& failure);
  bool mayStartAgain() const;
  void retryAfter(const std::string& loss, const std::function<void(std::chrono::milliseconds)>& attempt);
  Clock::time_point giveUpAt(const std::string& loss);
  void found();

  zmq::context_t& context_;
  StreamHandle& stream_;
  const RetryPolicy retry_policy_;
  SequenceCheck sequence_;
  std::optional<Subscriber> connection_;
  bool heard_ = false;                           // whether this connection has delivered anything
  Clock::time_point last_heard_;                 // at first: when the connection was made
  std::optional<Clock::time_point> lost_since_;  // set while the connection is lost
  Clock::duration lost_for_{};                   // before, since new data has arrived
  std::string failure_;  // why the stream was opened again; empty once new data arrives
};

}  // namespace saccade::client
