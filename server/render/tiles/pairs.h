// Pairs of paths for pixels that show in both frames what shares no light, see PairSamples.
#pragma once

#include <algorithm>
#include <vector>

#include "render/tiles/pair_plan.h"
#include "render/tiles/surface_pixel.h"

namespace saccade {

// One frame of a pair, as its paths see it. All paths end at the same known light.
struct PairSide {
  const Frame& frame;  // with SurfaceSamples
  const SurfaceStarts& starts;
  Tracing tracing;
};

// Both frames, and the numbers of this one.
struct PairSides {
  PairSide now, before;
  SequencePlace places;
};

// Which numbers of a pixel are traced: paths `first` to `first + count - 1`.
struct PairNumbers {
  std::uint32_t first = 0, count = 0;
};

// Which light of a pixel's points pairs are of: all of it.
struct AllOfPoint {
  static bool isAt(const SurfacePoint& p) { return p.share > 0; }
  static const PathStart& pathOf(const SurfaceStart& start) { return start.path; }
};
// That of the coats of plastics.
struct CoatOfPoint {
  static bool isAt(const SurfacePoint& p) { return p.has_coat; }
  static PathStart pathOf(const SurfaceStart& start) { return start.coatPath(); }
};

// Traces the numbers(x, y) of a tile's pixels in one frame. Calls on_light(x, y, path, light): light is the
// part of what the pixel reflects that one of its points contributes.
template <Shading S, int C, class Part>
void tracePairSide(const PairSide& side, const SequencePlace& places, Tile tile, const auto& numbers,
                   const auto& on_light) {
  const SurfaceSamples& on = *side.frame.surfaces;
  const SurfaceStarts& starts = side.starts;
  struct Traced {
    std::uint32_t point, path;
  };
  std::vector<Traced> traced;
  const auto onPath = [&](std::uint32_t owner, const PathResults<C>& found, std::uint32_t slot) {
    const auto [i, path] = traced[owner];
    ReflectedLight light;
    addPath<S>(found, slot, {}, light);
    const int x = on.columnOf(i) / on.perPixel(), y = on.rowOf(i);
    const float white = on[i].share * side.frame.g.albedo.at(x, y) / starts.albedo(i);
    on_light(x, y, path, static_cast<float>(light.all) * white);
  };
  PathRun<S, C, true, decltype(onPath)> run(side.tracing, onPath);
  PlainPaths plain(side.tracing.known.pixel, run);
  forEachPixel(tile, [&](int x, int y) {
    const PairNumbers of = numbers(x, y);
    for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
      const auto i = static_cast<std::uint32_t>(on.indexOf(column, y));
      if (!Part::isAt(on[i])) continue;
      for (std::uint32_t path = of.first; path < of.first + of.count; ++path) {
        const NewPath one{places.of(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(y), path),
                          static_cast<std::uint32_t>(traced.size())};
        traced.push_back({i, path});
        if (starts.isPlain(i))
          plain.add(starts.plain(i), one);
        else
          run.add(Part::pathOf(starts.other(i)), one);
      }
    }
  });
  plain.finish();
  run.finish();
}

// Replays the numbers of the frame's own paths in the frame before. Sets `before` and `count`.
template <Shading S, int C>
void renderPairTile(const PairSides& sides, Tile tile, PairSamples& pairs) {
  const SurfaceSamples &now = *sides.now.frame.surfaces, &before = *sides.before.frame.surfaces;
  forEachPixel(tile, [&](int x, int y) {
    float& count = pairs.count.at(x, y) = 0;
    pairs.before.at(x, y) = sides.before.frame.g.emission.at(x, y), pairs.more.at(x, y) = 0;
    if (!now.hasUncacheable(x, y) || !before.hasUncacheable(x, y)) return;
    for (const SurfacePoint& p : now.of(x, y)) count = std::max(count, static_cast<float>(p.paths));
  });
  tracePairSide<S, C, AllOfPoint>(
      sides.before, sides.places, tile,
      [&](int x, int y) {
        return PairNumbers{0, static_cast<std::uint32_t>(pairs.count.at(x, y))};
      },
      [&](int x, int y, std::uint32_t, float light) {
        pairs.before.at(x, y) += light / pairs.count.at(x, y);
      });
}

// Traces `count` pairs of each pixel that shows a coat in any of the frames.
template <Shading S, int C>
void renderCoatTile(const PairSides& sides, std::uint32_t count, Tile tile, CoatSamples& coats) {
  const SurfaceSamples &now = *sides.now.frame.surfaces, &before = *sides.before.frame.surfaces;
  PairSamples& pairs = coats.pairs;
  forEachPixel(tile, [&](int x, int y) {
    coats.now.at(x, y) = pairs.before.at(x, y) = pairs.more.at(x, y) = 0;
    pairs.count.at(x, y) = now.hasCoat(x, y) || before.hasCoat(x, y) ? static_cast<float>(count) : 0;
  });
  const auto trace = [&](const PairSide& side, ImageF& light) {
    tracePairSide<S, C, CoatOfPoint>(
        side, sides.places, tile,
        [&](int, int) {
          return PairNumbers{0, count};
        },
        [&](int x, int y, std::uint32_t, float found) {
          light.at(x, y) += found / static_cast<float>(count);
        });
  };
  trace(sides.now, coats.now);
  trace(sides.before, pairs.before);
}

// Traces the pairs that planMorePairs() has planned. Adds them to the means, and sets their variance.
template <Shading S, int C, class Part>
void renderMorePairsTile(const PairSides& sides, Tile tile, const PairedLight& of) {
  const PairSamples& pairs = of.pairs;
  const auto indexOf = [&](int x, int y) {
    return static_cast<std::size_t>((y - tile.y0) * kMaxTileEdge + x - tile.x0);
  };
  const auto planned = [&](int x, int y) { return static_cast<std::uint32_t>(pairs.more.at(x, y)); };
  const auto first = [&](int x, int y) { return static_cast<std::uint32_t>(pairs.count.at(x, y)); };
  std::vector<std::array<float, 2>> light;  // of each pair: now and before
  std::array<std::size_t, kMaxTileEdge * kMaxTileEdge> at{};
  forEachPixel(tile, [&](int x, int y) {
    at[indexOf(x, y)] = light.size();
    light.resize(light.size() + planned(x, y));
  });
  if (light.empty()) return;
  const auto trace = [&](const PairSide& side, std::size_t which) {
    tracePairSide<S, C, Part>(
        side, sides.places, tile,
        [&](int x, int y) {
          return PairNumbers{first(x, y), planned(x, y)};
        },
        [&](int x, int y, std::uint32_t path, float found) {
          light[at[indexOf(x, y)] + path - first(x, y)][which] += found;
        });
  };
  trace(sides.now, 0);
  trace(sides.before, 1);
  forEachPixel(tile, [&](int x, int y) {
    const std::uint32_t n = planned(x, y);
    if (n > 0) addPairs(std::span(light).subspan(at[indexOf(x, y)], n), x, y, of);
  });
}

}  // namespace saccade
