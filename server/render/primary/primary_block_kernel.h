// Traces a block of pixels, compiled for one width of lanes.
#pragma once

#include <bit>
#include <cstring>
#include <limits>

#include "render/camera/pixel_features.h"
#include "render/primary/primary_block.h"
#include "render/world/surface_at.h"
#include "render/world/surface_lanes.h"
#include "render/world/texture_color.h"

namespace saccade::detail {

// Lanes `first` and those after it of a block are pixels of the picture.
template <int W>
struct BlockPart {
  Tile pixels;
  int first;

  [[gnu::always_inline]] LaneSet inside() const {
    LaneSet lanes;
    const std::uint32_t row = LaneSet::first(pixels.x1 - pixels.x0).bits;
    for (int y = 0; y < W / kBlockEdge; ++y)
      if (pixels.y0 + first / kBlockEdge + y < pixels.y1) lanes.bits |= row << (y * kBlockEdge);
    return lanes;
  }
  [[gnu::always_inline]] Vec3T<Floats<W>> directions(const Camera& camera) const {
    const Floats<W> x([](auto lane) { return static_cast<float>(lane % kBlockEdge); });
    const Floats<W> y([](auto lane) { return static_cast<float>(lane / kBlockEdge); });
    return camera.plainDirection(Floats<W>(x + static_cast<float>(pixels.x0)),
                                 Floats<W>(y + static_cast<float>(pixels.y0 + first / kBlockEdge)));
  }
  [[gnu::always_inline]] void write(const Floats<W>& values, ImageF& plane) const {
    alignas(64) float lanes[W];
    store(values, lanes);
    for (int row = 0; row < W / kBlockEdge; ++row) {
      const int y = pixels.y0 + first / kBlockEdge + row;
      if (y >= pixels.y1) return;
      float* to = plane.row(y) + pixels.x0;
      if (pixels.x1 - pixels.x0 == kBlockEdge)
        std::memcpy(to, lanes + row * kBlockEdge, kBlockEdge * sizeof(float));
      else
        std::memcpy(to, lanes + row * kBlockEdge, (pixels.x1 - pixels.x0) * sizeof(float));
    }
  }
};

// A surface that a plain lane shows, besides what SurfaceLanes tells.
template <int W>
struct PlainLanes {
  Vec3T<Floats<W>> geometric_normal, shading_normal, reflectance, emission;
};

template <int W>
[[gnu::always_inline]] inline PlainLanes<W> plainLanes(const PosedScene& scene, const RayPacket<W>& packet,
                                                       LaneSet plain, const SurfaceLanes<W>& s,
                                                       const Floats<W>& width) {
  PlainLanes<W> lanes;
  lanes.geometric_normal = selectLanes(s.front(), s.normal, -s.normal);
  lanes.shading_normal =
      selectLanes(dot(s.shading_normal, lanes.geometric_normal) < 0.f, -s.shading_normal, s.shading_normal);
  const LaneSet front = lanesOf(s.front());
  LaneVectors reflectance{}, emission{};
  forEachLane(plain, [&](int i) {
    const std::uint32_t geometry = packet.geometry[i];
    const ShapeRow& row = scene.still().shapeRows()[geometry];
    const bool seen_front = front.has(i);
    if (row.emits && seen_front)
      emission.set(i, HitShape(scene, packet.hit(i)).radiance() * scene.strengths()[geometry]);
    if (!row.twosided && !seen_front) return;
    reflectance.set(
        i, row.textured ? textureColor(scene, packet.hit(i), s.cosine[i], width[i]) : row.reflectance);
  });
  lanes.reflectance = reflectance.template lanes<W>(0), lanes.emission = emission.template lanes<W>(0);
  return lanes;
}

// The lanes that have hit a plain surface.
template <int W>
[[gnu::always_inline]] inline LaneSet plainHits(const PosedScene& scene, const RayPacket<W>& packet,
                                                LaneSet lanes) {
  LaneSet plain;
  forEachLane(lanes, [&](int i) {
    const std::uint32_t geometry = packet.geometry[i];
    plain.add(i, geometry != RayPacket<W>::kNone && scene.still().shapeRows()[geometry].plain);
  });
  return plain;
}

template <int W>
[[gnu::always_inline]] inline void storeLanes(const SurfaceLanes<W>& s, const PlainLanes<W>& surface,
                                              const Floats<W>& albedo, const Floats<W>& width, int first,
                                              PlainSurfaces& out) {
  out.point.store(s.point, first), store(s.offset, &out.offset[first]);
  out.geometric_normal.store(surface.geometric_normal, first);
  out.shading_normal.store(surface.shading_normal, first);
  out.reflectance.store(surface.reflectance, first), out.emission.store(surface.emission, first);
  store(albedo, &out.albedo[first]), store(width, &out.width[first]);
}

template <int W>
[[gnu::always_inline]] inline void writeFeatures(const PixelContext& view, const BlockPart<W>& part,
                                                 const Vec3T<Floats<W>>& direction, const Floats<W>& z,
                                                 const Vec3T<Floats<W>>& point,
                                                 const Vec3T<Floats<W>>& point_before,
                                                 const PlainLanes<W>& surface, const Floats<W>& albedo,
                                                 GBuffer& g) {
  using F = Floats<W>;
  const Vec3T<F> offset = point - splat<F>(view.now.camera.origin);
  const auto now = view.now.camera.projectPlain(offset);
  const auto before =
      view.before.camera.projectPlain(Vec3T<F>(point_before - splat<F>(view.before.camera.origin)));
  const auto motion = motionBetween<F>(now, before);
  part.write(motion.x, g.motion_x), part.write(motion.y, g.motion_y);
  part.write(before.z, g.z_in_prev);
  part.write(z, g.z);
  const Vec3T<F> right = view.now.camera.nextRightPlain(direction),
                 down = view.now.camera.nextDownPlain(direction);
  part.write(planeSlope<F>(right, down, offset, surface.geometric_normal, z), g.dz);
  part.write(surface.shading_normal.x, g.nx);
  part.write(surface.shading_normal.y, g.ny);
  part.write(surface.shading_normal.z, g.nz);
  part.write(albedo, g.albedo);
  part.write(luminance<F>(surface.emission), g.emission);
}

template <int W>
[[gnu::always_inline]] inline void shadePlain(const PixelContext& view, const BlockPart<W>& part,
                                              const Vec3T<Floats<W>>& direction, const RayPacket<W>& packet,
                                              LaneSet plain, GBuffer& g, PlainSurfaces& out) {
  using F = Floats<W>;
  const SurfaceLanes<W> s = surfacesAt<W>(view.now.scene, packet, plain);
  const F z = load<W>(packet.far), width = view.now.camera.pixel * z;
  const PlainLanes<W> surface = plainLanes<W>(view.now.scene, packet, plain, s, width);
  const F albedo = luminance<F>(surface.reflectance);
  Vec3T<F> before = s.point;
  if (view.now.scene.bodies())
    forEachLane(plain, [&](int i) {
      setLane(before, i, view.pointBefore(packet.on(i), laneOf(s.point, i)));
      const int lane = part.first + i;
      g.body.at(part.pixels.x0 + lane % kBlockEdge, part.pixels.y0 + lane / kBlockEdge) =
          packet.instance[i] + 1;
    });
  writeFeatures<W>(view, part, direction, z, s.point, before, surface, albedo, g);
  storeLanes<W>(s, surface, albedo, width, part.first, out);
}

template <int W>
void tracePrimaryBlock(const PixelContext& view, Tile pixels, GBuffer& g, PrimaryBlock& out) {
  using F = Floats<W>;
  out.plain = out.others = {};
  for (int first = 0; first < kBlockPixels; first += W) {
    const BlockPart<W> part{pixels, first};
    const LaneSet inside = part.inside();
    const Vec3T<F> direction = part.directions(view.now.camera), origin = splat<F>(view.now.camera.origin);
    RayPacket<W> packet;
    setRays<W>(std::array{origin.x, origin.y, origin.z, direction.x, direction.y, direction.z},
               F(std::numeric_limits<float>::infinity()), packet);
    view.now.scene.geometry().template intersect<W>(packet, inside, EmbreeTracer::Rays::kCoherent);
    const LaneSet plain = plainHits<W>(view.now.scene, packet, inside);
    const LaneSet others = inside - plain;
    forEachLane(others, [&](int i) {
      out.rays[static_cast<std::size_t>(first + i)] = packet.ray(i);
      out.hits[static_cast<std::size_t>(first + i)] = packet.hit(i);
    });
    out.plain.bits |= plain.bits << first, out.others.bits |= others.bits << first;
    if (!plain.any()) continue;
    shadePlain<W>(view, part, direction, packet, plain, g, out.surfaces);
    if (view.now.scene.deformed())
      forEachLane(plain, [&](int i) { out.on[static_cast<std::size_t>(first + i)] = packet.on(i); });
  }
}

}  // namespace saccade::detail
