#include "client/commands/receive_all.h"

#include <chrono>
#include <string>
#include <utility>

#include "client/formats/common/units.h"
#include "client/terminal/interrupt.h"

namespace saccade::client {
namespace {

constexpr std::chrono::milliseconds kPollInterval{500};  // for Ctrl-C and the progress

// Ctrl-C is the normal end of an endless stream, and a fault of any other.
void handleInterrupt(StreamHandle& stream) {
  if (stream.opened().frames() > 0) throw StreamFault("interrupted");
  stream.closeKnown();
}

void showProgress(const Subscription& subscription, const StreamHandle& stream, const DecodedPacket& batch,
                  const RecordSinks& sinks, Progress& progress) {
  const Recorder& recorder = sinks.files.recorder;
  if (subscription.catchingUp()) {
    const std::uint64_t frames = stream.opened().frames();
    progress.note("rendering again: frame " + std::to_string(batch.header.frame()) +
                  (frames > 0 ? " of " + std::to_string(frames) : ""));
  } else {
    progress.update(secondsOf(sinks.files.streamTime()), secondsOf(recorder.duration_ns()),
                    recorder.events());
  }
}

// `end`: the header of the END packet of the last sensor.
void checkWhole(const v1::StreamOpened& opened, double stream_s, const v1::PacketHeader& end) {
  const double frames = stream_s * opened.resolved().timing().frame_rate_hz();
  if (opened.frames() > 0 && frames < opened.frames() - 0.5) throw StreamFault(endText(end));
}

}  // namespace

void RecordSinks::take(const DecodedPacket& batch, StreamHandle& stream) {
  files.take(batch);
  if (preview && batch.header.kind() == v1::KIND_EVENTS) preview->see(batch, stream);
}

void receiveAll(Subscription& subscription, StreamHandle& stream, RecordSinks& sinks, Progress& progress,
                std::optional<FramePusher>& pusher) {
  std::uint64_t epoch = stream.opened().epoch();
  v1::PacketHeader end;
  while (!sinks.files.recorder.complete()) {
    if (interrupted()) handleInterrupt(stream);
    if (pusher) pusher->push(sinks.files.streamTime());
    const auto batch = subscription.receive(kPollInterval);
    if (std::exchange(epoch, stream.opened().epoch()) != stream.opened().epoch()) {
      progress.tell("saccade: the server has restarted; it renders again up to the recorded frame");
    }
    if (!batch) continue;
    sinks.take(*batch, stream);
    if (batch->header.kind() == v1::KIND_END) end = batch->header;
    showProgress(subscription, stream, *batch, sinks, progress);
  }
  checkWhole(stream.opened(), secondsOf(sinks.files.streamTime()), end);
}

void showWaiting(Progress& progress) {
  throwIfInterrupted();
  progress.note("waiting for the server");
}

void reportLoss(Progress& progress, const std::string& loss, double retry_s) {
  progress.tell("saccade: " + loss + "; trying again for " + timeText(retry_s));
}

}  // namespace saccade::client
