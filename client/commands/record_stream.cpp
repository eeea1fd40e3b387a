#include "client/commands/record_stream.h"

#include <cmath>
#include <csignal>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "client/calibration/calibration.h"
#include "client/commands/commands.h"
#include "client/commands/receive_all.h"
#include "client/commands/stream_opening.h"
#include "client/commands/summary.h"
#include "client/formats/common/units.h"
#include "client/options/output_options.h"
#include "client/terminal/interrupt.h"

namespace saccade::client {
namespace {

std::optional<Preview> makePreview(const std::string& path, const v1::Timing& timing) {
  if (path.empty()) return std::nullopt;
  const double third_s = timing.duration_s() > 0 ? timing.duration_s() / 3 : 1;
  return Preview(path, std::llround(third_s * kNsPerSecond),
                 std::llround(kNsPerSecond / timing.frame_rate_hz()));
}

std::string keptText(Recorder& recorder, const std::string& output) {
  const std::string events = "; " + std::to_string(recorder.salvage()) + " events";
  if (output == kStandardOutput) return events + " were written";
  std::string text = events + " are kept in";
  for (const std::string& file : recorder.files()) text += " " + file;
  return text;
}

// Only the resolved request names the objects that the scene moves.
void startPoses(const RecordJob& job, const v1::OpenStream& resolved, RecordedFiles& files) {
  for (const std::string& name : tumNames(job.output, resolved))
    checkOutput("--write-poses", name, job.replaces);
  files.poses.emplace(job.output, resolved);
}

RecordSinks startSinks(const RecordJob& job, const StreamHandle& stream) {
  const v1::OpenStream& resolved = stream.opened().resolved();
  try {
    RecordedFiles files{
        .recorder = Recorder(job.output, *job.format, stream.opened(), stream.server()),
        .time_offset_ns = job.keep_times ? stream.opened().trajectory_begin_ns() : job.time_offset_ns};
    files.recorder.setTimeOffset(files.time_offset_ns);
    if (job.poses) startPoses(job, resolved, files);
    return {std::move(files), makePreview(job.preview, resolved.timing())};
  } catch (const std::system_error& error) {
    throw std::invalid_argument(std::string("--output: ") + error.what());
  }
}

void writeCalibration(const std::string& output, const v1::OpenStream& resolved) {
  for (const CalibrationFile& file : calibrationFiles(output, resolved)) {
    OutputFile out(file.name);
    out.append(file.text);
    out.close();
  }
}

void printStagesOf(std::FILE* out, StreamHandle& stream) {
  try {
    if (const auto info = stream.info()) printStages(out, *info, stream.opened().resolved().timing());
  } catch (const NoAnswer&) {
    // The recording is complete, though the server has gone.
  }
}

}  // namespace

std::vector<v1::Recording> recordStream(const ServerOptions& server, const RecordJob& job) {
  std::FILE* out = job.output == kStandardOutput ? stderr : stdout;
  watchInterrupt();
  std::signal(SIGPIPE, SIG_IGN);  // a pipe that is closed makes write() fail

  zmq::context_t context;
  ControlClient control = connectTo(context, server);
  StreamHandle stream = openStream(control, {job.request, job.trajectory, job.retry_time_s});
  const v1::StreamOpened opened = stream.opened();
  tellOpening(out, job.request, opened);
  RecordSinks sinks = startSinks(job, stream);
  Recorder& recorder = sinks.files.recorder;
  std::optional<FramePusher> pusher;
  if (job.frames) pusher.emplace(stream, *job.frames);
  Progress progress(streamSeconds(opened));
  const double retry_s = job.retry_time_s;
  Subscription subscription(
      context, stream,
      {.retry_time = millisecondsOf(retry_s),
       .waiting = [&progress] { showWaiting(progress); },
       .lost = [&progress, retry_s](const std::string& loss) { reportLoss(progress, loss, retry_s); }});
  try {
    receiveAll(subscription, stream, sinks, progress, pusher);
    sinks.files.commit(subscription.losses().events);
  } catch (const std::exception& error) {
    progress.finish();
    throw std::runtime_error(error.what() + keptText(recorder, job.output));
  }
  progress.finish();
  const double wall_s = progress.elapsed_s();
  if (job.calibration) writeCalibration(job.output, opened.resolved());
  printFiles(out, recorder.files(), sinks.preview && sinks.preview->written() ? job.preview : "");
  printRates(out, recorder, wall_s);
  printTruth(out, recorder);
  printWithheld(out, recorder, opened.resolved());
  printLosses(out, subscription.losses());
  printStagesOf(out, stream);
  return recorder.descriptions();
}

}  // namespace saccade::client
