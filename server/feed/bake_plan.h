// The input of a bake, beside the scene. Equal plans give equal bakes.
#pragma once

#include <vector>

#include "feed/feed.h"

namespace saccade {

struct BakePlan {
  std::vector<Pose> poses{};  // of the camera: all places that it looks from
  CameraModel camera = pinhole(45, 256, 256);
  int bounces = 3, channels = 3;
  float error = 0.02f;  // relative, of the light of about a pixel, that is asked for
  int memory = 512;     // MiB, of the grid while it is made
};

// For the frames 0 to framesToLookAt() of a feed. Its poses are some pixels apart. Throws std::runtime_error
// where the light of the scene changes over time, or objects move.
BakePlan planBake(const RenderScene& scene, const Trajectory& path, const FeedConfig& feed, FrameIndex frames,
                  double error);

// Of all that the bake depends on.
std::uint64_t digestOf(const RenderScene& scene, const BakePlan& plan);

}  // namespace saccade
