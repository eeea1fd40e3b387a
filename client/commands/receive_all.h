// Hands every batch of a stream to the files, the preview and the progress line.
#pragma once

#include <optional>
#include <string>

#include "client/commands/frame_pusher.h"
#include "client/commands/preview.h"
#include "client/recording/recorded_files.h"
#include "client/terminal/progress.h"
#include "saccade/subscription.h"

namespace saccade::client {

// Where the batches of a stream go.
struct RecordSinks {
  RecordedFiles files;
  std::optional<Preview> preview;

  void take(const DecodedPacket& batch, StreamHandle& stream);
};

// Returns when every sensor has ended: at the last frame, or after Ctrl-C on an endless stream. Throws
// StreamFault if the stream ends early, and as Subscription, Recorder and FramePusher do. `pusher`: of a
// stream with `pushed`.
void receiveAll(Subscription& subscription, StreamHandle& stream, RecordSinks& sinks, Progress& progress,
                std::optional<FramePusher>& pusher);

// For Subscription::RetryPolicy::waiting: shows that it waits. Throws StreamFault after Ctrl-C.
void showWaiting(Progress& progress);
// For Subscription::RetryPolicy::lost.
void reportLoss(Progress& progress, const std::string& loss, double retry_s);

}  // namespace saccade::client
