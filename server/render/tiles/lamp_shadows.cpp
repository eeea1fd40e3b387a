#include "render/tiles/lamp_shadows.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr int kFew = 2, kMost = 256;  // rays to a group of lamps
constexpr int kPartAtFirst = 2;       // of those for kMayHaveMoved: they tell whether others are needed
constexpr float kSpread = 0.25f;  // variance of a change by rays that are spread evenly, of that by any rays

bool moves(const SurfaceShadow& shadow) {
  return shadow.wanted == SurfaceShadow::kMoves;
}

RayNeed needOf(const SurfaceSamples& on, std::size_t point, const SurfaceShadow& shadow) {
  return moves(shadow) ? kMayHaveMoved : on[point].near_shadow ? kElseKnown : kElseLearned;
}

// Variance of visibility that so many rays to these groups leave, as a part of the light of all groups.
float rayVariance(const FrameRays& of, const RayRequest& request, int rays) {
  float light = 0, squares = 0;
  for (int g = 0; g < of.groups(); ++g) {
    const float U = of.at(request.point, g).unoccluded;
    light += U;
    if (request.groups >> g & 1) squares += U * U;
  }
  return light > 0 ? varianceOfRays(squares / (light * light), rays) : 0;
}

}  // namespace

int LampShadows::raysOf(RayNeed need, int spp) {
  constexpr std::array<int, 3> kRaysPerPath = {5, 6, 16};
  return std::clamp(kRaysPerPath[need] * spp, kFew, kMost);
}

std::uint32_t LampShadows::groupsThatDiffer(const RayRequest& request) const {
  std::uint32_t groups = 0;
  for (int g = 0; g < now_.groups(); ++g) {
    const LampRays &now = now_.at(request.point, g), &before = before_.at(request.point, g);
    const bool any_lit = now.anyLit() || before.anyLit(), any_dark = now.anyDark() || before.anyDark();
    if (any_lit && any_dark) groups |= request.groups & 1u << g;
  }
  return groups;
}

void LampShadows::finish(std::size_t point, int rays, SurfaceShadow& shadow) const {
  const LampSums now(now_.of(point)), before(before_.of(point));
  // One variance of the light for both, so that a change is not one of trust.
  const float variance = std::max(now.variance, before.variance);
  shadow.now = now.visibility(shadow.wanted, variance);
  shadow.before = before.visibility(shadow.wanted, variance);
  shadow.rays = 0;
  for (int g = 0; g < now_.groups(); ++g) shadow.rays += now_.at(point, g).count;
  // A ray's end changes with the probability of the change. A change has no more variance than both frames.
  const float each = 1 / static_cast<float>(rays), change = std::abs(shadow.now.mean - shadow.before.mean);
  const float most = now.relativeVariance(now.variance) + before.relativeVariance(before.variance);
  shadow.step_variance = kSpread * std::min(std::max(change, each) * each, most);
}

std::chrono::nanoseconds LampShadows::trace(const FrameStarts& now, const FrameStarts& before, int spp,
                                            const PoolHandle& pool, std::vector<SurfaceShadow>& shadows) {
  if (now_.groups() == 0 || !now.on.wantShadows()) return {};
  now_.use(), before_.use();
  const SurfaceSamples& on = now.on;
  const auto raysTo = [&](std::size_t point) { return raysOf(needOf(on, point, shadows[point]), spp); };
  bands_.resize(static_cast<std::size_t>((on.height() + kBandRows - 1) / kBandRows));
  const auto forEachBand = [&](const auto& f) {
    return pool.run(static_cast<int>(bands_.size()),
                    [&](int i) { f(i, bands_[static_cast<std::size_t>(i)]); });
  };
  const auto traceBoth = [&](const std::vector<RayRequest>& requests, int count) {
    now_.trace(now, requests, count), before_.trace(before, requests, count);
  };
  auto time = forEachBand([&](int i, Requests& band) {
    band.few.clear();
    const auto all_groups = (1u << now_.groups()) - 1;
    const auto end = on.indexOf(0, std::min((i + 1) * kBandRows, on.height()));
    for (std::size_t point = on.indexOf(0, i * kBandRows); point < end; ++point)
      if (shadows[point].wanted > 0) {
        // Both frames have equally many rays, so that a change is not one of their number.
        if (!moves(shadows[point])) before_.limit(point, raysTo(point));
        band.few.push_back({static_cast<std::uint32_t>(point), all_groups});
      }
    traceBoth(band.few, kFew);
  });
  time += forEachBand([&](int, Requests& band) {
    for (std::vector<RayRequest>& requests : band.many) requests.clear();
    for (const RayRequest& few : band.few) {
      RayRequest more{few.point, 0};
      for (int g = 0; g < now_.groups(); ++g)
        if (now_.areMixedAround(on, few.point, g) || before_.areMixedAround(before.on, few.point, g))
          more.groups |= 1u << g;
      if (more.groups == 0) continue;
      SurfaceShadow& shadow = shadows[few.point];
      if (!moves(shadow) && shadow.wanted < kLeastRayGain * rayVariance(now_, more, raysTo(few.point)))
        shadow.wanted = 0;
      else
        band.many[needOf(on, few.point, shadow)].push_back(more);
    }
  });
  return time + forEachBand([&](int, Requests& band) {
           std::vector<RayRequest>& may_have_moved = band.many[kMayHaveMoved];
           traceBoth(may_have_moved, raysOf(kMayHaveMoved, spp) / kPartAtFirst);
           for (RayRequest& request : may_have_moved) request.groups = groupsThatDiffer(request);
           std::erase_if(may_have_moved, [](const RayRequest& request) { return request.groups == 0; });
           for (const RayNeed need : {kElseLearned, kElseKnown, kMayHaveMoved})
             traceBoth(band.many[need], raysOf(need, spp));
           for (const RayRequest& few : band.few)
             if (SurfaceShadow& shadow = shadows[few.point]; shadow.wanted > 0)
               finish(few.point, raysTo(few.point), shadow);
         });
}

void LampShadows::next(const RenderScene& scene, std::size_t points) {
  std::swap(now_, before_);
  now_.reset(points, scene.analyticLight().groups());
  if (!before_.areOf(points, now_.groups())) before_.reset(points, now_.groups());
}

}  // namespace saccade
