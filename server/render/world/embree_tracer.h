// Rays in one of Embree's scenes. The files embree_*.cpp and their embree_query.h are the only ones that
// include Embree.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>

#include "render/world/ray_packet.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace saccade {

// Counts of packets, for measurements.
struct PacketCounts {
  std::uint64_t rays = 0, lanes = 0;  // asked for, and those that the packets had
  std::chrono::nanoseconds time{0};   // inside Embree
};

// Owns what Embree allocates for some scenes. It builds them in the calling thread.
class EmbreeDevice {
 public:
  EmbreeDevice();
  ~EmbreeDevice();
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;

  RTCDeviceTy* get() const { return device_; }
  std::size_t bytes() const { return bytes_; }  // that Embree has taken, besides meshes

 private:
  std::atomic<std::size_t> bytes_ = 0;
  RTCDeviceTy* device_;
};

class EmbreeTracer {
 public:
  EmbreeTracer(const EmbreeTracer&) = delete;
  EmbreeTracer& operator=(const EmbreeTracer&) = delete;

  // `hit`: what is already known of the ray, whose tfar ends there; a nearer one takes its place.
  void intersect(const Ray& ray, Hit& hit) const;
  Hit intersect(const Ray& ray) const {
    Hit hit{};
    intersect(ray, hit);
    return hit;
  }
  bool occluded(const Ray& ray) const;  // anything in (0, tfar)

  // The same for those rays of a packet whose bits are set, W = 8 or 16. Rays that lie close together are
  // `coherent`: a hint that makes them faster, and others slower. In the packet, intersect() sets the members
  // that follow `flags`, and `far`. Where anything is in the way, occluded() makes `far` negative.
  enum class Rays { kScattered, kCoherent };
  template <int W>
  void intersect(RayPacket<W>& packet, LaneSet lanes, Rays rays) const {
    packet.clearHits();
    intersectFurther(packet, lanes, rays);
  }
  // Keeps hits that the packet has, where none is nearer.
  template <int W>
  void intersectFurther(RayPacket<W>& packet, LaneSet lanes, Rays rays) const;
  template <int W>
  void occluded(RayPacket<W>& packet, LaneSet lanes) const;

  // From now on the packets of this scene are counted; nullptr ends that. For one thread that traces.
  void count(PacketCounts* counts) const { counts_ = counts; }

 protected:
  explicit EmbreeTracer(std::shared_ptr<EmbreeDevice> device);
  ~EmbreeTracer();

  const std::shared_ptr<EmbreeDevice> device_;
  RTCSceneTy* const scene_;

 private:
  template <int W>
  void trace(LaneSet lanes, const auto& call) const;

  mutable std::atomic<PacketCounts*> counts_ = nullptr;
};

}  // namespace saccade
