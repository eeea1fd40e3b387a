// A small room for tests of feeds.
#pragma once

#include <memory>

#include "render/test_scenes.h"
#include "render/world/render_scene.h"

namespace saccade::test {

// Walls under a lamp, and a ball that casts a shadow.
inline std::shared_ptr<const RenderScene> room(const Strength& lamp = {}) {
  Scene s = furnace(0.6f, 0);
  s.meshes.push_back(quad({-0.3f, -0.95f, -0.3f}, {0, 0, 0.6f}, {0.6f, 0, 0}, 0, {9, 9, 9}));
  s.meshes.back().strength = lamp;
  s.spheres.push_back({"ball", {0.2f, 0.5f, 0.5f}, 0.4f, 0, {}});
  return std::make_shared<RenderScene>(std::move(s));
}

}  // namespace saccade::test
