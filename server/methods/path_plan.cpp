#include "methods/path_plan.h"

#include <algorithm>

#include "base/hash_rng.h"

namespace saccade {
namespace {

constexpr float kMostForOthers = 8;  // times `asked`

// In [0, 1), spread evenly over any few neighbours in space and time: the R2 sequence (Roberts 2018) in x and
// y, moved on by the golden ratio in every frame.
float ditherAt(int x, int y, std::uint32_t frame) {
  const std::uint32_t bits = static_cast<std::uint32_t>(x) * 0xc13fa9a9u +
                             static_cast<std::uint32_t>(y) * 0x91e10da5u + frame * 0x9e3779b9u;
  return toUnit(bits);
}

bool isOther(const SurfacePoint& p) {
  return p.share > 0 && p.kind == SurfaceKind::kNone;
}

float wantedPaths(const PathPlan& plan, float error) {
  const float r = error / plan.target;
  return std::min(plan.asked, plan.usual * std::max(std::min(1.f, r), 0.5f * r));
}

// What every point of kNone gets.
std::uint32_t pathsForOthers(const PathPlan& plan, const SurfaceSamples& on) {
  double others = 0, planned = 0;
  for (int y = 0; y < on.height(); ++y) {
    for (const SurfacePoint& p : on.row(y)) {
      if (isOther(p))
        ++others;
      else
        planned += p.paths;
    }
  }
  if (others == 0) return 0;
  const double left = double(plan.usual) * (on.columns() / on.perPixel()) * on.height() - planned;
  return static_cast<std::uint32_t>(
      std::clamp(left / others, double(plan.asked), double(kMostForOthers * plan.asked)));
}

}  // namespace

std::chrono::nanoseconds planPaths(const PathPlan& plan, const ImageF& error, std::uint32_t frame,
                                   const PoolHandle& pool, SurfaceSamples& on) {
  auto time = pool.forEachRow(on.height(), [&](int y) {
    for (int column = 0; column < on.columns(); ++column) {
      SurfacePoint& p = on.at(column, y);
      const float wanted = p.share * wantedPaths(plan, error.at(column, y));
      // The whole pixel is sampled, if another method is to estimate it.
      const std::uint32_t least = !isOther(p) && on.showsOthers(column / on.perPixel(), y);
      p.paths = std::max(least, static_cast<std::uint32_t>(wanted + ditherAt(column, y, frame)));
    }
  });
  return time + pool.run(1, [&](int) {
    const std::uint32_t paths = pathsForOthers(plan, on);
    for (int y = 0; y < on.height(); ++y)
      for (SurfacePoint& p : on.row(y))
        if (isOther(p)) p.paths = paths;
  });
}

}  // namespace saccade
