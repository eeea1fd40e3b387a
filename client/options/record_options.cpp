#include "client/options/record_options.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "client/calibration/calibration.h"
#include "client/recording/tum_files.h"

namespace saccade::client {
namespace {

// Finds before any work that the files of the calibration cannot be written.
void checkCalibration(const OutputOptions& output, const v1::OpenStream& request) {
  const std::string fault = output.path == kStandardOutput ? "it needs a file" : calibrationFault(request);
  if (!fault.empty()) throw std::invalid_argument("--write-calibration: " + fault);
  for (const CalibrationFile& file : calibrationFiles(output.path, request))
    checkOutput("--write-calibration", file.name, output.force);
}

// Finds before any work that the files of the poses cannot be written.
void checkPoses(const OutputOptions& output, const v1::OpenStream& request) {
  if (output.path == kStandardOutput) throw std::invalid_argument("--write-poses: it needs a file");
  const bool has_poses = std::ranges::any_of(request.truth(), [](const v1::Truth& truth) {
    return truth.name() == "pose" || truth.name() == "object_poses";
  });
  if (!has_poses) throw std::invalid_argument("--write-poses goes with --truth pose or object_poses");
  for (const std::string& name : tumNames(output.path, request))
    checkOutput("--write-poses", name, output.force);
}

// Finds before any work that the times of the trajectory cannot be kept.
void checkKeptTimes(const RecordOptions& options) {
  if (!namesPoses(options.request)) throw std::invalid_argument("--keep-times goes with a file of poses");
  const WriterInfo& format = options.recording.output.writer();
  if (format.wraps)
    throw std::invalid_argument(std::string("--keep-times: ") + format.name +
                                " holds only times that begin near 0");
}

}  // namespace

void addRecordOptions(CLI::App& command, RecordOptions& options) {
  addRecordingOptions(command, options.recording);
  command.add_flag(
      "--write-calibration", options.write_calibration,
      "write the cameras beside FILE: FILE.camera_info.yaml (ROS), FILE.kalibr.yaml, with --truth imu "
      "FILE.imu.yaml (Kalibr), and for .h5 FILE.cam_to_cam.yaml (DSEC)");
  command.add_flag(
      "--keep-times", options.keep_times,
      "give all that is written the times of the trajectory's file, such as Unix time, instead of "
      "times from 0 on");
  command.add_flag("--write-poses", options.write_poses,
                   "write what --truth pose and object_poses give as text too, in TUM format: FILE.tum.txt, "
                   "FILE.object-NAME.tum.txt");
  addRequestOptions(command, options.request);
  addImuOptions(command, options.imu);
}

RecordJob makeRecordJob(const RecordOptions& options) {
  RecordJob job = makeJob(options.recording, makeOpenStream(options.request));
  setImu(options.imu, options.request.rig.metres_per_unit, job.request);
  job.calibration = options.write_calibration;
  job.trajectory = options.request.trajectory;
  job.retry_time_s = options.request.retry_time_s;
  job.keep_times = options.keep_times;
  job.poses = options.write_poses;
  job.replaces = options.recording.output.force;
  if (options.keep_times) checkKeptTimes(options);
  if (options.write_poses) checkPoses(options.recording.output, job.request);
  if (options.write_calibration) checkCalibration(options.recording.output, job.request);
  return job;
}

}  // namespace saccade::client
