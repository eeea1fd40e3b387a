// saccade record: opens a stream and writes its events to files.
#include <memory>
#include <stdexcept>

#include "client/calibration/calibration.h"
#include "client/commands/commands.h"
#include "client/commands/labels_option.h"
#include "client/commands/output_options.h"
#include "client/commands/record_stream.h"
#include "client/commands/request_options.h"
#include "client/commands/truth_option.h"

namespace saccade::client {
namespace {

struct RecordOptions {
  RequestOptions request;
  OutputOptions output;
  std::string preview;
  std::vector<std::string> truth;
  bool calibration = false, labels = false;
};

void addOptions(CLI::App& command, RecordOptions& options) {
  addOutputOptions(command, options.output, "-o,--output");
  addPreviewOption(command, options.preview);
  addTruthOption(command, options.truth);
  addLabelsOption(command, options.labels);
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
void checkCalibration(const RecordOptions& options, const v1::OpenStream& request) {
  const std::string fault =
      options.output.path == kStandardOutput ? "it needs a file" : calibrationFault(request);
  if (!fault.empty()) throw std::invalid_argument("--calibration: " + fault);
  for (const CalibrationFile& file : calibrationFiles(options.output.path, request))
    checkOutput("--calibration", file.name, options.output.force);
}

void runRecord(const RecordOptions& options) {
  RecordJob job{.request = makeOpenStream(options.request),
                .output = options.output.path,
                .format = &options.output.writer(),
                .preview = options.preview,
                .calibration = options.calibration,
                .trajectory = options.request.trajectory,
                .retry_time_s = options.request.retry_time_s};
  requestTruth(options.truth, job.request);
  checkOutputs(options.output, job.request.sensors_size());
  checkTruthOutput(options.output, job.request);
  if (options.labels) requestLabels(job.request);
  checkLabelsOutput(options.output, job.request);
  if (!options.preview.empty()) checkOutput("--preview", options.preview, options.output.force);
  if (options.calibration) checkCalibration(options, job.request);
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
