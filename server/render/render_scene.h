// A scene made ready for tracing: geometry in Embree, lights, surfaces at hits. Shared by any number of
// feeds.
#pragma once

#include <vector>

#include "render/embree_scene.h"
#include "render/lights.h"
#include "scene/scene.h"

namespace saccade {

// What shading needs of a point on a surface.
struct Surface {
  Vec3 point;
  Vec3 geometric_normal, shading_normal;  // unit, on the side the ray came from
  Rgb albedo;                             // texture-filtered; 0 behind a one-sided material
  Rgb radiance;                           // emitted towards the ray's origin at strength 1
};

class RenderScene {
 public:
  explicit RenderScene(Scene scene);

  const Scene& description() const { return scene_; }
  const EmbreeScene& geometry() const { return geometry_; }
  const Lights& lights() const { return lights_; }
  int channels() const { return channels_; }

  // `footprint`: width of the region that one sample stands for, seen at a right angle, in scene units.
  Surface surface(const Ray& ray, const Hit& hit, float footprint) const;

  // A ray's origin on a surface, moved off it so that it does not hit it again.
  Vec3 leave(const Surface& s) const { return s.point + s.geometric_normal * epsilon_; }

 private:
  struct Patch {  // the place of a hit within its shape
    Vec3 point, shading_normal;
    Vec2 uv;
    float uv_per_length;  // texture units per scene unit
    int material;
    Rgb radiance;
  };
  Patch meshPatch(const Mesh& mesh, const Hit& hit, Vec3 normal) const;
  Patch spherePatch(const Sphere& sphere, Vec3 normal) const;
  Rgb reflectance(const SurfaceColor& r, Vec2 uv, float footprint) const;

  Scene scene_;
  EmbreeScene geometry_;
  Lights lights_;
  int channels_;
  float epsilon_;
};

}  // namespace saccade
