#include "scene/gltf/path_sampler.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/files/scene_error.h"

namespace saccade {
namespace {

constexpr int kMostHalvings = 10;     // of the time between two keys
constexpr double kBeforeStep = 1e-9;  // seconds

// How far a point within reach is from where it should be.
double error(const Pose& a, const Pose& b, double reach) {
  return length(a.position - b.position) + reach * length(rotationVector(conjugate(a.rotation) * b.rotation));
}

class Sampler {
 public:
  explicit Sampler(const MotionToSample& motion) : motion_(motion) {}

  std::vector<TimedPose> sample() {
    add(motion_.keys[0], poseAt(motion_.keys[0]));
    for (std::size_t i = 1; i < motion_.keys.size(); ++i) {
      const double begin = motion_.keys[i - 1], end = motion_.keys[i];
      const bool jumps = std::ranges::binary_search(motion_.steps, end);
      const double last = jumps ? std::max(begin, end - kBeforeStep) : end;
      refine(begin, poseAt(begin), last, poseAt(last), 0);
      if (jumps) add(end, poseAt(end));
    }
    return std::move(path_);
  }

 private:
  Pose poseAt(double t) const { return motion_.at(t); }

  // A symmetric curve may be right in the middle alone.
  bool isNear(double begin, const Pose& a, double end, const Pose& b) const {
    return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double s) {
      const Pose there = interpolate(a, {b.position, unitNear(b.rotation, a.rotation)}, s);
      return error(there, poseAt(begin + (end - begin) * s), motion_.reach) <= kPathError * motion_.reach;
    });
  }

  void refine(double begin, const Pose& a, double end, const Pose& b, int depth) {
    if (depth < kMostHalvings && !isNear(begin, a, end, b)) {
      const double middle = (begin + end) / 2;
      const Pose between = poseAt(middle);
      refine(begin, a, middle, between, depth + 1);
      refine(middle, between, end, b, depth + 1);
    } else {
      add(end, b);
    }
  }

  void add(double t, Pose pose) {
    const TimeNs time{std::llround(t * 1e9)};
    if (!path_.empty()) {
      if (time <= path_.back().time) return;
      pose.rotation = unitNear(pose.rotation, path_.back().pose.rotation);
    }
    const Vec3d p = pose.position;
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kMaxDistance) ||
        !isRotation(pose.rotation))
      throw SceneError("a motion leaves the region within 1e9 of the origin");
    if (path_.size() == kMostPathPoses)
      throw SceneError("a motion needs more than " + std::to_string(kMostPathPoses) + " poses");
    path_.push_back({time, pose});
  }

  const MotionToSample& motion_;
  std::vector<TimedPose> path_;
};

}  // namespace

std::vector<TimedPose> samplePath(const MotionToSample& motion) {
  return Sampler(motion).sample();
}

bool stands(const std::vector<TimedPose>& path, double reach) {
  return std::ranges::all_of(
      path, [&](const TimedPose& key) { return error(path[0].pose, key.pose, reach) <= kPathError * reach; });
}

}  // namespace saccade
