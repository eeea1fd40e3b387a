// The free space of a scene that is ready for tracing.
#pragma once

#include "render/world/render_scene.h"
#include "scene/camera/free_space.h"

namespace saccade {

// Every surface counts, of either side, and those that let light through too. `scene` must outlive it.
class SceneSpace : public FreeSpace {
 public:
  explicit SceneSpace(const RenderScene& scene) : scene_(scene) {}

  double distance(Vec3d point, double reach) const override;
  void look(Vec3d from, std::span<const Vec3d> directions, std::span<double> distances) const override;

 private:
  Vec3d inScene(Vec3d point) const { return point - scene_.description().origin; }

  const RenderScene& scene_;
};

}  // namespace saccade
