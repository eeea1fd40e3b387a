// The batches of a stream, whatever becomes of the connection and of the server.
//
// After silence, for heartbeats come every second, another connection goes on where the last one was. A
// LOSSLESS stream that the server has lost, or has ended before its last frame, is opened again and goes on
// where it was, once the server has rendered up to there: without a gap, and nothing comes twice. What a
// LIVE or BROADCAST stream has missed is counted.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "client/sequence_check.h"
#include "client/stream_handle.h"

namespace saccade::client {

class Subscription {
 public:
  struct RetryPolicy {
    std::chrono::milliseconds retry_time{
        60'000};                              // about how long a server may be away; 0: no break is mended
    std::chrono::milliseconds silence{3000};  // after which a connection is taken for lost
    Waiting waiting = {};                     // while the server is asked for
  };
  // Connects. `stream` must outlive the subscription.
  Subscription(zmq::context_t& context, StreamHandle& stream, RetryPolicy retry_policy);

  // The next batch of any sensor, or a heartbeat; nothing when `timeout` has passed, a signal came first, or
  // a break was mended, which takes up to the retry time. The call says that the batch before is safe: it
  // cannot be had again. The header of a batch that goes on after a break tells of what is new in it, under
  // the stream_id, epoch and seq of the new stream. Throws StreamFault, NoAnswer or Refused where the stream
  // cannot go on, and what `waiting` throws.
  std::optional<Batch> receive(std::chrono::milliseconds timeout);

  // The stream was opened again, and has not yet come to where it was. Heartbeats tell how far it is.
  bool catchingUp() const { return !failure_.empty(); }
  const Losses& losses() const { return sequence_.losses(); }

 private:
  using Clock = std::chrono::steady_clock;
  bool broadcast() const { return stream_.delivery() == v1::DELIVERY_BROADCAST; }
  void connect();
  std::optional<Batch> receiveFromConnection(std::chrono::milliseconds timeout);
  bool take(Batch& batch);
  bool endsEarly(const v1::PacketHeader& header) const;
  void reconnect();
  void startAgain(const std::string& failure);
  bool mayStartAgain() const;
  Clock::time_point patienceEnds();

  zmq::context_t& context_;
  StreamHandle& stream_;
  const RetryPolicy retry_policy_;
  SequenceCheck sequence_;
  std::optional<Subscriber> connection_;
  bool heard_ = false;                           // anything on this connection
  Clock::time_point last_heard_;                 // or when it was made
  std::optional<Clock::time_point> lost_since_;  // while nothing is heard
  std::string failure_;                          // why the stream was opened again, until fresh comes
};

}  // namespace saccade::client
