#include <algorithm>

#include "app/request/enum_names.h"
#include "app/request/read_path.h"
#include "app/request/read_pose.h"
#include "app/request/refusal.h"
#include "app/request/resolve_trajectory.h"
#include "base/names.h"
#include "base/text_cut.h"
#include "render/camera/scene_motion.h"
#include "render/world/render_scene.h"
#include "scene/camera/motion.h"
#include "scene/files/scene_error.h"
#include "scene/roam/roam.h"

namespace saccade {
namespace {

std::string kindOf(const v1::Motion& motion) {
  return nameWithout("MOTION_KIND_", v1::MotionKind_Name(motion.kind()));
}

// The pose of the scene's own camera gives what the request leaves out. Throws Refusal.
Pose startOf(const v1::Motion& motion, Pose pose) {
  const std::string field = "trajectory.motion.start";
  const v1::RigidTransform& start = motion.start();
  if (start.has_position()) pose.position = readPosition(start.position(), field);
  if (start.has_rotation()) pose.rotation = unitNear(readRotation(start.rotation(), field), pose.rotation);
  return pose;
}

void checkClearance(const v1::Motion& motion, const std::string& field) {
  if (!motion.has_clearance()) return;
  checkRange(field, motion.clearance(), ranges::kClearance);
  if (motion.kind() != v1::MOTION_KIND_ROAM) refuse(field, kindOf(motion) + " keeps none; roam does");
}

void checkMotion(v1::Motion& motion) {
  const std::string field = "trajectory.motion";
  if (motion.kind() == v1::MOTION_KIND_UNSPECIFIED)
    refuse(field + ".kind", "give one of: " + joinNames(motionKinds()));
  resolveEnum(field + ".kind", motion.kind(), v1::MOTION_KIND_UNSPECIFIED);
  if (motion.rate_case() == v1::Motion::RATE_NOT_SET) refuse(field, "give a speed or px_per_frame");
  const std::string rate = motion.has_speed() ? ".speed" : ".px_per_frame";
  const std::string fault =
      speedFault(kindOf(motion), motion.has_speed() ? motion.speed() : motion.px_per_frame());
  if (!fault.empty()) refuse(field + rate, fault);
  if (motion.turn_s() != 0) checkRange(field + ".turn_s", motion.turn_s(), ranges::kTurn);
  checkClearance(motion, field + ".clearance");
  startOf(motion, {});
  // Fields that the kind ignores must not make equal feeds different.
  if (isSeeded(kindOf(motion))) motion.clear_turn_s();
  if (!isSeeded(kindOf(motion))) motion.clear_seed();
}

// Lists the valid trajectories, for a refusal.
std::string valid(const SceneEntry& scene) {
  return joinNames(scene.trajectories) + "; or a motion KIND:SPEED, such as pan:10, with KIND one of " +
         joinNames(motionKinds());
}

void checkName(const std::string& name, const SceneEntry& scene) {
  const auto isIn = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (isIn(scene.trajectories) || scene.may_have_paths) return;
  const std::string quoted = "'" + cutText(name, kMaxEcho) + "'";
  throw Refusal(v1::CODE_NOT_FOUND, "trajectory.name",
                isIn(motionKinds()) ? quoted + " is a motion, which needs a speed, such as " + name + ":10"
                                    : "the scene has no trajectory " + quoted + "; it has: " + valid(scene));
}

Motion motionOf(const v1::Motion& request, const FeedConfig& feed) {
  Motion motion{.kind = kindOf(request), .speed = request.speed(), .seed = request.seed()};
  if (request.has_turn_s()) motion.turn_s = request.turn_s();
  if (request.has_clearance()) motion.clearance = request.clearance();
  if (request.has_px_per_frame()) {
    motion.speed = request.px_per_frame() * feed.frame_rate_hz / feed.camera.focal();
    motion.image_speed = true;
  }
  return motion;
}

void takeCsv(const std::string& csv, ResolvedStream& stream) {
  PoseText text = readCsv(csv, "trajectory.csv");
  stream.given_path = Trajectory(std::move(text.poses));
  stream.path_begin_ns = text.begin.count();
}

Trajectory byName(const ResolvedStream& stream, const RenderScene& scene, const SceneLibrary& library) {
  const std::string& name = stream.request.trajectory().name();
  const CameraModel& camera = stream.feed.camera;
  const v1::View& view = stream.request.view();
  const double fov = view.has_fov_x_deg() ? view.fov_x_deg() : fovXDeg(camera);
  if (isMotionName(name))
    return motionIn(scene, namedMotion(name, fov), scene.description().T_world_camera, Lens(camera));
  const std::vector<ScenePath>& paths = scene.description().paths;
  if (const ScenePath* path = findRow(paths, name)) return path->path;
  if (std::optional<SceneEntry> entry = library.find(stream.request.scene())) {
    entry->may_have_paths = false;
    for (const ScenePath& path : paths) entry->trajectories.push_back(path.name);
    checkName(name, *entry);
  }
  return library.loadTrajectory(stream.request.scene(), name);
}

}  // namespace

void checkTrajectory(ResolvedStream& stream, const SceneEntry& scene) {
  v1::Trajectory& trajectory = *stream.request.mutable_trajectory();
  if (trajectory.path_case() == v1::Trajectory::PATH_NOT_SET)
    refuse("trajectory", "none is given; the scene has: " + valid(scene));
  if (trajectory.has_motion()) checkMotion(*trajectory.mutable_motion());
  if (trajectory.has_name()) checkName(trajectory.name(), scene);
  if (trajectory.has_keyframes())
    stream.given_path = readKeyframes(*trajectory.mutable_keyframes(), "trajectory.keyframes");
  if (trajectory.has_csv()) takeCsv(trajectory.csv(), stream);
}

Trajectory resolveTrajectory(const ResolvedStream& stream, const RenderScene& scene,
                             const SceneLibrary& library, const std::stop_token& stop) {
  const v1::Trajectory& path = stream.request.trajectory();
  try {
    if (path.has_motion())
      return motionIn(scene, motionOf(path.motion(), stream.feed),
                      startOf(path.motion(), scene.description().T_world_camera), Lens(stream.feed.camera),
                      stop);
    if (stream.given_path) return *stream.given_path;
    return byName(stream, scene, library);
  } catch (const SceneError& fault) {
    refuse("trajectory.name", fault.what());
  } catch (const NoRoom& fault) {
    refuse(fault.clearance > 0 ? "trajectory.motion.clearance" : "trajectory.motion.start", fault.what());
  }
}

}  // namespace saccade
