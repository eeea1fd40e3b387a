// The lamps of a scene: emissive triangles and spheres, and points.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/lights/incident_light.h"
#include "render/lights/lamp_tree.h"
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

struct ChosenLamp {
  std::uint32_t number;
  float pdf;  // per area; of a point the probability; 0: none shines there
};

// A point of an emitter that a ray has found.
struct EmitterPoint {
  std::uint32_t geometry, primitive;
  Rgb radiance;  // at strength 1
};

// Several lamps are chosen by what they can give at a point, with a tree. Two triangles that make a flat quad
// are one lamp of it. Places on a lamp are uniform by area. The probabilities do not depend on strengths, so
// that a seed finds the same points in every frame.
class Lamps {
 public:
  explicit Lamps(const Scene& scene);

  bool has(LightSet set) const { return !byPower(set).empty(); }
  bool hasTree(LightSet set) const { return of(set).tree.has_value(); }

  // Of numbers in [0, 1): u_lamp chooses a lamp, u1 and u2 a place on it. There must be a lamp.
  ChosenLamp choose(LightSet set, const Receiver& at, float u_lamp) const;
  IncidentLight sample(const ChosenLamp& lamp, Vec3 point, float u1, float u2) const;

  // The pdf of both per area, at a point of an emitter.
  float pdf(LightSet set, const EmitterPoint& point, const Receiver& at) const;

  // The first lamps by their numbers. Points follow.
  const std::vector<AreaLamp>& areaLamps() const { return area_lamps_; }
  std::size_t count() const { return area_lamps_.size() + points_.size(); }
  // Chooses where there is no tree. The pdf per area is the radiance's luminance over the sum of weights.
  const LightChoice& byPower(LightSet set) const { return of(set).by_power; }

 private:
  // Of the tree: one lamp, or the triangles of a quad.
  struct Leaf {
    std::uint32_t first, count;
    float area;
  };
  struct Set {
    LightChoice by_power;
    std::optional<LampTree> tree;
  };

  const Set& of(LightSet set) const { return sets_[static_cast<std::size_t>(set)]; }
  void addLeaf(std::span<const AreaLamp> lamps);
  void addMesh(const Mesh& mesh, std::uint32_t geometry);
  void addSets();
  LampBounds boundsOf(const Leaf& leaf) const;
  IncidentLight ofArea(const AreaLamp& lamp, float pdf, Vec3 point, float u1, float u2) const;

  std::vector<AreaLamp> area_lamps_;
  std::vector<PointLight> points_;
  std::vector<Leaf> leaves_;
  std::vector<std::uint32_t> first_primitive_;    // by geometry, among those of all emitters
  std::vector<std::uint32_t> leaf_of_primitive_;  // of all emitters
  std::array<Set, kLightSets> sets_;
};

}  // namespace saccade
