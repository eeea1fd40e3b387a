// saccade record: a stream into files.
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "client/commands/commands.h"
#include "client/commands/interrupt.h"
#include "client/commands/preview.h"
#include "client/commands/progress.h"
#include "client/commands/record_options.h"
#include "client/commands/summary.h"
#include "client/recorder.h"
#include "client/stream_handle.h"

namespace saccade {
namespace {

constexpr double kNsPerSecond = 1e9;
constexpr std::chrono::seconds kSilence{5};  // after which the server is asked whether the stream still lives

std::optional<Preview> makePreview(const std::string& path, const v1::Timing& timing) {
  if (path.empty()) return std::nullopt;
  const double half_s = timing.duration_s() > 0 ? timing.duration_s() / 2 : 1;
  return Preview(path, std::llround(half_s * kNsPerSecond),
                 std::llround(kNsPerSecond / timing.frame_rate_hz()));
}

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

void receiveAll(Subscriber& subscriber, StreamHandle& stream, Recorder& recorder,
                std::optional<Preview>& preview, Progress& progress) {
  while (!recorder.complete()) {
    const auto batch = nextBatch(subscriber, stream);
    if (!batch) continue;
    recorder.add(*batch);
    if (preview) preview->see(*batch, stream);
    progress.update(recorder.time_ns() / kNsPerSecond, recorder.events());
  }
  checkWhole(stream.opened(), recorder.time_ns() / kNsPerSecond);
}

std::string keptText(const Recorder& recorder) {
  std::string text = "; what came (" + std::to_string(recorder.events()) + " events) is kept in";
  for (const std::string& file : recorder.files()) text += " " + file;
  return text;
}

v1::ServerDescription describeServer(ControlClient& control) {
  v1::Request request;
  request.mutable_server_info();
  return control.call(std::move(request)).server_info();
}

void runRecord(const RecordOptions& options) {
  const v1::OpenStream wish = makeOpenStream(options);
  writerFor(options.output);  // before anything is rendered
  watchInterrupt();

  zmq::context_t context;
  ControlClient control(context, options.control);
  const v1::ServerDescription server = describeServer(control);
  StreamHandle stream(control, wish);
  Recorder recorder(options.output, wish.sensors_size());
  Subscriber subscriber = stream.subscribe(context, server);
  auto preview = makePreview(options.preview, stream.opened().resolved().timing());
  Progress progress(options.duration_s);
  try {
    receiveAll(subscriber, stream, recorder, preview, progress);
  } catch (const std::exception& error) {
    progress.finish();
    throw std::runtime_error(error.what() + keptText(recorder));
  }
  progress.finish();
  const double wall_s = progress.elapsed_s();
  recorder.commit();
  printFiles(recorder.files(), preview && preview->written() ? options.preview : "");
  printRates(recorder, wall_s);
  printLosses(subscriber.losses());
  if (const auto info = stream.info()) printStages(*info);
}

}  // namespace

void addRecordCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("record", "open a stream and write its events to files");
  const auto options = std::make_shared<RecordOptions>();
  addRecordOptions(*command, *options);
  command->callback([options] { runRecord(*options); });
}

}  // namespace saccade
