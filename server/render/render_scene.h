// A scene made ready for tracing: geometry in Embree, lights, tables of materials. Shared by any number of
// feeds.
#pragma once

#include <vector>

#include "render/embree_scene.h"
#include "render/lights.h"
#include "render/surface.h"
#include "scene/scene.h"

namespace saccade {

class RenderScene {
 public:
  explicit RenderScene(Scene scene);

  const Scene& description() const { return scene_; }
  const EmbreeScene& geometry() const { return geometry_; }
  const Lights& lights() const { return lights_; }
  Shading shading() const { return shading_; }  // what the scene has
  int channels() const { return channels_; }
  std::size_t bytes() const;  // of geometry, Embree's tree over it, and textures: nearly all of its memory

  // Whether some surface lets shadow rays through.
  bool hasStraightTransmission() const { return has_straight_transmission_; }

  // Of a material.
  const BsdfTables& tables(int material) const { return tables_[material]; }

  // A ray's origin on a surface, moved off it so that it does not hit it again: on the side the last ray came
  // from, or through it.
  Vec3 leave(const Surface& s, bool through = false) const {
    return s.point + s.geometric_normal * (through ? -epsilon_ : epsilon_);
  }

 private:
  Scene scene_;
  EmbreeScene geometry_;
  Lights lights_;
  Shading shading_;
  int channels_;
  bool has_straight_transmission_;
  float epsilon_;
  std::vector<BsdfTables> tables_;  // by material
};

}  // namespace saccade
