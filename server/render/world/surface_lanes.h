// Where on their shapes the rays of a packet have come to their end.
#pragma once

#include "base/lane_vectors.h"
#include "render/world/posed_scene.h"
#include "render/world/ray_offset.h"

namespace saccade {

// Valid where a lane has hit a surface.
template <int W>
struct SurfaceLanes {
  Vec3T<Floats<W>> point;
  Vec3T<Floats<W>> normal;          // geometric, unit, as wound
  Vec3T<Floats<W>> shading_normal;  // unit, on either side
  Floats<W> offset;                 // see ray_offset.h
  Floats<W> cosine;                 // between the normal and the ray's reverse

  Mask<W> front() const { return cosine > 0.f; }
};

// The corners' normals of each lane's triangle, as memory that lanes can be loaded from.
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

// Interpolated normals of the lanes whose shapes have some, unit; of other lanes the geometric normal.
template <int W>
[[gnu::always_inline]] inline Vec3T<Floats<W>> shadingNormals(const std::vector<ShapeRow>& rows,
                                                              const RayPacket<W>& packet, LaneSet lanes,
                                                              const Vec3T<Floats<W>>& geometric) {
  using F = Floats<W>;
  LaneSet smooth;
  forEachLane(lanes, [&](int i) {  // so that the triangles of all lanes come from memory at once
    const ShapeRow& row = rows[packet.geometry[i]];
    if (!row.normals) return;
    smooth.add(i);
    __builtin_prefetch(&row.triangles[packet.primitive[i]]);
  });
  if (!smooth.any()) return geometric;
  CornerLanes<W> normals;
  forEachLane(smooth, [&](int i) {
    const ShapeRow& row = rows[packet.geometry[i]];
    normals.set(i, row.normals, row.triangles[packet.primitive[i]]);
  });
  const F u = load<W>(packet.u), v = load<W>(packet.v);
  const Vec3T<F> between = normals.corner(0) * F(1.f - u - v) + normals.corner(1) * u + normals.corner(2) * v;
  const F length2 = dot(between, between);
  return selectLanes(length2 > 0.f, between * F(1.f / sqrt(length2)), geometric);
}

// Turns the normals of bodies from the scene file's place to that of the time.
template <int W>
void turnNormals(std::span<const RigidMotion> motions, const RayPacket<W>& packet, LaneSet lanes,
                 SurfaceLanes<W>& s) {
  forEachLane(lanes, [&](int i) {
    if (packet.instance[i] == kNoBody) return;
    const RigidMotion& motion = motions[packet.instance[i]];
    setLane(s.normal, i, motion.direction(laneOf(s.normal, i)));
    setLane(s.shading_normal, i, motion.direction(laneOf(s.shading_normal, i)));
  });
}

// ShapeRow::edge of the shapes that lanes have hit.
template <int W>
[[gnu::always_inline]] inline Floats<W> longestEdges(const std::vector<ShapeRow>& rows,
                                                     const RayPacket<W>& packet) {
  constexpr std::uint32_t kStride = sizeof(ShapeRow) / sizeof(float);
  if (rows.empty()) return 0.f;
  const Uints<W> last = static_cast<std::uint32_t>(rows.size() - 1);
  return gather(&rows[0].edge, Uints<W>(stdx::min(load<W>(packet.geometry), last) * kStride));
}

// `lanes`: those that have hit a surface.
template <int W>
[[gnu::always_inline]] inline SurfaceLanes<W> surfacesAt(const PosedScene& scene, const RayPacket<W>& packet,
                                                         LaneSet lanes) {
  using F = Floats<W>;
  const auto unit = [](const Vec3T<F>& a) { return a * F(1.f / sqrt(dot(a, a))); };
  const Vec3T<F> direction{load<W>(packet.x), load<W>(packet.y), load<W>(packet.z)};
  SurfaceLanes<W> s;
  s.normal = unit({load<W>(packet.normal_x), load<W>(packet.normal_y), load<W>(packet.normal_z)});
  s.shading_normal = shadingNormals<W>(scene.shapeRows(), packet, lanes, s.normal);
  if (scene.bodies()) turnNormals<W>(scene.bodies()->motions(), packet, lanes, s);
  s.cosine = -dot(s.normal, unit(direction));
  const Vec3T<F> origin{load<W>(packet.origin_x), load<W>(packet.origin_y), load<W>(packet.origin_z)};
  s.point = origin + direction * load<W>(packet.far);
  s.offset = rayOffset<F>(origin, s.point, longestEdges<W>(scene.shapeRows(), packet));
  return s;
}

}  // namespace saccade
