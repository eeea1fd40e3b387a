// What a client may do to a running stream: steer its camera or send its frames, change its sensors, and ask
// what came of it.
#pragma once

#include "app/streams/stream.h"

namespace saccade {

// These throw Refusal. Any thread may call them.
v1::Steered steerStream(const Stream& stream, const v1::Steer& call);
v1::FramePushed pushFrame(const Stream& stream, const v1::PushFrame& call);
v1::SensorChanged changeSensor(const Stream& stream, const v1::ChangeSensor& call);
// May copy many keys.
v1::StreamDescription describeStream(const Stream& stream);

}  // namespace saccade
