// The light sources of a scene. Lights are sampled by their power, and points on emissive triangles and
// spheres uniformly by area. The probabilities do not depend on strengths, so that a seed finds the same
// points in every frame.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/lights/environment_light.h"
#include "render/surface/surface.h"
#include "scene/scene.h"

namespace saccade {

inline constexpr float kShadowEnd = 1 - 1e-4f;  // shadow rays stop just before the light

// Light that reaches a point unless something blocks it.
struct IncidentLight {
  Vec3 direction;                        // to the light, unit
  Vec3 segment;                          // of the shadow ray
  float reach;                           // its end, in lengths of the segment
  Rgb radiance;                          // at strength 1; of a delta light its irradiance at a right angle
  float pdf;                             // per solid angle; delta: the probability of the light; 0: none
  bool delta = false;                    // from one direction, which no sample of a BSDF finds
  std::uint32_t geometry = kNoGeometry;  // of EmbreeScene
  static constexpr std::uint32_t kNoGeometry = 0xffffffffu;
};

struct AreaLight {
  Vec3 corner, edge1, edge2;  // triangle; sphere: corner is the centre
  float radius;               // 0 for a triangle
  Rgb radiance;
  std::uint32_t geometry;
};

class Lights {
 public:
  // Keeps a pointer to the pixels of the scene's environment. `radius` is that of the scene.
  Lights(const Scene& scene, float radius);

  bool empty() const { return cdf_.empty(); }

  // A sample of the light at `point`. u_light chooses the light, u1 and u2 a place on it. There must be a
  // light.
  IncidentLight at(Vec3 point, float u_light, float u1, float u2) const;

  // The pdf of at() per area, on a surface of this radiance at strength 1. It does not depend on the light's
  // size, because lights are chosen by power: (Y area / power) / area.
  float pdf(Rgb radiance) const { return luminance(radiance) * inv_power_; }

  // Light from infinity, and the pdf of at() for it per solid angle. Both are 0 without an environment.
  Rgb distantRadiance(Vec3 direction) const;
  float distantPdf(Vec3 direction) const;

  // The first lights. All lights are chosen by the running sums of their probabilities, which rise to 1.
  const std::vector<AreaLight>& areaLights() const { return area_lights_; }
  const std::vector<float>& cdf() const { return cdf_; }

 private:
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
