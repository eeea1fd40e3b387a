#include "client/commands/receive_all.h"

#include <chrono>
#include <string>

#include "client/commands/interrupt.h"

namespace saccade {
namespace {

constexpr double kNsPerSecond = 1e9;
constexpr std::chrono::seconds kSilence{5};  // after which the server is asked whether the stream still lives

// A slow scene is silent, too; throws only where nothing can come any more.
void checkAlive(StreamHandle& stream) {
  const auto info = stream.info();
  if (!info) throw StreamFault("the server no longer knows the stream");
  const std::uint64_t frames = stream.opened().frames();
  if (frames > 0 && info->frames_done() >= frames) throw StreamFault("the end of the stream was lost");
}

// Ctrl-C is the end that was meant where the stream has no other.
void heedInterrupt(StreamHandle& stream) {
  if (stream.opened().frames() > 0) throw StreamFault("interrupted");
  stream.close();
}

// One batch, or nothing after a while without.
std::optional<Batch> nextBatch(Subscriber& subscriber, StreamHandle& stream) {
  if (interrupted()) heedInterrupt(stream);
  auto batch = subscriber.receive(kSilence);
  if (!batch) checkAlive(stream);
  return batch;
}

// A server that stops ends its streams early.
void checkWhole(const v1::StreamOpened& opened, double stream_s) {
  const double frames = stream_s * opened.resolved().timing().frame_rate_hz();
  if (opened.frames() > 0 && frames < opened.frames() - 0.5) {
    throw StreamFault("the server ended the stream after " + std::to_string(stream_s) + " s");
  }
}

}  // namespace

void receiveAll(Subscriber& subscriber, StreamHandle& stream, Recorder& recorder,
                std::optional<Preview>& preview, Progress& progress) {
  while (!recorder.complete()) {
    const auto batch = nextBatch(subscriber, stream);
    if (!batch) continue;
    recorder.add(*batch);
    if (preview) preview->see(*batch, stream);
    progress.update(recorder.duration_ns() / kNsPerSecond, recorder.events());
  }
  checkWhole(stream.opened(), recorder.time_ns() / kNsPerSecond);
}

}  // namespace saccade
