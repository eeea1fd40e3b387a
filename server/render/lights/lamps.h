// The lamps of a scene: emissive triangles and spheres, and points.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/lights/incident_light.h"
#include "render/lights/light_choice.h"
#include "scene/scene.h"

namespace saccade {

struct AreaLamp {
  Vec3 corner, edge1, edge2;  // triangle; sphere: corner is the centre
  float radius;               // 0 for a triangle
  Rgb radiance;
  std::uint32_t geometry;

  float area() const;
};

// Lamps are chosen by their power, and points on triangles and spheres uniformly by area. The probabilities
// do not depend on strengths, so that a seed finds the same points in every frame.
class Lamps {
 public:
  explicit Lamps(const Scene& scene);

  bool has(LightSet set) const { return !choice(set).empty(); }

  // A sample at `point`. u_lamp chooses the lamp, u1 and u2 a place on it. There must be a lamp.
  IncidentLight sample(LightSet set, Vec3 point, float u_lamp, float u1, float u2) const;

  // The pdf of sample() per area, on a surface of this radiance at strength 1. It does not depend on the
  // lamp's size, because lamps are chosen by power: (Y area / power) / area.
  float pdf(LightSet set, Rgb radiance) const { return luminance(radiance) * choice(set).inverseWeight(); }

  // The first lamps.
  const std::vector<AreaLamp>& areaLamps() const { return area_lamps_; }
  const LightChoice& choice(LightSet set) const { return choices_[static_cast<std::size_t>(set)]; }

 private:
  void addAreaLamps(const Scene& scene);
  void add(const AreaLamp& lamp);
  IncidentLight ofArea(const AreaLamp& lamp, float pdf, Vec3 point, float u1, float u2) const;

  std::vector<AreaLamp> area_lamps_;
  std::vector<PointLight> points_;
  std::array<LightChoice, kLightSets> choices_;  // of area lamps, then points
};

}  // namespace saccade
