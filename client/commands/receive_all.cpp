#include "client/commands/receive_all.h"

#include <chrono>
#include <string>
#include <utility>

#include "client/commands/interrupt.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr std::chrono::milliseconds kPollInterval{500};  // for Ctrl-C and the progress

// Ctrl-C is the normal end of an endless stream, and a fault of any other.
void handleInterrupt(StreamHandle& stream) {
  if (stream.opened().frames() > 0) throw StreamFault("interrupted");
  stream.close();
}

void showProgress(const Subscription& subscription, const StreamHandle& stream, const DecodedPacket& batch,
                  const RecordSinks& sinks, Progress& progress) {
  const Recorder& recorder = sinks.recorder;
  if (subscription.catchingUp()) {
    const std::uint64_t frames = stream.opened().frames();
    progress.note("rendering again: frame " + std::to_string(batch.header.frame()) +
                  (frames > 0 ? " of " + std::to_string(frames) : ""));
  } else {
    progress.update(secondsOf(sinks.streamTime()), secondsOf(recorder.duration_ns()), recorder.events());
  }
}

// `end`: the header of the END packet of the last sensor.
void checkWhole(const v1::StreamOpened& opened, double stream_s, const v1::PacketHeader& end) {
  const double frames = stream_s * opened.resolved().timing().frame_rate_hz();
  if (opened.frames() > 0 && frames < opened.frames() - 0.5) throw StreamFault(endText(end));
}

// The same batch with other times.
DecodedPacket later(DecodedPacket batch, std::int64_t offset_ns) {
  batch.header.set_t0_ns(batch.header.t0_ns() + offset_ns);
  batch.header.set_t1_ns(batch.header.t1_ns() + offset_ns);
  for (Event& event : batch.events) event.t_ns += offset_ns;
  for (TruthSample& sample : batch.truth) {
    sample.t_ns += offset_ns;
    if (sample.exposure_end_ns == 0) continue;  // it was not exposed
    sample.exposure_begin_ns += offset_ns, sample.exposure_end_ns += offset_ns;
  }
  return batch;
}

}  // namespace

void RecordSinks::take(const DecodedPacket& batch, StreamHandle& stream) {
  const auto write = [this](const DecodedPacket& timed) {
    recorder.add(timed);
    if (poses) poses->add(timed);
  };
  time_offset_ns == 0 ? write(batch) : write(later(batch, time_offset_ns));
  if (preview && batch.header.kind() == v1::KIND_EVENTS) preview->see(batch, stream);
}

void receiveAll(Subscription& subscription, StreamHandle& stream, RecordSinks& sinks, Progress& progress,
                std::optional<FramePusher>& pusher) {
  std::uint64_t epoch = stream.opened().epoch();
  v1::PacketHeader end;
  while (!sinks.recorder.complete()) {
    if (interrupted()) handleInterrupt(stream);
    if (pusher) pusher->push(sinks.streamTime());
    const auto batch = subscription.receive(kPollInterval);
    if (std::exchange(epoch, stream.opened().epoch()) != stream.opened().epoch()) {
      progress.tell("saccade: the server has restarted; it renders again up to the recorded frame");
    }
    if (!batch) continue;
    sinks.take(*batch, stream);
    if (batch->header.kind() == v1::KIND_END) end = batch->header;
    showProgress(subscription, stream, *batch, sinks, progress);
  }
  checkWhole(stream.opened(), secondsOf(sinks.streamTime()), end);
}

void showWaiting(Progress& progress) {
  throwIfInterrupted();
  progress.note("waiting for the server");
}

void reportLoss(Progress& progress, const std::string& loss, double retry_s) {
  progress.tell("saccade: " + loss + "; trying again for " + timeText(retry_s));
}

}  // namespace saccade::client
