// The packets of a stream, from the first to the last, to those who want them.
#pragma once

#include <optional>

#include "client/commands/preview.h"
#include "client/commands/progress.h"
#include "client/recorder.h"
#include "client/stream_handle.h"

namespace saccade {

// Returns when every sensor has ended, as the stream or Ctrl-C on an endless one ends it. Throws StreamFault
// where the end is not the one that was asked for, NoAnswer where the server is gone, and as Recorder does.
void receiveAll(Subscriber& subscriber, StreamHandle& stream, Recorder& recorder,
                std::optional<Preview>& preview, Progress& progress);

}  // namespace saccade
