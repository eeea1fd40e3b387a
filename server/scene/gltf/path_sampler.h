// Poses that a motion goes through, so that the path between them stays near it.
#pragma once

#include <functional>
#include <vector>

#include "scene/camera/trajectory.h"

namespace saccade {

// A motion over time, in seconds.
struct MotionToSample {
  std::function<Pose(double)> at;
  std::vector<double> keys;   // times where it may turn, increasing; at least one
  std::vector<double> steps;  // those of them where it jumps
  double reach;               // the greatest distance of a point that moves from the position of the pose
};

inline constexpr double kPathError = 1e-4;  // of the reach, for any point that moves
inline constexpr std::size_t kMostPathPoses = 200'000;

// Poses at the keys and between them, with times that increase. Throws SceneError where one is beyond
// kMaxDistance, or more are needed than kMostPathPoses.
std::vector<TimedPose> samplePath(const MotionToSample& motion);

// Whether all the poses are one.
bool stands(const std::vector<TimedPose>& path, double reach);

}  // namespace saccade
