// Direct light of lamps of a few flat sides, of disks and of spheres, in closed form, as if nothing cast a
// shadow.
// Their light does not vary over their surface.
#pragma once

#include <algorithm>
#include <vector>

#include "base/lane_vectors.h"
#include "render/lights/disk.h"
#include "render/lights/incident_light.h"
#include "render/lights/polygon.h"
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
  static constexpr int kMaxGroups = 4;
  static constexpr std::size_t kMaxSides = 16;  // of all lamps: more cost more than their shadows tell

  struct Side {
    enum class Form { kPolygon, kDisk, kSphere };
    Form form;
    // Of a convex polygon, counter-clockwise as seen from the lit side; else the centre.
    std::vector<Vec3> corners;
    Vec3 normal;   // unit; a sphere has none
    float radius;  // of a disk or a sphere
    Rgb radiance;
    std::uint32_t geometry;
    int group;  // of the lamps whose shadows are one, see groups()

    Disk disk() const { return {corners[0], normal, radius}; }
  };

  explicit AnalyticLight(const Scene& scene);

  // Whether at() holds the light of an emitter, by its geometry id.
  bool holds(std::uint32_t geometry) const { return geometry < held_.size() && held_[geometry]; }

  const std::vector<Side>& sides() const { return sides_; }  // those of a group are neighbours
  // A lamp is a group of its own, up to kMaxGroups - 1; all others are one group.
  int groups() const { return sides_.empty() ? 0 : sides_.back().group + 1; }
  // The share of the cosine-weighted hemisphere above a point that a side covers.
  static float formFactor(const Side& side, const LitPoint& p);
  // The part of a polygon that lights a point, from the point.
  static Polygon seen(const Side& side, const LitPoint& p);
  // The share that this part of a side covers.
  static float formFactor(const Polygon& seen, const LitPoint& p);

  // Radiance that a white diffuse surface would reflect: irradiance / pi.
  Rgb at(const LitPoint& p, const EmitterStrengths& strengths) const;
  // The same for the lanes of a mask. Other lanes of the result are undefined.
  void at(const LitPoints& points, LaneSet lanes, const EmitterStrengths& strengths,
          LaneVectors& result) const;

 private:
  void addMesh(const Mesh& mesh, std::uint32_t geometry);
  void addSides(const Mesh& mesh, std::uint32_t geometry);
  int nextGroup() const { return std::min(groups(), kMaxGroups - 1); }

  std::vector<Side> sides_;
  std::vector<char> held_;  // by geometry id
};

}  // namespace saccade
