// The lamps of a scene: emissive triangles and spheres, points and spots.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/lights/incident_light.h"
#include "render/lights/lamp_picture.h"
#include "render/lights/lamp_tree.h"
#include "render/lights/light_choice.h"
#include "scene/scene.h"

namespace saccade {

struct AreaLamp {
  Vec3 corner, edge1, edge2;  // triangle; sphere: corner is the centre
  float radius;               // 0 for a triangle
  Rgb radiance;               // on average, where it varies
  std::uint32_t geometry;
  int picture = -1;  // of Lamps: how it varies; -1: not at all

  float area() const;
  // A place that is uniform by area, of two numbers in [0, 1), and its unit normal.
  struct Place {
    Vec3 point, normal;
  };
  Place at(float u1, float u2) const;
};

// One lamp, or the two triangles of a flat quad, or those of a disk: what a tree chooses from.
struct LampLeaf {
  std::uint32_t first, count;
  float area;             // of a point 1
  float first_share = 1;  // of the first lamp, of the area; all further ones have equal shares
};

struct ChosenLamp {
  std::uint32_t number;
  float pdf;  // per area; of a point the probability; 0: none shines there
};

// A point of an emitter that a ray has found.
struct EmitterPoint {
  std::uint32_t geometry, primitive;
  Rgb radiance;            // at strength 1
  float distance, cosine;  // from the point that the ray has left; with the emitter's normal
};

// Several lamps are chosen by what they can give at a point, with a tree. Two triangles that make a flat quad
// are one lamp of it, and so is a disk. Places on triangles are uniform by area, and those on spheres by what
// a point sees. The probabilities do not depend on strengths, so that a seed finds the same points in every
// frame.
class Lamps {
 public:
  // Keeps a pointer to the textures, which are those of the scene's materials.
  Lamps(const Scene& scene, const std::vector<Texture>& textures);
  explicit Lamps(const Scene& scene) : Lamps(scene, scene.textures) {}

  bool has(LightSet set) const { return !byPower(set).empty(); }
  bool hasTree(LightSet set) const { return of(set).tree.has_value(); }

  // Of numbers in [0, 1): u_lamp chooses a lamp, u1 and u2 a place on it. There must be a lamp.
  ChosenLamp choose(LightSet set, const Receiver& at, float u_lamp) const;
  // As choose(), for the lanes of a set where there is a tree. `u` has their numbers.
  struct ChosenLanes {
    alignas(64) std::uint32_t number[kLaneVectors] = {};
    alignas(64) float pdf[kLaneVectors] = {};
  };
  ChosenLanes chooseFromTree(LightSet set, const LaneVectors& points, const LaneVectors& normals,
                             const float* u, LaneSet lanes) const;
  IncidentLight sample(const ChosenLamp& lamp, Vec3 point, float u1, float u2) const;

  // The pdf of both per solid angle, at a point of an emitter.
  float pdf(LightSet set, const EmitterPoint& point, const Receiver& at) const;

  // The first lamps by their numbers. Points and spots follow.
  const std::vector<AreaLamp>& areaLamps() const { return area_lamps_; }
  const std::vector<SpotLight>& spots() const { return spots_; }  // a point is a spot into all directions
  std::size_t count() const { return area_lamps_.size() + spots_.size(); }

  // Where there is a tree. A set has the first leaves.
  const std::vector<LampLeaf>& leaves() const { return leaves_; }
  const LampTree& tree(LightSet set) const { return *of(set).tree; }
  float probability(LightSet set, std::uint32_t leaf, const Receiver& at) const {
    return tree(set).probability(leaf, at);
  }
  // Lets the tree know what blocks the light of lamps.
  void look(LightSet set, LampSight sight) {
    sets_[static_cast<std::size_t>(set)].tree->look(std::move(sight));
  }

  // Chooses where there is no tree. The pdf per area is the radiance's luminance over the sum of weights.
  const LightChoice& byPower(LightSet set) const { return of(set).by_power; }

 private:
  struct Set {
    LightChoice by_power;
    std::optional<LampTree> tree;
  };

  const Set& of(LightSet set) const { return sets_[static_cast<std::size_t>(set)]; }
  void addLeaf(std::span<const AreaLamp> lamps);
  void addMesh(const Mesh& mesh, std::uint32_t geometry, const SurfaceColor& emission);
  void addPictures(const Mesh& mesh, std::size_t first, const SurfaceColor& emission,
                   std::span<AreaLamp> lamps);
  void addSets();
  LampBounds boundsOf(const LampLeaf& leaf) const;
  IncidentLight ofTriangle(const AreaLamp& lamp, float pdf, Vec3 point, float u1, float u2) const;
  IncidentLight ofSphere(const AreaLamp& lamp, float pdf, Vec3 point, float u1, float u2) const;

  const std::vector<Texture>* textures_;
  std::vector<AreaLamp> area_lamps_;
  std::vector<LampPicture> pictures_;
  std::vector<SpotLight> spots_;
  std::vector<LampLeaf> leaves_;
  std::vector<std::uint32_t> first_primitive_;    // by geometry, among those of all emitters
  std::vector<std::uint32_t> leaf_of_primitive_;  // of all emitters
  std::array<Set, kLightSets> sets_;
};

}  // namespace saccade
