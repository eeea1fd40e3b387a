// Ray queries on a scene. embree_scene.cpp is the only file that includes Embree.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "scene/scene.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace saccade {

struct Ray {
  Vec3 origin;
  Vec3 direction;  // any length; t counts in units of it
  float tfar;
};

struct Hit {
  float t;
  Vec3 normal;  // geometric, as wound, not normalised
  float u, v;   // barycentric, of vertices 1 and 2
  std::uint32_t geometry, primitive;
  bool valid = false;
};

// Geometry ids count the meshes in the order of Scene::meshes, then the spheres. Keeps pointers into the
// meshes of `scene`.
class EmbreeScene {
 public:
  // kEmitters: only those that emit; the ids stay.
  enum class Shapes { kAll, kEmitters };
  explicit EmbreeScene(const Scene& scene, Shapes shapes = Shapes::kAll);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  Hit intersect(const Ray& ray) const;
  bool occluded(const Ray& ray) const;          // anything in (0, tfar)
  float diagonal() const { return diagonal_; }  // of the bounding box
  std::size_t bytes() const { return bytes_; }  // that Embree has taken, besides the meshes

 private:
  std::atomic<std::size_t> bytes_ = 0;
  RTCDeviceTy* device_;
  RTCSceneTy* scene_;
  float diagonal_;
};

}  // namespace saccade
