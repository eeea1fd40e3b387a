// The samples of a tile's pixels, in both passes.
#pragma once

#include <array>
#include <cmath>

#include "base/hash_rng.h"
#include "base/scratch.h"
#include "frame/pixel_before.h"
#include "render/paths/path_run.h"
#include "render/primary/sub_pixels_shown.h"
#include "render/sampling/pixel_sequence.h"

namespace saccade {

inline constexpr int kMaxTileEdge = 32;
inline constexpr float kLeastAlbedo = 1e-3f;  // of a point that shows illumination, over the pixel's average

// The light that the paths of each pixel of a tile have found, pass by pass.
class TileSums {
 public:
  TileSums(Tile tile, const SeedPlan& seeds) : tile_(tile), spp_{seeds.spp1, seeds.spp2} {}

  std::uint32_t owner(int x, int y, int pass) const {
    return static_cast<std::uint32_t>(((y - tile_.y0) * kMaxTileEdge + x - tile_.x0) * 2 + pass);
  }
  // A path without a finite estimate counts as black. Such a path is rare: its light sample is the very point
  // that it lights, or its lamp is too bright for floats.
  void add(std::uint32_t owner, float light) {
    if (std::isfinite(light)) sums_[owner] += light;
  }
  float mean(int x, int y, int pass) const {
    return spp_[pass] > 0 ? static_cast<float>(sums_[owner(x, y, pass)] / spp_[pass]) : 0;
  }

