#include "feed/pixel_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/quantile.h"
#include "feed/feed.h"
#include "scene/camera/image_speed.h"

namespace saccade {
namespace {

constexpr int kColumns = 32, kRows = 24;
constexpr FrameIndex kInstants = 16;
constexpr TimeNs kLongest{60'000'000'000};

// What is in view, in the axes of the camera.
VisiblePoints gridView(const RenderScene& scene, const Camera& camera, const FeedConfig& config) {
  VisiblePoints view;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const float x =
          (static_cast<float>(column) + 0.5f) * static_cast<float>(config.width) / kColumns - 0.5f;
      const float y = (static_cast<float>(row) + 0.5f) * static_cast<float>(config.height) / kRows - 0.5f;
      const Hit hit = scene.geometry().intersect(
          {camera.origin, camera.direction(x, y), std::numeric_limits<float>::infinity()});
      const Vec3d direction{(x - camera.cx) * camera.pixel, (y - camera.cy) * camera.pixel, 1};
      if (hit.valid) view.push_back(direction * static_cast<double>(hit.t));
    }
  }
  return view;
}

FrameIndex framesToLookAt(const Trajectory& path, double rate_hz, FrameIndex frames) {
  const double span_s = seconds(std::clamp(path.lastTime(), TimeNs{0}, kLongest));
  const auto moving = std::max(FrameIndex{1}, static_cast<FrameIndex>(std::ceil(span_s * rate_hz)));
  return frames == 0 ? moving : std::min(frames, moving);
}

}  // namespace

PixelSpeed measurePixelSpeed(const RenderScene& scene, const Trajectory& path, const FeedConfig& config,
                             FrameIndex frames) {
  const FrameIndex all = framesToLookAt(path, config.frame_rate_hz, frames);
  const FrameIndex instants = std::min(all, kInstants);
  std::vector<double> lengths;
  double px_per_focal = 0;
  for (FrameIndex i = 0; i < instants; ++i) {
    const FrameIndex frame = 1 + i * all / instants;
    const Pose cur = path.at(frameTime(frame, config.frame_rate_hz));
    const Pose prev = path.at(frameTime(frame - 1, config.frame_rate_hz));
    const Camera camera(cur, config.fov_x_deg, config.width, config.height);
    const Pose step = cur == prev ? Pose{} : inverse(cur) * prev;  // exactly 0 where it stands
    appendImageSteps(gridView(scene, camera, config), step, Pose{}, lengths);
    px_per_focal = 1 / static_cast<double>(camera.pixel);
  }
  if (lengths.empty()) return {};
  return {px_per_focal * quantile(lengths, 0.5), px_per_focal * quantile(lengths, 0.99)};
}

}  // namespace saccade
