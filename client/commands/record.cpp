// saccade record: a stream into files.
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "client/commands/commands.h"
#include "client/commands/interrupt.h"
#include "client/commands/receive_all.h"
#include "client/commands/record_options.h"
#include "client/commands/summary.h"

namespace saccade::client {
namespace {

constexpr double kNsPerSecond = 1e9;

std::optional<Preview> makePreview(const std::string& path, const v1::Timing& timing) {
  if (path.empty()) return std::nullopt;
  const double third_s = timing.duration_s() > 0 ? timing.duration_s() / 3 : 1;
  return Preview(path, std::llround(third_s * kNsPerSecond),
                 std::llround(kNsPerSecond / timing.frame_rate_hz()));
}

std::chrono::milliseconds secondsOf(double time_s) {
  return std::chrono::milliseconds(std::llround(time_s * 1e3));
}

std::string keptText(const Recorder& recorder) {
  std::string text = "; what came (" + std::to_string(recorder.events()) + " events) is kept in";
  for (const std::string& file : recorder.files()) text += " " + file;
  return text;
}

Recorder startRecorder(const std::string& path, int sensors) {
  try {
    return Recorder(path, sensors);
  } catch (const std::system_error& error) {
    throw std::invalid_argument(std::string("--output: ") + error.what());
  }
}

void printStagesOf(StreamHandle& stream) {
  try {
    if (const auto info = stream.info()) printStages(*info);
  } catch (const NoAnswer&) {
    // The recording is whole, though the server is gone by now.
  }
}

void runRecord(const RecordOptions& options) {
  const v1::OpenStream wish = makeOpenStream(options);
  writerFor(options.output);  // before anything is rendered
  watchInterrupt();

  zmq::context_t context;
  ControlClient control = connectTo(context, options.server);
  StreamHandle stream(control, wish);
  printChoice(stream.opened());
  printModel(stream.opened());
  printPixelSpeed(stream.opened());
  Recorder recorder = startRecorder(options.output, wish.sensors_size());
  auto preview = makePreview(options.preview, stream.opened().resolved().timing());
  Progress progress(options.duration_s);
  Subscription subscription(
      context, stream,
      {.retry_time = secondsOf(options.retry_time_s), .waiting = [&progress] { showWaiting(progress); }});
  try {
    receiveAll(subscription, stream, recorder, preview, progress);
  } catch (const std::exception& error) {
    progress.finish();
    throw std::runtime_error(error.what() + keptText(recorder));
  }
  progress.finish();
  const double wall_s = progress.elapsed_s();
  recorder.commit();
  printFiles(recorder.files(), preview && preview->written() ? options.preview : "");
  printRates(recorder, wall_s);
  printLosses(subscription.losses());
  printStagesOf(stream);
}

}  // namespace

void addRecordCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("record", "open a stream and write its events to files");
  const auto options = std::make_shared<RecordOptions>();
  addRecordOptions(*command, *options);
  command->callback([options] { runRecord(*options); });
}

}  // namespace saccade::client
