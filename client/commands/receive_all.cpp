#include "client/commands/receive_all.h"

#include <chrono>
#include <string>
#include <utility>

#include "client/commands/interrupt.h"

namespace saccade::client {
namespace {

constexpr double kNsPerSecond = 1e9;
constexpr std::chrono::milliseconds kPollInterval{500};  // between two looks at Ctrl-C and the progress

// Ctrl-C is the end that was meant where the stream has no other.
void heedInterrupt(StreamHandle& stream) {
  if (stream.opened().frames() > 0) throw StreamFault("interrupted");
  stream.close();
}

void showProgress(const Subscription& subscription, const StreamHandle& stream, const Batch& batch,
                  const Recorder& recorder, Progress& progress) {
  if (subscription.catchingUp()) {
    const std::uint64_t frames = stream.opened().frames();
    progress.note("rendering again: frame " + std::to_string(batch.header.frame()) +
                  (frames > 0 ? " of " + std::to_string(frames) : ""));
  } else {
    progress.update(recorder.duration_ns() / kNsPerSecond, recorder.events());
  }
}

// A server that stops ends its streams early.
void checkWhole(const v1::StreamOpened& opened, double stream_s) {
  const double frames = stream_s * opened.resolved().timing().frame_rate_hz();
  if (opened.frames() > 0 && frames < opened.frames() - 0.5) {
    throw StreamFault("the server ended the stream after " + std::to_string(stream_s) + " s");
  }
}

}  // namespace

void receiveAll(Subscription& subscription, StreamHandle& stream, Recorder& recorder,
                std::optional<Preview>& preview, Progress& progress) {
  std::uint64_t epoch = stream.opened().epoch();
  while (!recorder.complete()) {
    if (interrupted()) heedInterrupt(stream);
    const auto batch = subscription.receive(kPollInterval);
    if (std::exchange(epoch, stream.opened().epoch()) != stream.opened().epoch()) {
      progress.tell("saccade: the server has started anew; it renders up to what is recorded, then on");
    }
    if (!batch) continue;
    recorder.add(*batch);
    if (preview && batch->header.kind() == v1::KIND_EVENTS) preview->see(*batch, stream);
    showProgress(subscription, stream, *batch, recorder, progress);
  }
  checkWhole(stream.opened(), recorder.time_ns() / kNsPerSecond);
}

void showWaiting(Progress& progress) {
  if (interrupted()) throw StreamFault("interrupted");
  progress.note("waiting for the server");
}

}  // namespace saccade::client
