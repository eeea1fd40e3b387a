// A stream this client has opened. Closed when the handle goes.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "client/control_client.h"
#include "client/subscriber.h"

namespace saccade::client {

class StreamHandle {
 public:
  static constexpr std::chrono::minutes kOpenDeadline{10};  // a large scene takes its time to load

  // Throws NoAnswer or Refused. `control` must outlive the handle.
  StreamHandle(ControlClient& control, const v1::OpenStream& wish);
  ~StreamHandle();
  StreamHandle(const StreamHandle&) = delete;
  StreamHandle& operator=(const StreamHandle&) = delete;

  // LOSSLESS: closes the stream and opens the same request again, from these events on, by sensor; most
  // likely on another run of the server. Throws as the constructor, and then the stream is what it was.
  void reopen(const std::vector<std::uint64_t>& from_events, std::chrono::milliseconds deadline,
              const Waiting& waiting = {});

  const v1::StreamOpened& opened() const { return opened_; }
  v1::Delivery delivery() const { return opened_.resolved().delivery(); }

  // A connection to it, by its delivery; `from_seqs` as Subscriber's.
  Subscriber subscribe(zmq::context_t& context, const std::vector<std::uint64_t>& from_seqs = {}) const;

  // Nothing where the server no longer knows the stream.
  std::optional<v1::StreamInfo> info(const Waiting& waiting = {});
  v1::FramePicture picture();  // the newest frame

  // The server ends the stream at its next frame; what it has made still comes, and then END. Neither waits
  // for an answer, since the server may be gone, nor throws.
  void close();
  bool closed() const { return closed_; }

 private:
  void open(const v1::OpenStream& wish, std::chrono::milliseconds deadline, const Waiting& waiting);
  void tellClose();

  ControlClient& control_;
  v1::ServerDescription server_;
  v1::StreamOpened opened_;
  bool closed_ = false;
};

}  // namespace saccade::client
