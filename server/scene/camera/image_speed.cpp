#include "scene/camera/image_speed.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr double kNear = 1e-6;  // points nearer than this have no image

Vec3d mapPoint(const Pose& pose, Vec3d p) {
  return pose.position + rotate(pose.rotation, p);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

VisiblePoints viewOf(const Pose& camera, const std::vector<Vec3>& points) {
  const Pose to_camera = inverse(camera);
  VisiblePoints view;
  for (const Vec3 point : points) {
    const Vec3d p = mapPoint(to_camera, toDouble(point));
    if (p.z > kNear) view.push_back(p);
  }
  if (view.empty()) view.push_back({0, 0, 1});
  return view;
}

double medianDepth(const VisiblePoints& view) {
  std::vector<double> depths;
  for (const Vec3d p : view) depths.push_back(p.z);
  return median(std::move(depths));
}

double medianImageSpeed(const VisiblePoints& view, const Twist& camera) {
  std::vector<double> speeds;
  for (const Vec3d p : view) {
    const Vec3d v = -camera.linear - cross(camera.angular, p);
    speeds.push_back(std::hypot(v.x - p.x / p.z * v.z, v.y - p.y / p.z * v.z) / p.z);
  }
  return median(std::move(speeds));
}

void appendImageSteps(const VisiblePoints& view, const Pose& from, const Pose& to,
                      std::vector<double>& lengths) {
  const Pose before = inverse(from), after = inverse(to);
  for (const Vec3d p : view) {
    const Vec3d a = mapPoint(before, p), b = mapPoint(after, p);
    if (a.z < kNear || b.z < kNear) continue;
    lengths.push_back(std::hypot(b.x / b.z - a.x / a.z, b.y / b.z - a.y / a.z));
  }
}

double medianImageSpeed(const VisiblePoints& view, const std::vector<Pose>& path, double step_s) {
  constexpr std::size_t kStride = 10;  // enough to know the median
  std::vector<double> lengths{0};
  for (std::size_t i = 0; i + 1 < path.size(); i += kStride)
    appendImageSteps(view, path[i], path[i + 1], lengths);
  return median(std::move(lengths)) / step_s;
}

}  // namespace saccade
