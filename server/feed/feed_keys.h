// New keys of the paths of a feed that is steered.
#pragma once

#include <cstddef>
#include <vector>

#include "scene/camera/trajectory.h"

namespace saccade {

struct BodyKey {
  std::size_t body;  // of Scene::bodies
  TimedPose key;
};

struct FeedKeys {
  TimedPose camera;
  std::vector<BodyKey> bodies = {};  // those that are steered; the others follow their paths
};

}  // namespace saccade
