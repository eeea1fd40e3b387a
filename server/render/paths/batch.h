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

// Marks the paths in these lanes. `slots`: theirs, by lane.
template <int W, int C>
[[gnu::always_inline]] inline void markTouched(const Batch<C>& b, LaneSet lanes, const Uints<W>& slots) {
  forEachLane(lanes, [&](int i) { b.results.touched[slots[i]] = true; });
}
// The lanes whose paths are not marked yet.
template <int W, int C>
[[gnu::always_inline]] inline LaneSet notTouched(const Batch<C>& b, LaneSet lanes, const Uints<W>& slots) {
  forEachLane(lanes, [&](int i) {
    if (b.results.touched[slots[i]]) lanes.remove(i);
  });
  return lanes;
}

// The random numbers of W paths at their vertex, by their places in a group of dimensions. Paths with a
// SequencePlace have independent ones beyond their first vertex.
template <int W, bool kSplit, int C>
[[gnu::always_inline]] inline auto numbersAt(const Batch<C>& b, const PathNumbers<W>& of, Dimension first) {
  const PathNumbers<W> beyond{kSplit ? mix32(of.reversed_index) : of.reversed_index, of.key};
  return [&b, of, first, point = beyond.point(b.dimension(first))](std::uint32_t k) {
    if (kSplit && b.vertex == 0) return sequenceNumbers<W>(of, static_cast<Dimension>(first + k));
    return PathNumbers<W>::unit(point.at(k));
  };
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
