// A stream that this client has opened; the destructor closes it.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "saccade/control_client.h"
#include "saccade/subscriber.h"

namespace saccade::client {

// How a stream is opened.
struct OpenPolicy {
  // How long to try where no server is up yet or it restarts meanwhile; 0: once.
  std::chrono::milliseconds retry_time{0};
  std::function<void(const std::exception&)> away = {};  // called at each attempt that found no server
  Waiting waiting = {};
  Watching watching = {};
};

class StreamHandle {
 public:
  static constexpr std::chrono::minutes kOpenDeadline{10};  // a large scene takes long to load

  // Throws NoAnswer, Refused, or StreamFault for a reply that cannot be, and whatever `waiting` throws.
  // `control` must outlive the handle.
  StreamHandle(ControlClient& control, const v1::OpenStream& request, const OpenPolicy& policy = {});
  ~StreamHandle();
  StreamHandle(const StreamHandle&) = delete;
  StreamHandle& operator=(const StreamHandle&) = delete;

  // LOSSLESS only: closes the stream and opens the same request again, on the same server or a restarted one.
  // `from_items`: the first event or sample to send, by channel. Throws as the constructor, and then changes
  // nothing.
  void reopen(const std::vector<std::uint64_t>& from_items, std::chrono::milliseconds deadline,
              const Waiting& waiting = {});

  const v1::StreamOpened& opened() const { return opened_; }
  const v1::ServerDescription& server() const { return server_; }
  v1::Delivery delivery() const { return opened_.resolved().delivery(); }

  // Connects to the stream as its delivery demands; `from_seqs` as in Subscriber::Attachment. Throws
  // StreamFault where the server has announced no endpoint for it.
  Subscriber subscribe(zmq::context_t& context, const std::vector<std::uint64_t>& from_seqs = {}) const;

  // Returns nothing if the server no longer has the stream. After closeKnown(), what was known then.
  std::optional<v1::StreamInfo> info(const Waiting& waiting = {});
  v1::FramePicture picture();  // the newest frame

  // Gives a stream with `pushed` its next frame: linear luminance, row by row from the top. Throws Refused.
  v1::FramePushed push(std::span<const float> intensity);

  // Steers the camera and objects of a stream with `timing.steerable`. Fills in the stream of `call`. Throws
  // Refused.
  v1::Steered steer(v1::Steer call);

  // Ends the stream at its next frame: the packets up to there still come, and then END. Neither waits for
  // the server nor throws.
  void close();
  // Asks for info() and closes, because the server forgets a closed stream once its packets are taken. A
  // server that does not answer in time leaves the info unknown.
  void closeKnown();
  bool closed() const { return closed_; }

 private:
  void open(const v1::OpenStream& stream, std::chrono::milliseconds deadline, const Waiting& waiting,
            const Watching& watching = {});
  void tellClose();

  ControlClient& control_;
  v1::ServerDescription server_;
  v1::StreamOpened opened_;
  std::optional<v1::StreamInfo> last_info_;
  bool closed_ = false;
};

}  // namespace saccade::client
