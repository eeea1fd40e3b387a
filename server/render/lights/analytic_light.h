// Direct light in closed form, as if nothing cast a shadow: from lamps of a few flat sides, and from points,
// spots and directions.
#pragma once

#include <vector>

#include "base/lane_vectors.h"
#include "render/lights/incident_light.h"
#include "scene/emitter_strengths.h"

namespace saccade {

struct LitPoint {
  Vec3 point;
  Vec3 normal;            // unit, for shading
  Vec3 geometric_normal;  // unit; light comes from its side alone
};

// The same in lanes.
struct LitPoints {
  const LaneVectors &point, &normal, &geometric_normal;

  LitPoint at(int lane) const { return {point.at(lane), normal.at(lane), geometric_normal.at(lane)}; }
};

class AnalyticLight {
 public:
  explicit AnalyticLight(const Scene& scene);

  // Whether at() holds the light of an emitter, by its geometry id, or of a sample.
  bool holds(std::uint32_t geometry) const { return geometry < held_.size() && held_[geometry]; }
  bool holds(const IncidentLight& light) const { return light.delta || holds(light.geometry); }

  // Radiance that a white diffuse surface would reflect: irradiance / pi.
  Rgb at(const LitPoint& p, const EmitterStrengths& strengths) const;
  // The same for the lanes of a mask. Other lanes of the result are undefined.
  void at(const LitPoints& points, LaneSet lanes, const EmitterStrengths& strengths,
          LaneVectors& result) const;

 private:
  struct Side {
    std::vector<Vec3> corners;  // of a convex polygon, counter-clockwise as seen from the lit side
    Vec3 normal;                // unit
    Rgb radiance;
    std::uint32_t geometry;
  };
  void addSides(const Mesh& mesh, std::uint32_t geometry);
  static Rgb from(const Side& side, const LitPoint& p, float strength);
  Rgb fromPointsAndDirections(const LitPoint& p) const;

  std::vector<Side> sides_;
  std::vector<char> held_;  // by geometry id
  std::vector<PointLight> point_lights_;
  std::vector<SpotLight> spot_lights_;
  std::vector<DirectionalLight> directional_lights_;
};

}  // namespace saccade