 private:
  Tile tile_;
  std::array<int, 2> spp_;
  std::array<double, 2 * kMaxTileEdge * kMaxTileEdge> sums_{};
};

// Traces the centres of a tile's pixels, and adds their paths to `run`. For each path of a pixel
// forEachPath(f) calls f(pathOf): pathOf(x, y) is that path. Calls on_emission(x, y, E) with the light that
// each pixel itself emits.
template <Shading S>
void addPaths(const PixelContext& view, Tile tile, GBuffer& g, auto& run, const auto& forEachPath,
              const auto& on_emission) {
  const auto onPlain = [&](const PrimaryBlock& block) {
    forEachPath([&](const auto& pathOf) {
      run.addPlain(block.surfaces, block.plain, view.now.camera.pixel,
                   [&](int lane) { return pathOf(block.x(lane), block.y(lane)); });
    });
    forEachLane(block.plain, [&](int lane) {
      on_emission(block.x(lane), block.y(lane), block.surfaces.emission.at(lane));
    });
  };
  const auto onOther = [&](int x, int y, const PrimaryHit& primary) {
    if (primary.valid) forEachPath([&](const auto& pathOf) { run.add(primary.start, pathOf(x, y)); });
    on_emission(x, y, primary.guide.emission);
  };
  const Scratch<PrimaryBlock> block;
  const auto blockAt = [&](int, int) -> PrimaryBlock& { return *block; };
  forEachPrimary<S>(view, tile, g, blockAt, onPlain, onOther);
  run.finish();
}

// Calls f(numbers, sample) for the samples of a pass: 0 or 1.
void forEachSample(const SeedPlan& seeds, int pass, const auto& f) {
  const int spp = pass == 0 ? seeds.spp1 : seeds.spp2;
  if (spp == 0) return;
  const PixelSequence numbers(pass == 0 ? seeds.seed1 : seeds.seed2, std::max(spp, seeds.all), seeds.numbers);
  for (int i = 0; i < spp; ++i) f(numbers, static_cast<std::uint32_t>(seeds.before + i));
}

// All paths start at the centre of the pixel.
template <Shading S, int C>
void renderTile(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile, Frame& out) {
  TileSums sums(tile, seeds);
  const auto onPath = [&](std::uint32_t owner, const PathResults<C>& found, std::uint32_t slot) {
    sums.add(owner, found.radiance.at(slot).luminance());
  };
  const Tracing tracing{view.now.scene, bounces, {}};
  PathRun<S, C, false, decltype(onPath)> run(tracing, onPath);
  const auto forEachPath = [&](const auto& f) {
    for (const int pass : {0, 1})
      forEachSample(seeds, pass, [&](const PixelSequence& numbers, std::uint32_t i) {
        f([&](int x, int y) { return NewPath{numbers.of(x, y, i), sums.owner(x, y, pass)}; });
      });
  };
  addPaths<S>(view, tile, out.g, run, forEachPath, [](int, int, Rgb) {});
  forEachPixel(tile, [&](int x, int y) {
    const float E = out.g.emission.at(x, y);
    out.samples.I1.at(x, y) = seeds.spp1 > 0 ? E + sums.mean(x, y, 0) : 0;
    out.samples.I2.at(x, y) = seeds.spp2 > 0 ? E + sums.mean(x, y, 1) : 0;
  });
}

// Chooses among the layers of a point, in [0, 1): the R2 sequence (Roberts 2018). It is moved on by the
// golden ratio each time that the point comes round.
inline float layerNumber(int x, int y, FrameIndex jitter) {
  return toUnit(static_cast<std::uint32_t>(x) * 0xc13fa9a9u + static_cast<std::uint32_t>(y) * 0x91e10da5u +
                static_cast<std::uint32_t>(jitter / kSubPixels) * 0x9e3779b9u);
}

// The pixel whose numbers the paths of (x, y) take.
inline PixelPlace numbersOf(const SeedPlan& seeds, int pass, const GBuffer& g, int x, int y) {
  return pass == 0 && seeds.along_motion ? pixelBefore(g, x, y) : PixelPlace{x, y};
}

// The paths of each pass start at its own point of the pixel.
// A sample is scaled as if it came off the average albedo of the pixel. For the filter smooths illumination,
// and the average is without noise [paper, 5.5]. Guides are of the centre.
template <Shading S, int C>
void renderJitteredTile(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile, Frame& out) {
  TileSums sums(tile, seeds);
  std::array<float, 2 * kMaxTileEdge * kMaxTileEdge> scale{};  // by owner
  const auto onPath = [&](std::uint32_t owner, const PathResults<C>& found, std::uint32_t slot) {
    sums.add(owner, found.radiance.at(slot).luminance());
  };
  const Tracing tracing{view.now.scene, bounces, {}};
  PathRun<S, C, false, decltype(onPath)> run(tracing, onPath);
  forEachPixel(tile, [&](int x, int y) {
    const SubPixels<S> shown(view, x, y);
    writeFeatures(shown.centre(), view.now.camera, view.before.camera, x, y, out.g);
    const float A = out.g.albedo.at(x, y) = shown.albedo();
    out.g.emission.at(x, y) = shown.emission();
    if (A <= 0) return;
    const auto addPaths = [&](int pass, FrameIndex jitter) {
      std::size_t i = jitter % kSubPixels;
      const float u = layerNumber(x, y, jitter);
      const PrimaryHit* hit = nullptr;  // a black point shows no illumination
      while (!(hit = shown.choose(i, kLeastAlbedo * A, u))) i = (i + 1) % kSubPixels;
      const std::uint32_t owner = sums.owner(x, y, pass);
      scale[owner] = A / luminance(hit->guide.albedo);
      forEachSample(seeds, pass, [&](const PixelSequence& numbers, std::uint32_t sample) {
        const PixelPlace of = numbersOf(seeds, pass, out.g, x, y);
        run.add(hit->start, {numbers.of(of.x, of.y, sample), owner});
      });
    };
    addPaths(0, seeds.frame1);
    addPaths(1, seeds.frame2);
  });
  run.finish();
  forEachPixel(tile, [&](int x, int y) {
    const float E = out.g.emission.at(x, y);
    const auto sample = [&](int pass) { return E + sums.mean(x, y, pass) * scale[sums.owner(x, y, pass)]; };
    out.samples.I1.at(x, y) = seeds.spp1 > 0 ? sample(0) : 0;
    out.samples.I2.at(x, y) = seeds.spp2 > 0 ? sample(1) : 0;
  });
}

}  // namespace saccade
