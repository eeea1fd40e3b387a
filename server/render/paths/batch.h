// A batch of paths under way, as the stages see it.
#pragma once

#include "render/paths/path_sequence.h"
#include "render/paths/surface_stages.h"

namespace saccade {

// kMixed: surfaces are not all diffuse, or let light through. kParts: light is told in parts.
template <int C>
struct Batch {
  const Tracing& t;
  const SurfaceStages<C>& stages;
  PathResults<C>& results;
  LivePaths<C>* now;   // at their vertex
  LivePaths<C>* next;  // at the vertex after it
  int vertex = 0;

  std::uint32_t dimension(Dimension d) const { return static_cast<std::uint32_t>(vertex) * kDimensions + d; }
};

// The random numbers of W paths at their vertex.
template <int W, bool kParts, int C>
[[gnu::always_inline]] inline Floats<W> numbersAt(const Batch<C>& b, const PathNumbers<W>& of, int d) {
  const auto dimension = static_cast<Dimension>(d);
  if (kParts && b.vertex == 0) return sequenceNumbers<W>(of, dimension);
  return of.u(b.dimension(dimension));
}

template <int W, int C>
[[gnu::always_inline]] inline std::array<Floats<W>, C> colorLanes(const ColorPlanes<C>& planes, int first) {
  std::array<Floats<W>, C> c;
  for (int k = 0; k < C; ++k) c[k] = load<W>(&planes.of[k][first]);
  return c;
}

template <class F, std::size_t C>
[[gnu::always_inline]] inline F luminanceOf(const std::array<F, C>& c) {
  if constexpr (C == 1) return c[0];
  if constexpr (C == 3) return luminance(Vec3T<F>{c[0], c[1], c[2]});
}

template <class F>
[[gnu::always_inline]] inline void setLane(std::array<F, 1>& lanes, int lane, Color<1> c) {
  lanes[0][lane] = c.y;
}
template <class F>
[[gnu::always_inline]] inline void setLane(std::array<F, 3>& lanes, int lane, Color<3> c) {
  lanes[0][lane] = c.c.x, lanes[1][lane] = c.c.y, lanes[2][lane] = c.c.z;
}
template <class F>
[[gnu::always_inline]] inline Color<1> colorOf(const std::array<F, 1>& lanes, int lane) {
  return Color<1>(lanes[0][lane]);
}
template <class F>
[[gnu::always_inline]] inline Color<3> colorOf(const std::array<F, 3>& lanes, int lane) {
  return Color<3>(Rgb{lanes[0][lane], lanes[1][lane], lanes[2][lane]});
}
template <class F>
[[gnu::always_inline]] inline void setLane(Vec3T<F>& lanes, int lane, Vec3 v) {
  lanes.x[lane] = v.x, lanes.y[lane] = v.y, lanes.z[lane] = v.z;
}
template <class F>
[[gnu::always_inline]] inline Vec3 laneOf(const Vec3T<F>& lanes, int lane) {
  return {lanes.x[lane], lanes.y[lane], lanes.z[lane]};
}

// The lanes among `lanes` whose surfaces are shaded like that, of the paths from `first` on.
template <int W, int C>
[[gnu::always_inline]] inline std::uint32_t lanesShadedAs(ShadedAs kind, const LivePaths<C>& paths, int first,
                                                          std::uint32_t lanes) {
  const Uints<W> of = load<W>(&paths.state[first]) & PathState::kSurface;
  return lanes & bitsOf(toFloats(of) == static_cast<float>(kind));
}

// Fills a packet with rays: the first six of their values are the origin and the direction.
template <int W, std::size_t kValues>
[[gnu::always_inline]] inline void setRays(const std::array<Floats<W>, kValues>& rays, const Floats<W>& far,
                                           RayPacket<W>& packet) {
  store(rays[0], packet.origin_x), store(rays[1], packet.origin_y), store(rays[2], packet.origin_z);
  store(rays[3], packet.x), store(rays[4], packet.y), store(rays[5], packet.z);
  store(far, packet.far);
}

}  // namespace saccade
