#include "render/tiles/lamp_shadows.h"

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "render/lights/lamp_points.h"
#include "render/primary/blocks.h"
#include "render/tiles/delta_light.h"

namespace saccade {
namespace {

static const int kFew = std::getenv("SD_FEW") ? std::atoi(std::getenv("SD_FEW")) : 4, kMany = std::getenv("SD_MANY") ? std::atoi(std::getenv("SD_MANY")) : 32;
constexpr int kEdge = 32;  // of a tile

// Numbers of ray i of a point: the R3 sequence (Roberts 2018), whose start is spread evenly over neighbours.
// They are the same in all frames.
struct RayNumbers {
  RayNumbers(int column, int y)
      : column(static_cast<std::uint32_t>(column)), row(static_cast<std::uint32_t>(y)) {}
  float u(int i, int dimension) const {
    constexpr std::uint32_t kOfRay[] = {0xd1b54a33u, 0xabc98389u, 0x8cb92ba7u},
                            kOfColumn[] = {0xc13fa9a9u, 0x6a09e667u, 0xbb67ae85u},
                            kOfRow[] = {0x91e10da5u, 0x9b05688cu, 0x1f83d9abu};
    return toUnit(static_cast<std::uint32_t>(i) * kOfRay[dimension] + column * kOfColumn[dimension] +
                  row * kOfRow[dimension]);
  }
  std::uint32_t column, row;
};

bool isLit(const SurfaceSamples& on, std::size_t i) {
  return on[i].share > 0 && on[i].kind != SurfaceKind::kNone && !on[i].baked && on.place(i).unoccluded > 0;
}

}  // namespace

template <Shading S>
void LampShadows::traceTile(const FrameStarts& of, Tile tile, int rays, const auto& wanted,
                            std::vector<Traced>& traced) {
  const SurfaceSamples& on = *of.frame.surfaces;
  const Tracing tracing{of.scene, 0, {}};
  const auto onEnd = [&](const ShadowRay& ray, Rgb fraction) {
    Traced& t = traced[ray.owner];
    t.visible += ray.weight * luminance(fraction), t.all += ray.weight;
  };
  TileShadowRays<S, decltype(onEnd)> shadow_rays(tracing, onEnd);
  const RenderScene& scene = of.scene.still();
  const auto add = [&](std::uint32_t i, int column, int y, const auto& start, const LitPoint& p, Rgb base) {
    const LampPoints lamps(scene.analyticLight(), p, base, of.scene.strengths());
    const Vec3 origin = leave(scene, start);
    const RayNumbers numbers(column, y);
    for (int k = traced[i].rays; k < rays && !lamps.empty(); ++k) {
      const LampPoints::Point to = lamps.at(numbers.u(k, 0), numbers.u(k, 1), numbers.u(k, 2));
      if (to.weight > 0) shadow_rays.add({origin, to.position - origin, kShadowEnd, i, to.weight});
    }
    traced[i].rays = rays;
  };
  forEachPixel(tile, [&](int x, int y) {
    for (int column = x * on.perPixel(); column < (x + 1) * on.perPixel(); ++column) {
      const auto i = static_cast<std::uint32_t>(on.indexOf(column, y));
      if (traced[i].rays >= rays || !isLit(on, i) || !wanted(column, y)) continue;
      if (of.starts.isPlain(i)) {
        const PlainStart& start = of.starts.plain(i);
        add(i, column, y, start, {start.point, start.shading_normal, start.geometric_normal},
            start.reflectance);
      } else {
        const SurfaceStart& start = of.starts.other(i);
        const Surface& s = start.path.surface;
        add(i, column, y, start, {s.point, s.shading_normal, s.geometric_normal}, start.base.albedo);
      }
    }
  });
  shadow_rays.finish();
}

bool LampShadows::isPenumbra(const SurfaceSamples& on, int column, int y) const {
  bool lit = false, dark = false;
  const int step = on.perPixel();
  for (int ny = std::max(0, y - 1); ny <= std::min(on.height() - 1, y + 1); ++ny)
    for (int nx = std::max(column % step, column - step); nx <= std::min(on.columns() - 1, column + step);
         nx += step) {
      const std::size_t i = on.indexOf(nx, ny);
      for (const Traced& t : {now_[i], before_[i]})
        lit = lit || t.visible > 0, dark = dark || t.visible < t.all;
    }
  return lit && dark;
}

SurfaceShadow LampShadows::shadowOf(std::size_t i, float left_out) const {
  const Traced &now = now_[i], &before = before_[i];
  SurfaceShadow s{.wanted = left_out, .now = now.visibility(), .before = before.visibility()};
  const auto noise = [](const Traced& t) {
    const float v = t.visibility();
    return t.rays > 0 ? v * (1 - v) / static_cast<float>(t.rays) : 0;
  };
  s.variance = std::max(noise(now), noise(before));
  s.trust = left_out / (left_out + s.variance);
  const auto rays = static_cast<float>(std::max({now.rays, before.rays, 1}));
  s.step_variance =
      now.isWhole() && before.isWhole() ? 0 : std::max(std::abs(s.now - s.before), 1 / rays) / rays;
  return s;
}

std::chrono::nanoseconds LampShadows::trace(const FrameStarts& now, const FrameStarts& before,
                                            const PoolHandle& pool, std::vector<SurfaceShadow>& out) {
  const SurfaceSamples& on = *now.frame.surfaces;
  const int width = now.frame.width(), height = now.frame.height();
  const auto pass = [&](int rays, const auto& wanted) {
    return pool.forEachTile(width, height, kEdge, [&](Tile tile) {
      withKernel(now.scene.still().shading(), [&]<Shading S>() {
        traceTile<S>(now, tile, rays, wanted, now_);
        traceTile<S>(before, tile, rays, wanted, before_);
      });
    });
  };
  const auto isWanted = [&](int column, int y) { return out[on.indexOf(column, y)].wanted > 0; };
  auto time = pass(kFew, isWanted);
  std::vector<char> penumbra(out.size());
  time += pool.forEachRow(height, [&](int y) {
    for (int column = 0; column < on.columns(); ++column)
      if (isWanted(column, y)) penumbra[on.indexOf(column, y)] = isPenumbra(on, column, y);
  });
  time += pass(kMany, [&](int column, int y) { return penumbra[on.indexOf(column, y)] != 0; });
  return time + pool.forEachRow(height, [&](int y) {
    for (int column = 0; column < on.columns(); ++column)
      if (const std::size_t i = on.indexOf(column, y); out[i].wanted > 0) out[i] = shadowOf(i, out[i].wanted);
  });
}

void LampShadows::next(std::size_t points) {
  std::swap(now_, before_);
  before_.resize(points);
  now_.assign(points, {});
}

}  // namespace saccade
