// saccade record: opens a stream and writes its events to files.
#include <memory>
#include <stdexcept>

#include "client/calibration/calibration.h"
#include "client/commands/commands.h"
#include "client/commands/recording_options.h"
#include "client/commands/request_options.h"

namespace saccade::client {
namespace {

struct RecordOptions {
  RequestOptions request;
  RecordingOptions recording;
  bool calibration = false;
};

void addOptions(CLI::App& command, RecordOptions& options) {
  addRecordingOptions(command, options.recording);
  command.add_flag(
      "--calibration", options.calibration,
      "write the cameras beside FILE: FILE.camera_info.yaml (ROS), FILE.kalibr.yaml, with --truth imu "
      "FILE.imu.yaml (Kalibr), and for .h5 FILE.cam_to_cam.yaml (DSEC)");
  addRequestOptions(command, options.request);
  command.footer(
      std::string(kMotionHelp) +
      " Keep the image motion below half a pixel per frame: `record` warns, and names a --rate.\n\n"
      "Options without a default here have the server's default. FILE is called FILE.partial until it is "
      "complete.\n"
      "`record` reconnects to a lost server and resumes; a lossless recording misses nothing.\n"
      "Exit codes: 0 recorded, 1 the stream or the server failed, 2 wrong usage.\n\n"
      "Example: saccade record cornell-box --trajectory right -o events.csv --preview events.png");
}

// Finds before any work that the files of the calibration cannot be written.
void checkCalibration(const OutputOptions& output, const v1::OpenStream& request) {
  const std::string fault = output.path == kStandardOutput ? "it needs a file" : calibrationFault(request);
  if (!fault.empty()) throw std::invalid_argument("--calibration: " + fault);
  for (const CalibrationFile& file : calibrationFiles(output.path, request))
    checkOutput("--calibration", file.name, output.force);
}

void runRecord(const RecordOptions& options) {
  RecordJob job = makeJob(options.recording, makeOpenStream(options.request));
  job.calibration = options.calibration;
  job.trajectory = options.request.trajectory;
  job.retry_time_s = options.request.retry_time_s;
  if (options.calibration) checkCalibration(options.recording.output, job.request);
  recordStream(options.request.server, job);
}

}  // namespace

void addRecordCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("record", "open a stream and write its events to files");
  const auto options = std::make_shared<RecordOptions>();
  addOptions(*command, *options);
  command->callback([options] { runRecord(*options); });
}

}  // namespace saccade::client
