#include "render/tiles/lamp_shadows.h"

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "render/lights/lamp_points.h"
#include "render/primary/blocks.h"
#include "render/tiles/delta_light.h"

namespace saccade {
namespace {

constexpr int kFew = 4, kManyPerPath = 6, kMost = 256;  // rays to a group of lamps
constexpr int kTileEdge = 32;
constexpr float kSpread = 0.25f;  // variance of a change by rays that are spread evenly, of that by any rays

// The numbers of a point's rays: the R3 sequence (Roberts 2018). Its start is spread evenly over neighbours,
// and is the same in all frames.
class RayNumbers {
 public:
  RayNumbers(int column, int y)
      : column_(static_cast<std::uint32_t>(column)), row_(static_cast<std::uint32_t>(y)) {}
  float u(int ray, int dimension) const {
    return toUnit(static_cast<std::uint32_t>(ray) * kOfRay[dimension] + column_ * kOfColumn[dimension] +
                  row_ * kOfRow[dimension]);
  }

 private:
  // As fractions of 2^32. Those of columns and rows are R2, and fractions of square roots of primes.
  static constexpr std::uint32_t kOfRay[] = {0xd1b54a33u, 0xabc98389u, 0x8cb92ba7u};
  static constexpr std::uint32_t kOfColumn[] = {0xc13fa9a9u, 0x6a09e667u, 0xbb67ae85u};
  static constexpr std::uint32_t kOfRow[] = {0x91e10da5u, 0x9b05688cu, 0x1f83d9abu};

  std::uint32_t column_, row_;
};

bool isLit(const SurfaceSamples& on, std::size_t point) {
  const SurfacePoint& p = on[point];
  return p.share > 0 && p.kind != SurfaceKind::kNone && !p.baked && on.place(point).unoccluded > 0;
}

LitPoint litPointOf(const PlainStart& start) {
  return {start.point, start.shading_normal, start.geometric_normal};
}
LitPoint litPointOf(const SurfaceStart& start) {
  const Surface& s = start.path.surface;
  return {s.point, s.shading_normal, s.geometric_normal};
}

// Whether a neighbour lies in the plane of a point.
bool isOneSurface(const SurfacePlace& a, const SurfacePlace& b) {
  constexpr float kLeastCosine = 0.8f;
  return dot(a.normal, b.normal) > kLeastCosine &&
         std::abs(dot(b.position - a.position, a.normal)) < a.footprint;
}

void forEachPoint(const SurfaceSamples& on, Tile tile, const auto& f) {
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int column = tile.x0 * on.perPixel(); column < tile.x1 * on.perPixel(); ++column) f(column, y);
}

}  // namespace

// Adds rays, up to `count` of each point and group that wanted(point, group) tells.
template <Shading S>
void LampShadows::traceTile(const Traced& frame, Tile tile, int count, const auto& wanted) const {
  const auto& scene = frame.of.scene;
  const SurfaceSamples& on = frame.of.on;
  const auto& starts = frame.of.starts;
  const Tracing tracing{scene, 0, {}};
  const auto onEnd = [&](const ShadowRay& ray, Rgb fraction) {
    Rays& rays = frame.rays[ray.owner];
    rays.visible += ray.weight * luminance(fraction), rays.all += ray.weight;
  };
  TileShadowRays<S, decltype(onEnd)> shadow_rays(tracing, onEnd);
  const auto add = [&](std::size_t point, const RayNumbers& numbers, Vec3 origin, const LampPoints& lamps) {
    for (int g = 0; g < groups_; ++g) {
      const auto i = static_cast<std::uint32_t>(indexOf(point, g));
      Rays& rays = frame.rays[i];
      if (rays.count >= count || !wanted(point, g)) continue;
      rays.unoccluded = lamps.unoccluded(g);
      for (; rays.count < count && rays.unoccluded > 0; ++rays.count) {
        const auto u = [&](int dimension) { return numbers.u(rays.count, dimension); };
        const LampPoints::Point to = lamps.at(g, u(0), u(1), u(2));
        if (to.weight > 0) shadow_rays.add({origin, to.position - origin, kShadowEnd, i, to.weight});
      }
      rays.count = count;
    }
  };
  forEachPoint(on, tile, [&](int column, int y) {
    const std::size_t point = on.indexOf(column, y);
    bool any = false;
    for (int g = 0; g < groups_; ++g)
      any = any || (frame.rays[indexOf(point, g)].count < count && wanted(point, g));
    if (!any || !isLit(on, point)) return;
    const RenderScene& still = scene.still();
    const auto from = [&](const auto& start, const LitPoint& p, Rgb base) {
      add(point, {column, y}, leave(still, start), {still.analyticLight(), p, base, scene.strengths()});
    };
    if (starts.isPlain(point))
      from(starts.plain(point), litPointOf(starts.plain(point)), starts.plain(point).reflectance);
    else
      from(starts.other(point), litPointOf(starts.other(point)), starts.other(point).base.albedo);
  });
  shadow_rays.finish();
}

