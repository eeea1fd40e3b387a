// Area lights: emissive triangles and spheres, chosen by power, sampled uniformly by area. The choice does
// not know of strengths, so that a seed finds the same points in every frame.
#pragma once

#include <cstdint>
#include <vector>

#include "base/lane.h"
#include "scene/scene.h"

namespace saccade {

struct LightSample {
  Vec3 point, normal;      // on the light, the side that emits
  Rgb radiance;            // at strength 1
  Lane pdf;                // per area
  std::uint32_t geometry;  // of EmbreeScene
};

class Lights {
 public:
  explicit Lights(const Scene& scene);

  bool empty() const { return lights_.empty(); }
  LightSample sample(Lane u_light, Lane u1, Lane u2) const;  // not empty

  // pdf per area of sample() on a surface of this radiance at strength 1. Choosing by power makes it
  // independent of the light's size: (Y area / power) / area.
  Lane pdf(Rgb radiance) const { return luminance(radiance) * inv_power_; }

 private:
  struct Light {
    Vec3 corner, edge1, edge2;  // triangle; sphere: corner is the centre
    float radius;               // 0 for a triangle
    Rgb radiance;
    std::uint32_t geometry;
  };
  void add(const Light& light, float area);

  std::vector<Light> lights_;
  std::vector<float> cdf_;  // ascending to 1
  float inv_power_ = 0;
};

}  // namespace saccade
