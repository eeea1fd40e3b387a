// Shades the hits of a packet: adds the light that is found there, and moves paths that go on to the next
// vertex.
#pragma once

#include "render/paths/batch.h"
#include "render/paths/found_light.h"
#include "render/paths/trace_batch.h"
#include "render/world/surface_at.h"
#include "render/world/surface_lanes.h"
#include "render/world/texture_color.h"

namespace saccade {

// Paths that miss, and those at surfaces of other kinds.
template <int W, int C>
void shadeHitsOneByOne(const Batch<C>& b, const RayPacket<W>& packet, LaneSet lanes, const SurfaceLanes<W>& s,
                       const Uints<W>& path) {
  forEachLane(lanes, [&](int i) {
    b.stages.shadeHit(b.t, b.vertex, *b.now, path[i],
                      {packet.ray(i).direction,
                       packet.hit(i),
                       {laneOf(s.point, i), laneOf(s.shading_normal, i), s.offset[i]},
                       laneOf(s.normal, i),
                       s.cosine[i]},
                      *b.next, b.results);
  });
}

// Of a path that has met diffuse surfaces alone, and has left this vertex.
inline PathState diffuseState(int vertex) {
  return {vertex + 1, false, false, vertex == 0, false, ShadedAs::kDiffuse};
}

// Of diffuse surfaces: reflectances, at the hits of `lanes`.
template <int W, int C>
std::array<Floats<W>, C> reflectances(const Batch<C>& b, const RayPacket<W>& packet, const SurfaceLanes<W>& s,
                                      const Floats<W>& footprint, LaneSet lanes) {
  std::array<Floats<W>, C> reflectance{};
  const LaneSet front = lanesOf(s.front());
  forEachLane(lanes, [&](int i) {
    const ShapeRow& row = b.t.scene.still().shapeRows()[packet.geometry[i]];
    if (!row.twosided && !front.has(i)) return;
    setLane(reflectance, i,
            Color<C>(row.textured ? textureColor(b.t.scene, packet.hit(i), s.cosine[i], footprint[i])
                                  : row.reflectance));
  });
  return reflectance;
}

// Paths at surfaces that are diffuse and opaque.
template <int W, PathKind K>
void shadeHitsTogether(const Batch<K.channels>& b, const RayPacket<W>& packet, LaneSet hits,
                       const SurfaceLanes<W>& s, const Uints<W>& path) {
  constexpr int C = K.channels;
  using F = Floats<W>;
  const LivePaths<C>& from = *b.now;
  LivePaths<C>& to = *b.next;
  const LaneSet front = lanesOf(s.front());
  forEachLane(hits & front, [&](int i) {
    const std::uint32_t geometry = packet.geometry[i], p = path[i];
    if (!b.t.scene.still().shapeRows()[geometry].emits) return;
    const PathState state = K.mixed ? PathState::unpack(from.state[p]) : diffuseState(b.vertex);
    if (state.in_view) return;
    const float distance = packet.far[i] + (K.mixed ? from.distance[p] : 0);
    const Found found{
        from.slot[p],
        {geometry, packet.primitive[i], HitShape(b.t.scene, packet.hit(i)).radiance(), distance, s.cosine[i]},
        chooserOf<K.mixed>(from, p, laneOf(s.point, i), packet.ray(i).direction, distance)};
    addFound<C, K.split>(b.t, found, from.throughput.at(p), state.delta ? kDeltaPdf : from.pdf[p],
                         state.from_start, b.results);
  });
  Uints<W> state = 0;
  if constexpr (K.mixed) {
    state = (gather(&from.state[0], path) & ~PathState::kSurface) | std::uint32_t(ShadedAs::kDiffuse);
    if (!b.t.scene.still().hasStraightTransmission())
      hits &= lanesOf(toFloats(Uints<W>(state >> 8)) <= static_cast<float>(b.t.bounces));
    if (b.vertex >= b.t.bounces + kMaxDeltas) return;
  } else if (b.vertex >= b.t.bounces) {
    return;
  }
  const F spread = gather(&from.spread[0], path);
  const F width = gather(&from.width[0], path) + spread * load<W>(packet.far);
  const auto reflectance = reflectances<W, C>(b, packet, s, width, hits);
  const Vec3T<F> ng = selectLanes(s.front(), s.normal, -s.normal);
  const Vec3T<F> ns = selectLanes(dot(s.shading_normal, ng) < 0.f, -s.shading_normal, s.shading_normal);
  std::array<F, C> throughput;
  for (int k = 0; k < C; ++k) throughput[k] = gather(&from.throughput.of[k][0], path);
  LaneSet going = hits;
  if constexpr (K.split)
    if (b.vertex == 0)
      forEachLane(K.mixed ? hits & lanesOf(toFloats(Uints<W>(state & PathState::kDeltaLast)) == 0.f) : hits,
                  [&](int i) {
                    Color<C> carried = colorOf(throughput, i);
                    const PathSampler sampler(from.reversed_index[path[i]], from.path_key[path[i]]);
                    if (endsAtKnownLight<C>(
                            b.t, {laneOf(s.point, i), laneOf(ng, i), colorOf(reflectance, i).rgb(), width[i]},
                            sampler, from.slot[path[i]], carried, b.results))
                      going.remove(i);
                    setLane(throughput, i, carried);
                  });
  const auto at = static_cast<std::size_t>(to.count);
  const auto keep = [&](const auto& lanes, auto& plane) { compress(going, lanes, &plane[at]); };
  const auto keepVector = [&](const Vec3T<F>& lanes, VectorPlanes& planes) {
    keep(lanes.x, planes.x), keep(lanes.y, planes.y), keep(lanes.z, planes.z);
  };
  keepVector(s.point + ng * s.offset, to.origin), keepVector(ng, to.geometric_normal),
      keepVector(ns, to.shading_normal);
  for (int k = 0; k < C; ++k) {
    keep(reflectance[k], to.reflectance.of[k]);
    keep(throughput[k], to.throughput.of[k]);
  }
  keep(width, to.width), keep(spread, to.spread);
  keep(gather(&from.reversed_index[0], path), to.reversed_index),
      keep(gather(&from.path_key[0], path), to.path_key);
  keep(gather(&from.slot[0], path), to.slot);
  if constexpr (K.mixed) {
    keep(state, to.state), keep(gather(&from.pdf[0], path), to.pdf);
    keep(gather(&from.distance[0], path) + load<W>(packet.far), to.distance);
  }
  to.count += going.size();
}

// `path`: the places of the packet's first `count` paths among those at their vertex.
template <int W, PathKind K>
[[gnu::always_inline]] inline void shadeHits(const Batch<K.channels>& b, const RayPacket<W>& packet,
                                             int count, const Uints<W>& path) {
  constexpr int C = K.channels;
  LaneSet hits, plain;
  for (int i = 0; i < count; ++i) {
    if (packet.geometry[i] == RayPacket<W>::kNone) continue;
    hits.add(i);
    plain.add(i, !K.mixed || b.t.scene.still().shapeRows()[packet.geometry[i]].plain);
  }
  const SurfaceLanes<W> s = surfacesAt<W>(b.t.scene, packet, hits);
  if (plain.any()) shadeHitsTogether<W, K>(b, packet, plain, s, path);
  if constexpr (K.mixed) shadeHitsOneByOne<W, C>(b, packet, LaneSet::first(count) - plain, s, path);
}

}  // namespace saccade
