#include "methods/light_change.h"

#include <algorithm>
#include <utility>

#include "filter/atrous.h"

namespace saccade {
namespace {

constexpr int kIterations = 3;
constexpr AtrousParams kAtrous{.sigma_n = 16, .sigma_l_diff = 4, .primal = false};

// Of all changes that are known, in each frame.
float kept(const SurfacePoint&) {
  return 0.95f;
}

// d e / (e + caution var), with e the energy of d beyond its noise. `var`: before the filter, which takes
// errors of neighbours for independent although they share vertices.
float proven(float d, float var) {
  constexpr float kCaution = 4;
  const float energy = std::max(0.f, d * d - var);
  return energy > 0 ? d * energy / (energy + kCaution * var) : 0;
}

}  // namespace

void LightChange::estimate(const FramePair& frames, const Placement& at, LightState& light,
                           const PoolHandle& pool, StageTimes& times) {
  const SurfaceSamples& on = *frames.cur.surfaces;
  const auto differs = [](float change) { return change != 0; };
  // Changes of earlier frames say nothing of bodies that have come to rest.
  if (std::ranges::none_of(on.changes(), differs)) return planes_.d.fill(0);
  const FrameOnGrid frame{.on = on, .g = frames.cur.g, .at = at, .residuals = &on.changes()};
  SurfaceGrid& changes = light.changes;
  changes.follow(light.grid);
  times[Stage::kTemporal] += changes.fade(frame, kept, pool);
  const SurfaceGrid::Added added = changes.add(frame, pool);
  const SurfaceGrid::Compared compared = changes.readAdded(added, pool, estimate_);
  times[Stage::kTemporal] += added.time + changes.learn(compared, pool);
  times[Stage::kVariance] += compared.time;
  times[Stage::kVariance] += pool.forEachRow(on.height(), [&](int y) {
    for (int x = 0; x < planes_.d.width(); ++x)
      planes_.d.at(x, y) = estimate_.i.at(x, y), planes_.var_d.at(x, y) = estimate_.var_i.at(x, y);
  });
  for (int k = 0; k < kIterations; ++k) {
    times[Stage::kAtrous] += atrousIteration(frames, kAtrous, 1 << k, planes_, pool, scratch_);
    std::swap(planes_, scratch_);
  }
  times[Stage::kModulate] += pool.forEachRow(on.height(), [&](int y) {
    for (int x = 0; x < planes_.d.width(); ++x)
      planes_.d.at(x, y) = proven(planes_.d.at(x, y), estimate_.var_i.at(x, y));
  });
}

}  // namespace saccade
