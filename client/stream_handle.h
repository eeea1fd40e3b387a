// A stream this client has opened. Closed when the handle goes.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "client/control_client.h"
#include "client/subscriber.h"

namespace saccade {

class StreamHandle {
 public:
  static constexpr std::chrono::minutes kOpenDeadline{10};  // a large scene takes its time to load

  // Throws NoAnswer or Refused. `control` must outlive the handle.
  StreamHandle(ControlClient& control, const v1::OpenStream& wish);
  ~StreamHandle();
  StreamHandle(const StreamHandle&) = delete;
  StreamHandle& operator=(const StreamHandle&) = delete;

  const v1::StreamOpened& opened() const { return opened_; }

  // By the delivery that was resolved, on the socket `server` announces for it.
  Subscriber subscribe(zmq::context_t& context, const v1::ServerDescription& server) const;

  std::optional<v1::StreamInfo> info();  // nothing where the server no longer knows the stream
  v1::FramePicture picture();            // the newest frame

  // The server ends the stream at its next frame; what it has made still comes, and then END. Neither waits
  // for an answer, since the server may be gone, nor throws.
  void close();

 private:
  ControlClient& control_;
  v1::StreamOpened opened_;
  bool closed_ = false;
};

}  // namespace saccade
