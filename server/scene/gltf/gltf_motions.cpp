#include "scene/gltf/gltf_motions.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/path_sampler.h"
#include "scene/motion/bodies.h"
#include "scene/shape_box.h"

namespace saccade {
namespace {

constexpr double kRigid = 1e-3;  // how far the axes of a body may be from unit length and right angles

// The rotation next to a map, by its z axis and then its y axis.
Quaternion rotationOf(const Affine& a) {
  const Vec3d z = normalize(a.z), x = normalize(cross(a.y, z));
  const Vec3d y = cross(z, x);
  return fromAxes(x, y, z);
}

bool isRigid(const Affine& a) {
  const Vec3d axes[]{a.x, a.y, a.z};
  for (int i = 0; i < 3; ++i)
    if (std::abs(length(axes[i]) - 1) > kRigid || std::abs(dot(axes[i], axes[(i + 1) % 3])) > kRigid)
      return false;
  return true;
}

// A point at this distance moves by as much as the pose.
MotionToSample motionOf(const GltfAnimation& animation, std::size_t i, double reach) {
  return {{}, animation.keyTimes(i), animation.stepTimes(i), reach};
}

}  // namespace

Pose cameraPose(const Affine& world) {
  const Quaternion r = rotationOf(world);
  return {world.translation, fromAxes(rotate(r, {1, 0, 0}), rotate(r, {0, -1, 0}), rotate(r, {0, 0, -1}))};
}

std::vector<TimedPose> cameraPath(const GltfAnimation& animation, std::size_t i, double reach) {
  MotionToSample motion = motionOf(animation, i, reach);
  if (motion.keys.empty()) return {{TimeNs{0}, cameraPose(animation.worldAt(i, 0))}};
  motion.at = [&](double t) { return cameraPose(animation.worldAt(i, t)); };
  return samplePath(motion);
}

Trajectory playedPath(std::vector<TimedPose> poses, double length, double reach) {
  const TimeNs period{std::llround(length * 1e9)};
  const std::vector<TimedPose> ends{poses.front(), poses.back()};
  if (period <= TimeNs{0} || stands(poses, reach) || !stands(ends, reach))
    return Trajectory(std::move(poses));
  if (poses.front().time > TimeNs{0}) poses.insert(poses.begin(), {TimeNs{0}, poses.front().pose});
  if (poses.back().time < period) poses.push_back({period, {}});
  poses.back().pose = poses.front().pose;
  return Trajectory::periodic(std::move(poses));
}

bool staysRigid(const GltfAnimation& animation, std::size_t i) {
  const auto from_rest = inverse(animation.worldAt(i, 0));
  const std::vector<double> keys = animation.keyTimes(i);
  const auto isRigidAt = [&](double t) { return from_rest && isRigid(animation.worldAt(i, t) * *from_rest); };
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const double next = keys[std::min(k + 1, keys.size() - 1)];
    for (const double s : {0.0, 0.25, 0.5, 0.75})
      if (!isRigidAt(keys[k] + (next - keys[k]) * s)) return false;
  }
  return true;
}

FixedBody fixedBody(const Scene& scene, const std::string& name) {
  const Body body = bodyNamed(scene, name);
  const auto isOf = [&](const auto& lamp) { return lamp.name == name; };
  const bool shines_along =
      std::ranges::any_of(scene.spot_lights, isOf) || std::ranges::any_of(scene.directional_lights, isOf);
  const bool turns = body.has_shapes || shines_along || body.low != body.high;
  const ShapeBox box = body.has_shapes ? ShapeBox{body.low, body.high} : boxOf(scene);
  const double radius = std::max(1e-6, length(toDouble(box.high - box.low)) / 2);
  return {name, toDouble(body.centre()) + scene.origin, radius, body.has_shapes, turns};
}

std::optional<OwnMotion> bodyMotion(const GltfAnimation& animation, std::size_t i, const FixedBody& body,
                                    std::vector<std::string>& unread) {
  const auto from_rest = inverse(animation.worldAt(i, 0));
  if (!from_rest) {
    unread.push_back(body.name + " has no size when its animation begins; it stands");
    return {};
  }
  bool rigid = true;
  MotionToSample motion = motionOf(animation, i, body.radius);
  motion.at = [&](double t) {
    const Affine moved = animation.worldAt(i, t) * *from_rest;
    rigid = rigid && isRigid(moved);
    const bool turned = body.turns && determinant(moved) != 0;
    return Pose{mapPoint(moved, body.centre), turned ? rotationOf(moved) : Quaternion{}};
  };
  std::vector<TimedPose> poses = samplePath(motion);
  if (!rigid && body.has_shapes)
    unread.push_back("the size of " + body.name + " changes in its animation; it keeps its first");
  if (stands(poses, body.radius)) return {};
  const std::size_t count = poses.size();
  return OwnMotion{body.name, "animation", playedPath(std::move(poses), animation.length(), body.radius),
                   count};
}

}  // namespace saccade
