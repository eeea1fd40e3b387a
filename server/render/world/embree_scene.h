// Queries on a scene. embree_scene.cpp, embree_distance.cpp and their embree_query.h are the only files that
// include Embree.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <span>

#include "render/world/ray_packet.h"
#include "scene/scene.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace saccade {

// Counts of packets, for measurements.
struct PacketCounts {
  std::uint64_t rays = 0, lanes = 0;  // asked for, and those that the packets had
  std::chrono::nanoseconds time{0};   // inside Embree
};

// Geometry ids count the meshes in the order of Scene::meshes, then the spheres. Keeps pointers into the
// shapes of `scene`.
class EmbreeScene {
 public:
  // kEmitters: only those that emit. kStraight: only those that let some light straight through. The ids
  // stay.
  enum class Shapes { kAll, kEmitters, kStraight };
  explicit EmbreeScene(const Scene& scene, Shapes shapes = Shapes::kAll);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  Hit intersect(const Ray& ray) const;
  bool occluded(const Ray& ray) const;  // anything in (0, tfar)

  // The same for those rays of a packet whose bits are set, W = 8 or 16. Rays that lie close together are
  // `coherent`: a hint that makes them faster, and others slower. In the packet, intersect() sets the members
  // that follow `flags`, and `far`. Where anything is in the way, occluded() makes `far` negative.
  enum class Rays { kScattered, kCoherent };
  template <int W>
  void intersect(RayPacket<W>& packet, LaneSet lanes, Rays rays) const;
  template <int W>
  void occluded(RayPacket<W>& packet, LaneSet lanes) const;
  // Of rays that lie close together, as many as there are hits.
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const;

  // From a point to the nearest surface, or `reach` where none is nearer than that.
  double distance(Vec3d point, double reach) const;

  // From now on the packets of this scene are counted; nullptr ends that. For one thread that traces.
  void count(PacketCounts* counts) const { counts_ = counts; }

  float diagonal() const { return diagonal_; }  // of the bounding box
  std::size_t bytes() const { return bytes_; }  // that Embree has taken, besides the meshes

 private:
  template <int W>
  void trace(LaneSet lanes, const auto& call) const;

  const Scene& shapes_;
  std::atomic<std::size_t> bytes_ = 0;
  mutable std::atomic<PacketCounts*> counts_ = nullptr;
  RTCDeviceTy* device_;
  RTCSceneTy* scene_;
  float diagonal_;
};

}  // namespace saccade
