// The calls of a client on a running stream: steer its camera, send its frames, change its sensors, and ask
// for results.
#pragma once

#include "app/streams/stream.h"

namespace saccade {

// These throw Refusal. Any thread may call them.
v1::Steered steerStream(const Stream& stream, const v1::Steer& call);
v1::SensorChanged changeSensor(const Stream& stream, const v1::ChangeSensor& call);
// May copy many keys and changes.
v1::StreamDescription describeStream(const Stream& stream);
// At least the bytes of that, in no time.
std::size_t descriptionBytes(const Stream& stream);

// Where the frames of a client go. It does not keep the stream.
struct PushTarget {
  std::shared_ptr<PushedFrames> frames;
  std::shared_ptr<ChangeNotifier> feed;
  double frame_rate_hz;
};
PushTarget pushTarget(const Stream& stream);
v1::FramePushed pushFrame(const PushTarget& target, std::string_view intensity);

}  // namespace saccade
