#include "render/tiles/point_sampler.h"

#include <algorithm>
#include <limits>

#include "render/tiles/lamp_ray_tracer.h"
#include "render/tiles/lamp_shadows.h"

namespace saccade {
void PointSampler::withStart(std::size_t k, const auto& f) const {
  const RayBlock& block = blocks_[k / kBlockPixels];
  const int lane = static_cast<int>(k % kBlockPixels);
  if (block.plain.has(lane))
    f(PlainStart(block.surfaces, lane, kNoBody));
  else
    f(others_[k]);
}

void PointSampler::look(const PointView& view, std::span<const PixelMoment> asked,
                        std::span<PointSample> out) {
  withKernel(view.scene.still().shading(), [&]<Shading S>() { lookAs<S>(view, asked, out); });
}

template <Shading S>
void PointSampler::lookAs(const PointView& view, std::span<const PixelMoment> asked,
                          std::span<PointSample> out) {
  for (std::size_t first = 0; first < asked.size(); first += kBlockPixels) {
    RayBlock& block = blocks_[first / kBlockPixels];
    block.count = static_cast<int>(std::min<std::size_t>(kBlockPixels, asked.size() - first));
    const auto cameraOf = [&](std::size_t lane) -> const Camera& {
      return view.cameras[asked[first + lane].moment];
    };
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.count); ++i) {
      const PixelMoment& at = asked[first + i];
      block.rays[i] = {cameraOf(i).origin,
                       cameraOf(i).direction(static_cast<float>(at.x), static_cast<float>(at.y)),
                       std::numeric_limits<float>::infinity()};
    }
    traceRayBlock(view.scene, view.cameras[0], block);
    if (block.plain.any()) lookPlain(view, first, out);
    forEachLane(block.others, [&](int lane) {
      const auto i = static_cast<std::size_t>(lane);
      PointSample& point = out[first + i] = {};
      const PosedView own{view.scene, cameraOf(i)};
      shadePrimary<S>(PixelContext(own), block.rays[i], block.hits[i], hit_);
      point.emission = luminance(hit_.guide.emission);
      if (!hit_.valid) return;
      point.emission += luminance(mirrorImage<S>(view.scene, hit_.start));
      const float albedo = luminance(hit_.guide.albedo);
      if (albedo <= 0) return;
      point.albedo = albedo;
      SurfaceStart& start = others_[first + i];
      setStart<S>(hit_.start, albedo, start);
      point.kind = setPlace(own, hit_, start, point.place);
      if (point.kind != SurfaceKind::kNone && view.motion)
        setMotion(view.scene, *view.motion, hit_.guide.on, seenPoint(hit_.start), point.light_moves,
                  point.place);
    });
  }
  if (view.scene.still().deltaLamps().getRays()) addDeltaLight<S>(view, asked, out.first(asked.size()));
}

void PointSampler::lookPlain(const PointView& view, std::size_t first, std::span<PointSample> out) {
  const RayBlock& block = blocks_[first / kBlockPixels];
  const PlainSurfaces& s = block.surfaces;
  LaneVectors white;
  view.scene.analyticLight().at({s.point, s.shading_normal, s.geometric_normal}, block.plain,
                                view.scene.strengths(), white);
  const PlainPlaces places(s, white);
  forEachLane(block.plain, [&](int lane) {
    PointSample& point = out[first + static_cast<std::size_t>(lane)] = {};
    point.albedo = s.albedo[lane], point.emission = luminance(s.emission.at(lane));
    if (point.albedo <= 0) return;
    point.kind = places.set(s, lane, point.place);
    if (point.kind != SurfaceKind::kNone && view.motion)
      setMotion(view.scene, *view.motion, block.on[static_cast<std::size_t>(lane)], seenPoint(s, lane),
                point.light_moves, point.place);
  });
}

