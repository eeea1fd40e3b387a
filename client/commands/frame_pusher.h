// Sends the frames of a source to a stream with `pushed`, as fast as their events come.
#pragma once

#include <optional>

#include "client/frames/frame_source.h"
#include "saccade/stream_handle.h"

namespace saccade::client {

class FramePusher {
 public:
  // Both must outlive the pusher.
  FramePusher(StreamHandle& stream, FrameSource& frames) : stream_(stream), frames_(frames) {}

  // Sends the frames that the server has room for. `done_ns`: the stream time up to which all events have
  // come. Closes the stream after those of the last frame. Throws as StreamHandle and FrameSource do.
  void push(std::int64_t done_ns);

 private:
  bool send();

  StreamHandle& stream_;
  FrameSource& frames_;
  std::optional<IntensityFrame> next_;
  std::int64_t sent_ = 0;  // frames
  bool ended_ = false;     // whether the source has
};

}  // namespace saccade::client
