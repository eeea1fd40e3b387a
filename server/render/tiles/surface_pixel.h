// The samples of a tile's points, for frames with SurfaceSamples.
#pragma once

#include <utility>

#include "render/paths/path_sequence.h"
#include "render/surface/scatter.h"
#include "render/tiles/surface_points.h"
#include "render/tiles/touched_paths.h"

namespace saccade {

// The light that the paths of a point have found, and its components: sums of luminance.
struct ReflectedLight {
  double all = 0, unoccluded = 0, visible = 0, mis_weighted = 0;
  std::uint32_t paths = 0;
  BounceSample bounce;  // of the last path that has one
};

template <int C>
void addPath(const PathResults<C>& found, std::uint32_t slot, Rgb base, ReflectedLight& sum) {
  ++sum.paths;
  const Color<C> end = found.radiance.at(slot);
  Color<C> path = end;
  const bool continued = found.suffix_cell[slot] != 0;
  if (continued) path = found.before.at(slot), path += found.carried.at(slot) * end;
  const float unoccluded = (Color<C>(base) * found.unoccluded.at(slot)).luminance();
  if (!std::isfinite(path.luminance() + unoccluded)) return;
  sum.all += path.luminance();
  sum.unoccluded += unoccluded;
  sum.visible += (Color<C>(base) * found.visible.at(slot)).luminance();
  sum.mis_weighted += found.mis_weighted.at(slot).luminance();
  if (!continued) return;
  const Rgb light = end.rgb(), albedo = found.suffix_albedo[slot];
  sum.bounce = {found.suffix_cell[slot], {light.x / albedo.x, light.y / albedo.y, light.z / albedo.z}};
}

// Light without the direct light. Of a diffuse surface the path's own estimate of such light goes: what is
// left has the least noise. Of a plastic that estimate holds other light too.
inline double residualOf(const ReflectedLight& sum, DiffuseBase base) {
  return sum.all - (base.all ? sum.mis_weighted : sum.visible);
}
template <int C>
double residualOf(const PathResults<C>& found, std::uint32_t slot, DiffuseBase base) {
  ReflectedLight one;
  addPath(found, slot, base.albedo, one);
  return residualOf(one, base);
}

// The means over the paths of a point, over its albedo.
inline SurfaceLight lightOf(const ReflectedLight& sum, double paths, DiffuseBase base, float albedo) {
  return {static_cast<float>(sum.unoccluded / paths) / albedo,
          static_cast<float>(sum.visible / paths) / albedo,
          static_cast<float>(residualOf(sum, base) / paths) / albedo, sum.bounce};
}

// Paths that start at plain surfaces, kept until they fill all lanes.
template <class Run>
class PlainPaths {
 public:
  PlainPaths(float spread, Run& run) : spread_(spread), run_(run) {}
  void add(const PlainStart& start, const NewPath& path) {
    start.put(count_, surfaces_);
    paths_[count_++] = path;
    if (count_ == kLaneVectors) finish();
  }
  void finish() {
    run_.addPlain(surfaces_, LaneSet::first(count_), spread_, [this](int lane) { return paths_[lane]; });
    count_ = 0;
  }

 private:
  float spread_;  // of the cones
  Run& run_;
  int count_ = 0;
  PlainSurfaces surfaces_;
  std::array<NewPath, kLaneVectors> paths_;
};

// Whether any point of a tile gets some.
inline bool hasPaths(const SurfaceSamples& on, Tile tile) {
  for (int y = tile.y0; y < tile.y1; ++y)
    for (const SurfacePoint& p :
         on.row(y).subspan(tile.x0 * on.perPixel(), (tile.x1 - tile.x0) * on.perPixel()))
      if (p.paths > 0) return true;
  return false;
}

// Traces the paths of a tile's points for which wanted(i, path), of pass 2 alone, from moved(i, where they
// start). Calls add(i, results, slot, sum) for each of them. Then on_point(i, sum) for each point with any.
template <Shading S, int C, class Sum>
void tracePoints(const SeedPlan& seeds, const Tracing& tracing, Tile tile, const SurfaceStarts& starts,
                 const SurfaceSamples& on, const auto& wanted, const auto& moved, const auto& add,
                 const auto& on_point) {
  const Scratch<std::array<Sum, kMaxTilePoints>> sums;
  const Scratch<std::array<std::uint32_t, kMaxTilePoints>> points;  // those with paths
  std::uint32_t count = 0;
  const auto onPath = [&](std::uint32_t owner, const PathResults<C>& found, std::uint32_t slot) {
    add((*points)[owner], found, slot, (*sums)[owner]);
  };
  PathRun<S, C, true, decltype(onPath)> run(tracing, onPath);
  PlainPaths plain(tracing.known.pixel, run);
  const SequencePlace places(seeds.stream, seeds.frame2);
  forEachPixel(tile, [&](int x, int y) {
    for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
      const auto i = static_cast<std::uint32_t>(on.indexOf(column, y));
      if (on[i].share <= 0 || on[i].paths == 0) continue;
      const bool touched = tracing.moved && tracing.moved->touchAllFrom(starts.carrier(i));
      bool any = false;
      for (std::uint32_t path = 0; path < on[i].paths; ++path) {
        if (!wanted(i, path)) continue;
        if (!std::exchange(any, true)) (*sums)[count] = {}, (*points)[count] = i;
        const NewPath one{places.of(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(y), path),
                          count, touched};
        if (starts.isPlain(i))
          plain.add(moved(i, starts.plain(i)), one);
        else
          run.add(moved(i, starts.other(i)), one);
      }
      count += any;
    }
  });
  plain.finish();
  run.finish();
  for (std::uint32_t k = 0; k < count; ++k) on_point((*points)[k], (*sums)[k]);
}

// The light of a tile's points. `touched`: takes the paths that are, where Tracing asks for them.
template <Shading S, int C>
void renderPathTile(const SeedPlan& seeds, const Tracing& tracing, Tile tile, const SurfaceStarts& starts,
                    TouchedPaths& touched, Frame& out) {
  SurfaceSamples& on = *out.surfaces;
  forEachPixel(tile, [&](int x, int y) { out.samples.I2.at(x, y) = out.g.emission.at(x, y); });
  if (!on.needPaths() || !hasPaths(on, tile)) return;
  struct Same {
    const PlainStart& operator()(std::uint32_t, const PlainStart& start) const { return start; }
    const PathStart& operator()(std::uint32_t, const SurfaceStart& start) const { return start.path; }
  };
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  const auto add = [&](std::uint32_t i, const PathResults<C>& found, std::uint32_t slot,
                       ReflectedLight& sum) {
    const DiffuseBase base = starts.base(i);
    if (found.touched[slot]) touched.add(i, sum.paths, residualOf(found, slot, base));
    addPath(found, slot, base.albedo, sum);
  };
  tracePoints<S, C, ReflectedLight>(
      seeds, tracing, tile, starts, on, all, Same{}, add, [&](std::uint32_t i, const ReflectedLight& sum) {
        const int x = on.columnOf(i) / on.perPixel(), y = on.rowOf(i);
        const double paths = on[i].paths;
        const float albedo = starts.albedo(i);
        on.light(i) = lightOf(sum, paths, starts.base(i), albedo);
        const double whole = sum.all / paths / albedo;
        out.samples.I2.at(x, y) += static_cast<float>(whole * on[i].share * out.g.albedo.at(x, y));
      });
}

}  // namespace saccade