template <Shading S>
void PointSampler::addDeltaLight(const PointView& view, std::span<const PixelMoment> asked,
                                 std::span<PointSample> out) const {
  const auto onLight = [&](std::uint32_t k, float light) { out[k].emission += light; };
  DeltaLight<S, decltype(onLight)> light(view.scene, onLight);
  for (std::size_t k = 0; k < out.size(); ++k)
    if (out[k].albedo > 0)
      withStart(k, [&](const auto& start) {
        light.add(static_cast<std::uint32_t>(k), start, 1, RayNumbers(asked[k].x, asked[k].y));
      });
  light.finish();
}

// Where both frames can ask for rays at the pixel, they have decided, by its neighbours too.
PointSampler::RayPlan PointSampler::planRays(const PixelMoment& at, const EndShadows& ends,
                                             const PlaceLight& light) {
  if (!(light.shadow > 0)) return {};
  const std::size_t pixel = ends.now.indexOf(at.x, at.y);
  if (!ends.now[pixel].canAskRays() || !ends.before[pixel].canAskRays()) {
    if (!light.shadow_visible) return {};
    return {light.shadow, LampShadows::raysOf(kElseKnown, ends.spp), false};
  }
  RayPlan plan{ends.now.shadows()[pixel].wanted, 0, true};
  if (plan.wanted == 0) return plan;
  for (const LampRays& rays : ends.rays.of(pixel)) plan.rays = std::max(plan.rays, rays.count);
  return plan;
}

RayFacet PointSampler::facetOf(std::size_t k, const PointSample& point) const {
  RayFacet facet{point.place.position, {}, point.place.footprint};
  withStart(k, [&](const auto& start) { facet.normal = litPoint(start).geometric_normal; });
  return facet;
}

std::size_t PointSampler::traceShadows(const PointView& view, const LookedAt& at, const EndShadows& ends,
                                       KnownRays& known, std::span<PlaceLight> light) {
  const int groups = ends.rays.groups();
  if (!ends.now.wantShadows() || groups == 0) return 0;
  bool any = false;
  for (std::size_t k = 0; k < at.asked.size(); ++k)
    plans_[k] = planRays(at.asked[k], ends, light[k]), any = any || plans_[k].wanted > 0;
  if (!any) return 0;
  const std::size_t traced = withKernel(view.scene.still().shading(),
                                        [&]<Shading S>() { return traceAs<S>(view, at, groups, known); });
  for (std::size_t k = 0; k < at.asked.size(); ++k) {
    const RayPlan& plan = plans_[k];
    if (plan.wanted == 0) continue;
    const auto of_groups = static_cast<std::size_t>(groups);
    at.rays[k].own = known.add(facets_[k], std::span(bits_).subspan(k * of_groups, of_groups));
    const LampSums sums{std::span(rays_).subspan(k * of_groups, of_groups)};
    const float left = varianceOfRays(sums.relativeVariance(sums.mixed2), plan.rays);
    if (!plan.at_ends && plan.wanted < kLeastRayGain * left) continue;
    const RayVisibility by_rays = sums.visibility(plan.wanted, sums.variance);
    light[k].visibility += by_rays.trust * (by_rays.mean - light[k].visibility);
  }
  return traced;
}

template <Shading S>
std::size_t PointSampler::traceAs(const PointView& view, const LookedAt& at, int groups,
                                  const KnownRays& known) {
  LampRayTracer<S> tracer(view.scene, rays_, bits_);
  for (std::size_t k = 0; k < at.asked.size(); ++k) {
    if (plans_[k].wanted == 0) continue;
    const RaysAround around = at.points[k].light_moves ? RaysAround{} : at.rays[k];
    facets_[k] = facetOf(k, at.points[k]);
    const KnownRays::Bits between = known.between(around.before, around.after, facets_[k]);
    const RayNumbers numbers(at.asked[k].x, at.asked[k].y);
    const std::size_t first = k * static_cast<std::size_t>(groups);
    std::fill_n(&rays_[first], groups, LampRays{}), std::fill_n(&bits_[first], groups, RayBits{});
    withStart(k, [&](const auto& start) {
      tracer.add(start, first, (1u << groups) - 1, plans_[k].rays, numbers, between.data());
    });
  }
  tracer.finish();
  return tracer.traced();
}

}  // namespace saccade
