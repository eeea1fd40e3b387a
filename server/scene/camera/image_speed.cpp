#include "scene/camera/image_speed.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr double kNear = 1e-6;  // points nearer than this have no image

Vec3d mapPoint(const Pose& pose, Vec3d p) {
  return pose.position + rotate(pose.rotation, p);
}

// The image of a point, in focal lengths from the principal point.
PlanePoint imageOf(Vec3d p, const Lens& lens) {
  const CameraModel& c = lens.camera();
  if (!lens.isDistorted()) return {p.x / p.z * (c.fx / c.focal()), p.y / p.z * (c.fy / c.focal())};
  const PlanePoint at = lens.pixelOf({p.x / p.z, p.y / p.z});
  return {(at.x - c.cx) / c.focal(), (at.y - c.cy) / c.focal()};
}

// How fast the image moves where the point in the plane at distance 1 moves by (x, y).
double imageStep(PlanePoint at, double x, double y, const Lens& lens) {
  const CameraModel& c = lens.camera();
  const PlaneMap slope = distortionSlope(c.distortion, at);
  return std::hypot((slope.xx * x + slope.xy * y) * (c.fx / c.focal()),
                    (slope.yx * x + slope.yy * y) * (c.fy / c.focal()));
}

void appendImageSpeeds(const VisiblePoints& view, const Twist& camera, const Lens& lens,
                       std::vector<double>& speeds) {
  for (const Vec3d p : view) {
    const Vec3d v = -camera.linear - cross(camera.angular, p);
    const PlanePoint at{p.x / p.z, p.y / p.z};
    speeds.push_back(imageStep(at, v.x - at.x * v.z, v.y - at.y * v.z, lens) / p.z);
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

VisiblePoints viewOf(const Pose& camera, const std::vector<Vec3d>& points) {
  const Pose to_camera = inverse(camera);
  VisiblePoints view;
  for (const Vec3d point : points) {
    const Vec3d p = mapPoint(to_camera, point);
    if (p.z > kNear) view.push_back(p);
  }
  if (view.empty()) view.push_back({0, 0, 1});
  return view;
}

double nearestDepth(const VisiblePoints& view) {
  return std::min_element(view.begin(), view.end(), [](Vec3d a, Vec3d b) { return a.z < b.z; })->z;
}

std::vector<double> imageSpeeds(const VisiblePoints& view, const Twist& camera, const Lens& lens) {
  std::vector<double> speeds;
  appendImageSpeeds(view, camera, lens, speeds);
  return speeds;
}

double medianImageSpeed(const VisiblePoints& view, const Twist& camera, const Lens& lens) {
  return median(imageSpeeds(view, camera, lens));
}

double medianImageSpeed(const VisiblePoints& view, const SinePath& path, const Lens& lens) {
  constexpr int kInstants = 200;  // enough to know the median
  std::vector<double> speeds;
  for (int i = 0; i < kInstants; ++i) {
    const TimeNs t = path.period / kInstants * i;
    const Velocity v = path.velocityAt(t);
    appendImageSpeeds(view, {rotate(conjugate(path.at(t).rotation), v.linear), v.angular}, lens, speeds);
  }
  return median(std::move(speeds));
}

void appendImageSteps(const VisiblePoints& view, const Pose& from, const Pose& to, const Lens& lens,
                      std::vector<double>& lengths) {
  const Pose before = inverse(from), after = inverse(to);
  for (const Vec3d p : view) {
    const Vec3d a = mapPoint(before, p), b = mapPoint(after, p);
    if (a.z < kNear || b.z < kNear) continue;
    const PlanePoint begin = imageOf(a, lens), end = imageOf(b, lens);
    lengths.push_back(std::hypot(end.x - begin.x, end.y - begin.y));
  }
}

}  // namespace saccade
