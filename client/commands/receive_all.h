// The packets of a stream, from the first to the last, to those who want them.
#pragma once

#include <optional>

#include "client/commands/preview.h"
#include "client/commands/progress.h"
#include "client/recorder.h"
#include "client/subscription.h"

namespace saccade::client {

// Returns when every sensor has ended, as the stream or Ctrl-C on an endless one ends it. Throws StreamFault
// where the end is not the one that was asked for, and as Subscription and Recorder do.
void receiveAll(Subscription& subscription, StreamHandle& stream, Recorder& recorder,
                std::optional<Preview>& preview, Progress& progress);

// What receiveAll() does while a server that is away is waited for: to be Subscription::RetryPolicy::waiting.
void showWaiting(Progress& progress);

}  // namespace saccade::client
