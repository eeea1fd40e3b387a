#include "render/tiles/reconnected_tile.h"

#include <array>
#include <optional>
#include <vector>

#include "render/tiles/reconnection.h"

namespace saccade {
namespace {

struct WholePaths {
  TileSums& sums;

  template <int C>
  void operator()(std::uint32_t owner, const PathResults<C>& found, std::uint32_t slot) const {
    sums.add(owner, found.radiance.at(slot).luminance());
  }
};

// The light that a second vertex reflects, as both passes of a pixel see it.
struct Reflected {
  Rgb albedo;                   // of the first vertex
  std::uint32_t owner;          // of pass 1; that of pass 2 follows
  std::array<float, 2> weight;  // by pass
};

struct Suffixes {
  TileSums& sums;
  const std::vector<Reflected>& reflected;

  template <int C>
  void operator()(std::uint32_t i, const PathResults<C>& found, std::uint32_t slot) const {
    const Reflected& r = reflected[i];
    const float light = (Color<C>(r.albedo) * found.radiance.at(slot)).luminance();
    for (const std::uint32_t pass : {0u, 1u})
      if (r.weight[pass] != 0) sums.add(r.owner + pass, light * r.weight[pass]);
  }
};

template <Shading S, int C>
class ReconnectedPaths {
 public:
  ReconnectedPaths(const PixelContext& view, const SeedPlan& seeds, int bounces, TileSums& sums)
      : view_(view),
        seeds_(seeds),
        sums_(sums),
        whole_{sums},
        suffixes_{sums, *reflected_},
        all_{view.now.scene, bounces, {}},
        direct_{view.now.scene, 0, {}},
        further_{view.now.scene, bounces - 1, {}} {
    reflected_->clear();
  }

  // The paths of a pixel that shows `now`. `before`: what it showed, where paths can be reconnected to both;
  // else nullptr.
  void add(int x, int y, const PathStart& now, const PathStart* before) {
    forEachSample(seeds_, 0, [&](const PixelSequence& numbers, std::uint32_t i) {
      const NewPath path{numbers.of(x, y, i), sums_.owner(x, y, 0)};
      std::optional<PathStart> x2 = begin(now, path);
      if (before) x2 = secondVertex<S>(view_.before.scene, *before, path.sampler);
      if (x2) reflect(now, *x2, path, {before ? shareOfBefore(now, *before, *x2) : 1, 0});
    });
    forEachSample(seeds_, 1, [&](const PixelSequence& numbers, std::uint32_t i) {
      const NewPath path{numbers.of(x, y, i), sums_.owner(x, y, 1)};
      const std::optional<PathStart> y2 = begin(now, path);
      if (y2) reflect(now, *y2, path, {before ? shareOfNow(now, *before, *y2) - 1 : 0, 1});
    });
  }

  void finish() { all_run_.finish(), direct_run_.finish(), further_run_.finish(); }

 private:
  template <class OnPath>
  using Run = PathRun<S, C, false, OnPath>;

  // Adds a path of this frame. Its second vertex is left out, and returned, if it connects().
  std::optional<PathStart> begin(const PathStart& start, const NewPath& path) {
    std::optional<PathStart> second;
    const bool splits = connects<S>(start.surface);
    if (splits) second = secondVertex<S>(view_.now.scene, start, path.sampler);
    if (splits && (!second || connects<S>(second->surface))) return direct_run_.add(start, path), second;
    all_run_.add(start, path);
    return {};
  }

  // Adds the light that `second` reflects to the pixel that shows `first`, if it connects().
  void reflect(const PathStart& first, const PathStart& second, const NewPath& path,
               std::array<float, 2> weight) {
    if (!connects<S>(second.surface) || weight == std::array<float, 2>{}) return;
    further_run_.add(second,
                     {path.sampler.from(kDimensions), static_cast<std::uint32_t>(reflected_->size())});
    reflected_->push_back({first.surface.bsdf.diffuse, path.owner & ~1u, weight});
  }

  // s of a vertex that a path of the frame before, or of this frame, has reached.
  float shareOfBefore(const PathStart& now, const PathStart& before, const PathStart& x2) const {
    return 2 * balance(visibleTerm(view_.now.scene, now.surface, x2.surface),
                       geometryTerm(before.surface, x2.surface));
  }
  float shareOfNow(const PathStart& now, const PathStart& before, const PathStart& y2) const {
    return 2 * balance(geometryTerm(now.surface, y2.surface),
                       visibleTerm(view_.before.scene, before.surface, y2.surface));
  }

  const PixelContext& view_;
  const SeedPlan& seeds_;
  TileSums& sums_;
  Scratch<std::vector<Reflected>> reflected_;
  WholePaths whole_;
  Suffixes suffixes_;
  Tracing all_, direct_, further_;
  Run<WholePaths> all_run_{all_, whole_}, direct_run_{direct_, whole_};
  Run<Suffixes> further_run_{further_, suffixes_};
};

// Calls f(x, y, now, before) with what the centres of a tile's pixels show in both frames.
template <Shading S>
void forEachShown(const PixelContext& view, Tile tile, const auto& f) {
  const PixelContext view_before(view.before);
  std::array<Vec2, kMostPoints> points;
  std::array<PrimaryHit, kMostPoints> now, before;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x0 = tile.x0; x0 < tile.x1; x0 += int{kMostPoints}) {
      const auto count = std::min(kMostPoints, static_cast<std::size_t>(tile.x1 - x0));
      for (std::size_t i = 0; i < count; ++i)
        points[i] = {static_cast<float>(x0) + static_cast<float>(i), static_cast<float>(y)};
      tracePrimaries<S>(view, std::span(points).first(count), std::span(now).first(count));
      tracePrimaries<S>(view_before, std::span(points).first(count), std::span(before).first(count));
      for (std::size_t i = 0; i < count; ++i) f(x0 + static_cast<int>(i), y, now[i], before[i]);
    }
  }
}

template <Shading S, int C>
void renderShaded(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile, Frame& out) {
  TileSums sums(tile, seeds);
  ReconnectedPaths<S, C> paths(view, seeds, bounces, sums);
  const bool same_light = !out.stands && view.now.scene.state() == view.before.scene.state();
  forEachShown<S>(view, tile, [&](int x, int y, const PrimaryHit& now, const PrimaryHit& before) {
    writeFeatures(now, view.now.camera, view.before.camera, x, y, out.g);
    if (!now.valid) return;
    const bool both =
        same_light && before.valid && connects<S>(now.start.surface) && connects<S>(before.start.surface);
    paths.add(x, y, now.start, both ? &before.start : nullptr);
  });
  paths.finish();
  forEachPixel(tile, [&](int x, int y) {
    const float E = out.g.emission.at(x, y);
    out.samples.I1.at(x, y) = E + sums.mean(x, y, 0);
    out.samples.I2.at(x, y) = E + sums.mean(x, y, 1);
  });
}

}  // namespace

template <int C>
void renderReconnectedTile(const PixelContext& view, const SeedPlan& seeds, int bounces, Tile tile,
                           Frame& out) {
  withKernel(view.now.scene.still().shading(),
             [&]<Shading S>() { renderShaded<S, C>(view, seeds, bounces, tile, out); });
}

template void renderReconnectedTile<1>(const PixelContext&, const SeedPlan&, int, Tile, Frame&);
template void renderReconnectedTile<3>(const PixelContext&, const SeedPlan&, int, Tile, Frame&);

}  // namespace saccade
