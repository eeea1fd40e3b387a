// Light sources, chosen by power: emissive triangles and spheres, sampled uniformly by area, and lights that
// are no surface. The choice does not know of strengths, so that a seed finds the same points in every frame.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/environment_light.h"
#include "render/surface.h"
#include "scene/scene.h"

namespace saccade {

// Light that reaches a point unless something stands in between.
struct IncidentLight {
  Vec3 direction;                        // to the light, unit
  Vec3 segment;                          // of the shadow ray
  float reach;                           // its end, in lengths of the segment
  Rgb radiance;                          // at strength 1; of a delta light its irradiance at a right angle
  float pdf;                             // per solid angle; delta: the probability of the light; 0: none
  bool delta = false;                    // from one direction, which no ray finds by chance
  std::uint32_t geometry = kNoGeometry;  // of EmbreeScene
  static constexpr std::uint32_t kNoGeometry = 0xffffffffu;
};

class Lights {
 public:
  // Keeps a pointer to the pixels of the scene's environment. `radius`: of the scene.
  Lights(const Scene& scene, float radius);

  bool empty() const { return cdf_.empty(); }

  // Light at `point` from a light chosen by u_light, at a place chosen by u1 and u2. Not empty.
  IncidentLight at(Vec3 point, float u_light, float u1, float u2) const;

  // pdf per area of at() on a surface of this radiance at strength 1. Choosing by power makes it independent
  // of the light's size: (Y area / power) / area.
  float pdf(Rgb radiance) const { return luminance(radiance) * inv_power_; }

  // Light from infinity, and the pdf per solid angle of at() for it; 0 without an environment.
  Rgb distantRadiance(Vec3 direction) const;
  float distantPdf(Vec3 direction) const;

 private:
  struct AreaLight {
    Vec3 corner, edge1, edge2;  // triangle; sphere: corner is the centre
    float radius;               // 0 for a triangle
    Rgb radiance;
    std::uint32_t geometry;
  };
  void addAreaLights(const Scene& scene);
  void add(const AreaLight& light, float area);
  void choose(float power);
  IncidentLight areaLight(const AreaLight& light, Vec3 point, float u1, float u2) const;
  IncidentLight otherLight(std::size_t i, Vec3 point, float u1, float u2) const;
  float probability(std::size_t i) const { return i == 0 ? cdf_[0] : cdf_[i] - cdf_[i - 1]; }

  std::vector<AreaLight> area_lights_;
  std::vector<PointLight> point_lights_;
  std::vector<DirectionalLight> directional_lights_;
  std::optional<EnvironmentLight> environment_;
  std::vector<float> cdf_;  // over all of these in this order, ascending to 1
  float inv_power_ = 0;
};

}  // namespace saccade
