// Surfaces of bodies that slide in themselves, such as a turntable's. A place of the scene shows the body one
// frame after the other, with one normal. Their light belongs to the place, not to the body [ours]. The place
// is the same but for rounding: a ray that leaves it must not start within the body at the other time.
#pragma once

#include <vector>

#include "render/world/posed_scene.h"

namespace saccade {

// A point of a surface, seen from a camera.
struct SeenPoint {
  Vec3 position, normal;  // normal: geometric
  float offset = 0;       // of rays that leave it, see ray_offset.h
};

class SlidingSurfaces {
 public:
  // The next frame, and the one before it. A body that hardly moves keeps the step that it made last.
  void next(const PosedScene& now, const PosedScene& before);

  // Whether the surface of a body slides in itself: the body's last step puts it on its own place, backwards
  // or forwards. False of a body that has not moved yet, or that deforms.
  bool at(std::uint32_t body, const SeenPoint& point) const;

 private:
  struct Step {
    RigidMotion from, to;
    bool any = false;
  };
  bool shows(std::uint32_t body, Vec3 rest, Vec3 rest_normal, float offset) const;

  const RenderScene* scene_ = nullptr;
  std::vector<Step> last_;  // by body
};

}  // namespace saccade
