#include "feed/pixel_speed.h"

#include <algorithm>
#include <cmath>

#include "base/quantile.h"
#include "feed/feed.h"
#include "feed/moving_view.h"
#include "render/camera/view_grid.h"
#include "render/world/render_scene.h"
#include "scene/camera/image_speed.h"
#include "scene/motion/bodies.h"

namespace saccade {
namespace {

constexpr int kColumns = 32, kRows = 24;
constexpr FrameIndex kInstants = 16;
constexpr TimeNs kLongest{60'000'000'000};

// The points in view, in the axes of the camera.
VisiblePoints gridView(const RenderScene& scene, const Camera& camera, const CameraModel& model) {
  VisiblePoints view;
  for (const ViewHit& hit : viewHits(scene, camera, {model.width, model.height, kColumns, kRows})) {
    const Vec2 at = camera.planePoint(hit.x, hit.y);
    view.push_back(Vec3d{at.x, at.y, 1} * static_cast<double>(hit.z));
  }
  return view;
}

// Of the path that lasts longest, or of the forms of bodies.
FrameIndex framesOfPaths(const Scene& scene, const Trajectory& path, const FeedConfig& config,
                         FrameIndex frames) {
  FrameIndex most = framesToLookAt(path, config.frame_rate_hz, frames);
  for (const Trajectory& body : config.body_paths)
    most = std::max(most, framesToLookAt(body, config.frame_rate_hz, frames));
  if (const TimeNs last = lastFormKey(scene); last > TimeNs{0})
    most = std::max(
        most, framesToLookAt(Trajectory(std::vector<TimedPose>{{last, {}}}), config.frame_rate_hz, frames));
  return most;
}

}  // namespace

FrameIndex framesToLookAt(const Trajectory& path, double rate_hz, FrameIndex frames) {
  const double span_s = seconds(std::clamp(path.lastTime(), TimeNs{0}, kLongest));
  const auto moving = std::max(FrameIndex{1}, static_cast<FrameIndex>(std::ceil(span_s * rate_hz)));
  return frames == 0 ? moving : std::min(frames, moving);
}

PixelSpeed measurePixelSpeed(const RenderScene& scene, const Trajectory& path, const FeedConfig& config,
                             FrameIndex frames) {
  const FrameIndex all = framesOfPaths(scene.description(), path, config, frames);
  const FrameIndex instants = std::min(all, kInstants);
  const Lens lens(config.camera);
  std::optional<MovingView> bodies;
  if (!config.body_paths.empty()) bodies.emplace(scene, config.body_paths);
  std::vector<double> lengths;
  double px_per_focal = 0;
  for (FrameIndex i = 0; i < instants; ++i) {
    const FrameIndex frame = 1 + i * all / instants;
    const TimeNs t1 = frameTime(frame, config.frame_rate_hz), t0 = frameTime(frame - 1, config.frame_rate_hz);
    const Pose cur = path.at(t1), prev = path.at(t0);
    const Camera camera(scene.inScene(cur), lens);
    const Pose step = cur == prev ? Pose{} : inverse(cur) * prev;  // exactly 0 where it stands
    if (bodies)
      bodies->appendSteps({camera, t1}, {Camera(scene.inScene(prev), lens), t0}, config.camera, lengths);
    else
      appendImageSteps(gridView(scene, camera, config.camera), step, Pose{}, lens, lengths);
    px_per_focal = 1 / static_cast<double>(camera.pixel);
  }
  if (lengths.empty()) return {};
  return {px_per_focal * quantile(lengths, 0.5), px_per_focal * quantile(lengths, 0.99)};
}

}  // namespace saccade
