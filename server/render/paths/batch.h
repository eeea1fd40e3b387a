// A batch of paths under way, as the stages see it.
#pragma once

#include "base/lane_vectors.h"
#include "render/paths/path_sequence.h"
#include "render/paths/surface_stages.h"
#include "render/surface/color_lanes.h"

namespace saccade {

template <int C>
struct Batch {
  const Tracing& t;
  const SurfaceStages<C>& stages;
  PathResults<C>& results;
  LivePaths<C>* now;   // at their vertex
  LivePaths<C>* next;  // at the vertex after it
  int vertex = 0;

  LightSet lightSet() const { return t.lightsOf(vertex == 0); }  // of which the vertex takes samples
  std::uint32_t dimension(Dimension d) const { return static_cast<std::uint32_t>(vertex) * kDimensions + d; }
};

// The random numbers of W paths at their vertex.
template <int W, bool kSplit, int C>
[[gnu::always_inline]] inline Floats<W> numbersAt(const Batch<C>& b, const PathNumbers<W>& of, int d) {
  const auto dimension = static_cast<Dimension>(d);
  if (kSplit && b.vertex == 0) return sequenceNumbers<W>(of, dimension);
  return of.u(b.dimension(dimension));
}

template <int W, int C>
[[gnu::always_inline]] inline std::array<Floats<W>, C> colorLanes(const ColorPlanes<C>& planes, int first) {
  std::array<Floats<W>, C> c;
  for (int k = 0; k < C; ++k) c[k] = load<W>(&planes.of[k][first]);
  return c;
}

// The lanes among `lanes` whose surfaces are shaded like that, of the paths from `first` on.
template <int W, int C>
[[gnu::always_inline]] inline LaneSet lanesShadedAs(ShadedAs kind, const LivePaths<C>& paths, int first,
                                                    LaneSet lanes) {
  const Uints<W> of = load<W>(&paths.state[first]) & PathState::kSurface;
  return lanes & lanesOf(toFloats(of) == static_cast<float>(kind));
}

}  // namespace saccade