// Whether some rays of a point and its neighbours on the same surface are blocked and others are not.
bool LampShadows::isPenumbra(const Traced& frame, int column, int y, int group) const {
  const SurfaceSamples& on = frame.of.on;
  const int step = on.perPixel();
  const std::size_t point = on.indexOf(column, y);
  bool lit = false, dark = false;
  for (int ny = std::max(0, y - 1); ny <= std::min(on.height() - 1, y + 1); ++ny)
    for (int nx = column - step; nx <= column + step; nx += step) {
      if (nx < 0 || nx >= on.columns()) continue;
      const std::size_t neighbour = on.indexOf(nx, ny);
      const Rays& rays = frame.rays[indexOf(neighbour, group)];
      if (rays.all <= 0 || !isOneSurface(on.place(point), on.place(neighbour))) continue;
      lit = lit || rays.visible > 0, dark = dark || rays.visible < rays.all;
    }
  return lit && dark;
}

void LampShadows::finish(std::size_t point, int rays, SurfaceShadow& shadow) const {
  struct Sums {
    float light = 0, visible = 0, variance = 0;  // of `visible`
    float relativeVariance(float v) const { return light > 0 ? v / (light * light) : 0; }
  };
  const auto sumsOf = [&](const std::vector<Rays>& of) {
    Sums sums;
    for (int g = 0; g < groups_; ++g) {
      const Rays& rays = of[indexOf(point, g)];
      const float V = rays.visibility(), U = rays.unoccluded;
      sums.light += U, sums.visible += U * V;
      if (rays.areMixed()) sums.variance += U * U * V * (1 - V) / static_cast<float>(rays.count);
    }
    return sums;
  };
  const Sums now = sumsOf(now_), before = sumsOf(before_);
  // One variance of the light for both, so that a change is not one of trust.
  const float variance = std::max(now.variance, before.variance);
  const auto known = [&](const Sums& sums) -> RayVisibility {
    const float of_mean = sums.relativeVariance(variance);
    return {sums.light > 0 ? sums.visible / sums.light : 1, shadow.wanted / (shadow.wanted + of_mean),
            of_mean};
  };
  shadow.now = known(now), shadow.before = known(before);
  // A ray's end changes with the probability of the change. A change has no more variance than both frames.
  const float each = 1 / static_cast<float>(rays), change = std::abs(shadow.now.mean - shadow.before.mean);
  const float most = now.relativeVariance(now.variance) + before.relativeVariance(before.variance);
  shadow.step_variance = kSpread * std::min(std::max(change, each) * each, most);
}

std::chrono::nanoseconds LampShadows::trace(const FrameStarts& now, const FrameStarts& before, int spp,
                                            const PoolHandle& pool, std::vector<SurfaceShadow>& shadows) {
  if (groups_ == 0) return {};
  const int many = std::clamp(kManyPerPath * spp, kFew, kMost);
  const SurfaceSamples& on = now.on;
  const auto pass = [&](int count, const auto& wanted) {
    return pool.forEachTile(on.columns() / on.perPixel(), on.height(), kTileEdge, [&](Tile tile) {
      withKernel(now.scene.still().shading(), [&]<Shading S>() {
        traceTile<S>({now, now_}, tile, count, wanted);
        traceTile<S>({before, before_}, tile, count, wanted);
      });
    });
  };
  auto time = pass(kFew, [&](std::size_t point, int) { return shadows[point].wanted > 0; });
  const auto forEachWanted = [&](const auto& f) {
    return pool.forEachRow(on.height(), [&](int y) {
      for (int column = 0; column < on.columns(); ++column)
        if (const std::size_t point = on.indexOf(column, y); shadows[point].wanted > 0) f(point, column, y);
    });
  };
  penumbra_.assign(now_.size(), false);
  time += forEachWanted([&](std::size_t point, int column, int y) {
    for (int g = 0; g < groups_; ++g)
      penumbra_[indexOf(point, g)] =
          isPenumbra({now, now_}, column, y, g) || isPenumbra({before, before_}, column, y, g);
  });
  time += pass(many, [&](std::size_t point, int group) { return penumbra_[indexOf(point, group)]; });
  return time + forEachWanted([&](std::size_t point, int, int) { finish(point, many, shadows[point]); });
}

void LampShadows::next(const RenderScene& scene, std::size_t points) {
  groups_ = scene.analyticLight().groups();
  std::swap(now_, before_);
  now_.assign(points * static_cast<std::size_t>(groups_), {});
  before_.resize(now_.size());
}

}  // namespace saccade
