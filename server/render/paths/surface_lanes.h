// Where on their shapes the rays of a packet have come to their end.
#pragma once

#include "render/patch.h"
#include "render/paths/batch.h"

namespace saccade {

// Valid where a lane has hit a surface.
template <int W>
struct SurfaceLanes {
  Vec3T<Floats<W>> point;
  Vec3T<Floats<W>> normal;          // geometric, unit, as wound
  Vec3T<Floats<W>> shading_normal;  // unit, on either side
  Floats<W> cosine;                 // between the normal and the ray's reverse

  Mask<W> front() const { return cosine > 0.f; }
};

// The corners' vectors of each lane's triangle, as memory that lanes can be loaded from.
template <int W>
struct alignas(64) CornerLanes {
  float x[3][W] = {}, y[3][W] = {}, z[3][W] = {};

  void set(int lane, const Vec3* of, const std::array<std::uint32_t, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 v = of[corners[k]];
      x[k][lane] = v.x, y[k][lane] = v.y, z[k][lane] = v.z;
    }
  }
  [[gnu::always_inline]] Vec3T<Floats<W>> corner(int k) const {
    return {load<W>(x[k]), load<W>(y[k]), load<W>(z[k])};
  }
};

// The packet's rays have unit directions. `lanes`: those that have hit a surface.
template <int W>
[[gnu::always_inline]] inline SurfaceLanes<W> surfacesAt(const RenderScene& scene, const RayPacket<W>& packet,
                                                         std::uint32_t lanes) {
  using F = Floats<W>;
  const std::vector<ShapeRow>& rows = scene.shapeRows();
  CornerLanes<W> positions, normals;
  forEachLane(lanes, [&](int i) {  // so that the triangles of all lanes come from memory at once
    const ShapeRow& row = rows[packet.geometry[i]];
    if (row.triangles) __builtin_prefetch(&row.triangles[packet.primitive[i]]);
  });
  std::uint32_t spheres = 0;
  forEachLane(lanes, [&](int i) {
    const ShapeRow& row = rows[packet.geometry[i]];
    if (!row.triangles) {
      spheres |= 1u << i;
      return;
    }
    const auto& corners = row.triangles[packet.primitive[i]];
    positions.set(i, row.positions, corners);
    if (row.normals) normals.set(i, row.normals, corners);
  });
  const F u = load<W>(packet.u), v = load<W>(packet.v);
  const auto between = [&](const CornerLanes<W>& c) {
    return c.corner(0) * F(1.f - u - v) + c.corner(1) * u + c.corner(2) * v;
  };
  const auto unit = [](const Vec3T<F>& a) { return a * F(1.f / sqrt(dot(a, a))); };
  SurfaceLanes<W> s;
  s.normal = unit({load<W>(packet.normal_x), load<W>(packet.normal_y), load<W>(packet.normal_z)});
  s.cosine = -dot(s.normal, {load<W>(packet.x), load<W>(packet.y), load<W>(packet.z)});
  s.point = between(positions);
  const Vec3T<F> smooth = between(normals);
  s.shading_normal = selectLanes(dot(smooth, smooth) > 0.f, unit(smooth), s.normal);
  forEachLane(spheres, [&](int i) {
    const auto [mesh, sphere] = HitShape(scene.description(), packet.hit(i));
    const Patch patch = patchAt(*sphere, laneOf(s.normal, i));
    setLane(s.point, i, patch.point), setLane(s.shading_normal, i, patch.shading_normal);
  });
  return s;
}

}  // namespace saccade
