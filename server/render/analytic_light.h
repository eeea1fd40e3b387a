// Direct light in closed form, as if nothing cast a shadow: from lamps of a few flat sides, and from points
// and directions.
#pragma once

#include <vector>

#include "render/lights.h"
#include "scene/emitter_strengths.h"

namespace saccade {

class AnalyticLight {
 public:
  explicit AnalyticLight(const Scene& scene);

  // Whether at() holds the light of an emitter, by its geometry id, or of a sample.
  bool holds(std::uint32_t geometry) const { return geometry < held_.size() && held_[geometry]; }
  bool holds(const IncidentLight& light) const { return light.delta || holds(light.geometry); }

  // Radiance that a white diffuse surface would reflect: irradiance / pi. `normal` is the shading normal;
  // light comes only from the side of `geometric_normal`. Both unit.
  Rgb at(Vec3 point, Vec3 normal, Vec3 geometric_normal, const EmitterStrengths& strengths) const;

 private:
  struct Side {
    std::vector<Vec3> corners;  // of a convex polygon, counter-clockwise as seen from the lit side
    Vec3 normal;                // unit
    Rgb radiance;
    std::uint32_t geometry;
  };
  void addSides(const Mesh& mesh, std::uint32_t geometry);

  std::vector<Side> sides_;
  std::vector<char> held_;  // by geometry id
  std::vector<PointLight> point_lights_;
  std::vector<DirectionalLight> directional_lights_;
};

}  // namespace saccade
