#include <filesystem>
#include <stdexcept>

#include "client/options/pose_text.h"
#include "client/options/request_options.h"
#include "client/options/request_text.h"
#include "client/poses/pose_file.h"

namespace saccade::client {
namespace {

constexpr const char* kWantsRoam = "--clearance goes with --motion roam:SPEED, such as roam:1px";

// Of KIND:SPEED or KIND:SPEEDpx.
v1::Motion makeMotion(const RequestOptions& options) {
  const auto [name, speed] = splitAt(options.trajectory, ':');
  const bool in_pixels = speed.ends_with("px");
  const auto value =
      parseNumber<double>(std::string_view(speed).substr(0, speed.size() - (in_pixels ? 2 : 0)));
  if (!value)
    throw std::invalid_argument("--trajectory: '" + options.trajectory +
                                "' is not KIND:SPEED, such as dolly:0.2");
  v1::Motion motion;
  motion.set_kind(enumValue<v1::MotionKind>("--trajectory", name));
  if (in_pixels) {
    motion.set_px_per_frame(*value);
  } else {
    motion.set_speed(*value);
  }
  if (options.turn_s) motion.set_turn_s(*options.turn_s);
  motion.set_seed(options.motion_seed.value_or(0));
  if (options.start) *motion.mutable_start() = parsePose("--start", *options.start);
  if (options.clearance && motion.kind() != v1::MOTION_KIND_ROAM) throw std::invalid_argument(kWantsRoam);
  if (options.clearance) motion.set_clearance(*options.clearance);
  return motion;
}

// Reads a file in a format of poseReaders().
std::string readPoses(const RequestOptions& options) {
  if (!options.pose_rate_hz)
    throw std::invalid_argument("--trajectory-format: give --pose-rate too: the file has no times");
  return poseReaders().at(options.pose_format)(options.trajectory, *options.pose_rate_hz);
}

}  // namespace

bool isTrajectoryFile(const std::string& trajectory) {
  return trajectory.ends_with(".csv") || std::filesystem::is_regular_file(trajectory);
}

bool namesPoses(const RequestOptions& options) {
  return !options.pose_format.empty() || isTrajectoryFile(options.trajectory);
}

v1::Trajectory makeTrajectory(const RequestOptions& options) {
  const bool file = namesPoses(options);
  v1::Trajectory trajectory;
  if (options.pose_rate_hz && options.pose_format.empty())
    throw std::invalid_argument("--pose-rate goes with --trajectory-format");
  if (!file && options.trajectory.find(':') != std::string::npos) {
    *trajectory.mutable_motion() = makeMotion(options);
    return trajectory;
  }
  if (options.turn_s || options.motion_seed)
    throw std::invalid_argument("--turn and --motion-seed go with --motion KIND:SPEED, such as dolly:0.2");
  if (options.clearance) throw std::invalid_argument(kWantsRoam);
  if (options.start)
    throw std::invalid_argument("--start: '" + *options.start +
                                "' goes with --motion KIND:SPEED, such as dolly:0.2");
  if (file) {
    trajectory.set_csv(options.pose_format.empty() ? readPoseText("--trajectory", options.trajectory)
                                                   : readPoses(options));
  } else if (!options.trajectory.empty()) {  // else the server's refusal names those of the scene
    trajectory.set_name(options.trajectory);
  }
  return trajectory;
}

}  // namespace saccade::client
