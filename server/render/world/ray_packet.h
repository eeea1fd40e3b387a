// Rays that Embree traces together: W of them, in the layout of RTCRayHit8 and RTCRayHit16.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/wide.h"
#include "render/world/ray.h"

namespace saccade {

// Of shapes that let no light straight through, and of the others.
inline constexpr std::uint32_t kBlockingMask = 1, kStraightMask = 2;

template <int W>
struct alignas(64) RayPacket {
  using Floats = float[W];
  using Bits = std::uint32_t[W];

  // The rays see the shapes of these masks alone.
  explicit RayPacket(std::uint32_t shapes = kBlockingMask | kStraightMask) {
    std::fill_n(near, W, 0.f), std::fill_n(time, W, 0.f);
    std::fill_n(mask, W, shapes), std::fill_n(id, W, 0u), std::fill_n(flags, W, 0u);
  }

  Ray ray(int i) const { return {{origin_x[i], origin_y[i], origin_z[i]}, {x[i], y[i], z[i]}, far[i]}; }
  void set(int i, const Ray& ray) {
    origin_x[i] = ray.origin.x, origin_y[i] = ray.origin.y, origin_z[i] = ray.origin.z;
    x[i] = ray.direction.x, y[i] = ray.direction.y, z[i] = ray.direction.z, far[i] = ray.tfar;
  }
  Hit hit(int i) const {
    if (geometry[i] == kNone) return {};
    return {on(i), far[i], {normal_x[i], normal_y[i], normal_z[i]}, true};
  }

  ShapePoint on(int i) const { return {instance[i], geometry[i], primitive[i], u[i], v[i]}; }

  void clearHits() { std::fill_n(geometry, W, kNone), std::fill_n(instance, W, kNoBody); }

  static constexpr std::uint32_t kNone = ~0u;

  Floats origin_x, origin_y, origin_z, near, x, y, z, time, far;
  Bits mask, id, flags;
  Floats normal_x, normal_y, normal_z, u, v;  // of the hit
  Bits primitive, geometry, instance;         // instance: the body, or kNoBody
  Bits part_of_instance;                      // Embree 4.3 writes it
};

// Fills a packet with rays: the first six of their values are the origin and the direction.
template <int W, std::size_t kValues>
[[gnu::always_inline]] inline void setRays(const std::array<Floats<W>, kValues>& rays, const Floats<W>& far,
                                           RayPacket<W>& packet) {
  store(rays[0], packet.origin_x), store(rays[1], packet.origin_y), store(rays[2], packet.origin_z);
  store(rays[3], packet.x), store(rays[4], packet.y), store(rays[5], packet.z);
  store(far, packet.far);
}

}  // namespace saccade
