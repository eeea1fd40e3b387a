// The samples of a tile's points, for frames with SurfaceSamples.
#pragma once

#include "render/scatter.h"
#include "render/surface_start.h"
#include "render/tile_samples.h"

namespace saccade {

inline constexpr int kMaxTilePoints = kMaxTileEdge * kMaxTileEdge * static_cast<int>(kSubPixels);

// What the paths of a point have found, and its parts: sums of luminance.
struct ReflectedParts {
  double all = 0, unoccluded = 0, visible = 0, weighed = 0;
  BounceSample bounce;  // of the last path that has one
};

template <int C>
void addPath(const PathResults<C>& found, std::uint32_t slot, Rgb base, ReflectedParts& sum) {
  const Color<C> end = found.radiance.at(slot);
  Color<C> path = end;
  const bool began_anew = found.tail_cell[slot] != 0;
  if (began_anew) path = found.before.at(slot), path += found.carried.at(slot) * end;
  const float unoccluded = (Color<C>(base) * found.unoccluded.at(slot)).luminance();
  if (!std::isfinite(path.luminance() + unoccluded)) return;
  sum.all += path.luminance();
  sum.unoccluded += unoccluded;
  sum.visible += (Color<C>(base) * found.visible.at(slot)).luminance();
  sum.weighed += found.weighed.at(slot).luminance();
  if (!began_anew) return;
  const Rgb light = end.rgb(), albedo = found.tail_albedo[slot];
  sum.bounce = {found.tail_cell[slot], {light.x / albedo.x, light.y / albedo.y, light.z / albedo.z}};
}

// Tells a point with paths its samples. Returns the light that leaves it, over its albedo.
inline double setSamples(const ReflectedParts& sum, const SurfaceStart& start, SurfacePoint& out) {
  const auto paths = static_cast<double>(out.paths);
  // Of a diffuse surface the path's own estimate of such light goes: what is left has the least noise. Of a
  // plastic that estimate holds other light too.
  const double direct = start.base.all ? sum.weighed : sum.visible;
  out.unoccluded_sample = static_cast<float>(sum.unoccluded / paths) / start.albedo;
  out.visible_sample = static_cast<float>(sum.visible / paths) / start.albedo;
  out.rest = static_cast<float>((sum.all - direct) / paths) / start.albedo;
  out.bounce = sum.bounce;
  return sum.all / paths / start.albedo;
}

inline void setNoSamples(SurfacePoint& out) {
  out.unoccluded_sample = out.visible_sample = out.rest = 0;
  out.bounce = {};
}

// The samples of a tile's points, of pass 2 alone.
template <Shading S, int C>
void renderPathTile(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile,
                    const std::vector<SurfaceStart>& starts, Frame& out) {
  SurfaceSamples& on = *out.surfaces;
  const Scratch<std::array<ReflectedParts, kMaxTilePoints>> sums;
  const Scratch<std::array<std::uint32_t, kMaxTilePoints>> points;  // by their place in the tile
  std::uint32_t count = 0;
  const auto onPath = [&](std::uint32_t owner, const PathResults<C>& found, std::uint32_t slot) {
    addPath(found, slot, starts[(*points)[owner]].base.albedo, (*sums)[owner]);
  };
  const Tracing tracing{
      view.scene, view.strengths, bounces, {on.bounces, view.camera.origin, view.camera.pixel}};
  PathRun<S, C, true, decltype(onPath)> run(tracing, onPath);
  const auto forEachPoint = [&](const auto& f) {
    forEachPixel(tile, [&](int x, int y) {
      for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column)
        if (on.at(column, y).share > 0) f(x, y, column);
    });
  };
  forEachPoint([&](int, int y, int column) {
    const auto i = static_cast<std::uint32_t>(on.indexOf(column, y));
    (*sums)[count] = {}, (*points)[count] = i;
    for (std::uint32_t path = 0; path < on[i].paths; ++path)
      run.add(starts[i].path, PathSampler(seeds.seed2, i, path), count);
    ++count;
  });
  run.finish();
  forEachPixel(tile, [&](int x, int y) { out.samples.I2.at(x, y) = out.g.emission.at(x, y); });
  count = 0;
  forEachPoint([&](int x, int y, int column) {
    SurfacePoint& p = on.at(column, y);
    const ReflectedParts& sum = (*sums)[count++];
    if (p.paths == 0) return setNoSamples(p);
    const double light = setSamples(sum, starts[on.indexOf(column, y)], p);
    out.samples.I2.at(x, y) += static_cast<float>(light * p.share * out.g.albedo.at(x, y));
  });
}

}  // namespace saccade
