// Takes one picture of a stream during its recording, and writes it as PNG.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "saccade/stream_handle.h"

namespace saccade::client {

class Preview {
 public:
  // Asks for the picture once stream time has reached at_ns. `frame_ns` is the time between frames.
  Preview(const std::string& path, std::int64_t at_ns, std::int64_t frame_ns);

  // Call it with every batch of the stream, in order. A failure is reported on stderr and does not end the
  // recording.
  void see(const DecodedPacket& batch, StreamHandle& stream);

  bool written() const { return state_ == State::kWritten; }

 private:
  enum class State { kWaiting, kAsked, kWritten, kFailed };
  void keepTail(const DecodedPacket& batch);
  void advance(std::int64_t time_ns, StreamHandle& stream);
  void write() const;

  std::string path_;
  std::int64_t at_ns_, window_ns_;
  State state_ = State::kWaiting;
  v1::FramePicture frame_;
  Events tail_;  // recent events of sensor 0
};

}  // namespace saccade::client
