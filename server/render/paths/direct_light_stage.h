// Direct light: one sample of each stratum of the lights for each path, at its vertex. Its weight is its
// share in the balance heuristic.
#pragma once

#include "render/paths/light_samples.h"
#include "render/paths/plastic_lanes.h"
#include "render/paths/shadow_rays.h"

namespace saccade {

// The share of light from `direction` that surfaces scatter, at this cosine with their shading normals.
template <int W, PathKind K>
[[gnu::always_inline]] inline ScatteredLanes<W, K.channels> evaluateLanes(
    const Batch<K.channels>& b, int first, const Vec3T<Floats<W>>& direction, const Vec3T<Floats<W>>& ns,
    const Floats<W>& cosine, LaneSet lanes) {
  constexpr int C = K.channels;
  ScatteredLanes<W, C> f;
  f.pdf = cosinePdf(cosine);
  f.value = colorLanes<W>(b.now->reflectance, first);
  for (int k = 0; k < C; ++k) f.value[k] *= f.pdf;
  if constexpr (K.mixed) {
    const LaneSet plastic = lanesShadedAs<W>(ShadedAs::kPlastic, *b.now, first, lanes);
    if (plastic.any()) {
      const ShadingFrame<Floats<W>> frame(ns);
      mergeLanes(plastic,
                 PlasticLanes<W, C>(*b.now, first, frame, plastic).evaluate(frame.toLocal(direction)), f);
    }
    forEachLane(lanesShadedAs<W>(ShadedAs::kOther, *b.now, first, lanes), [&](int i) {
      const BsdfValue one =
          b.stages.evaluate(*b.now, static_cast<std::uint32_t>(first + i), laneOf(direction, i));
      setLane(f.value, i, Color<C>(one.value));
      f.pdf[i] = one.pdf;
    });
  }
  return f;
}

// The lanes of these that scatter light through rough glass. Their rays leave on its other side.
template <int W, int C>
LaneSet goThrough(const Batch<C>& b, int first, LaneSet behind, Vec3T<Floats<W>>& origin,
                  Vec3T<Floats<W>>& segment) {
  constexpr BsdfKinds kRough = kindsWith(&BsdfTraits::transmits_rough);
  LaneSet through;
  forEachLane(lanesShadedAs<W>(ShadedAs::kOther, *b.now, first, behind), [&](int i) {
    const Surface& s = b.now->surfaces[static_cast<std::size_t>(first + i)];
    if ((kRough & only(s.bsdf.tables->model.kind)) == 0) return;
    const Vec3 from = leave(s, true);
    setLane(segment, i, laneOf(segment, i) + laneOf(origin, i) - from);
    setLane(origin, i, from);
    through.add(i);
  });
  return through;
}

template <int W, PathKind K>
void directLightOf(const Batch<K.channels>& b, Stratum stratum) {
  constexpr int C = K.channels;
  using F = Floats<W>;
  const LivePaths<C>& p = *b.now;
  ShadowRays<W, K> shadow_rays(b);
  for (int first = 0; first < p.count; first += W) {
    auto lanes = firstLanes<W>(p.count - first);
    if constexpr (K.mixed)  // paths without bounces left only go straight on, see PathState
      lanes = lanes && toFloats(Uints<W>(load<W>(&p.state[first]) >> 8)) <= static_cast<float>(b.t.bounces);
    const Vec3T<F> ng = p.geometric_normal.template lanes<W>(first);
    const Vec3T<F> ns = p.shading_normal.template lanes<W>(first);
    typename ShadowRays<W, K>::Lanes ray;
    ray.origin = p.origin.template lanes<W>(first);
    const PathNumbers<W> numbers{load<W>(&p.reversed_index[first]), load<W>(&p.path_key[first])};
    const auto u = numbersAt<W, K.split>(b, numbers, kLight);
    auto light = sampleLights<W, C>(b, stratum, ray.origin, ng, u(0), u(1), u(2), lanesOf(lanes));
    auto reached = dot(light.direction, ng) > 0.f;
    if constexpr (K.mixed)
      if (b.t.scene.still().shading().has(&BsdfTraits::transmits_rough)) {
        const LaneSet behind = lanesOf(lanes && light.pdf > 0.f && !reached);
        reached = reached || maskOf<W>(goThrough<W>(b, first, behind, ray.origin, light.segment));
      }
    lanes = lanes && light.pdf > 0.f && reached;
    const F cosine = dot(light.direction, ns);
    const auto f = evaluateLanes<W, K>(b, first, light.direction, ns, cosine, lanesOf(lanes));
    lanes = lanes && f.pdf > 0.f;
    if constexpr (K.split && !K.mixed)
      if (b.t.residual_only) lanes = lanes && light.closed_form == 0.f;
    ray.segment = light.segment, ray.reach = light.reach;
    ray.slot = load<W>(&p.slot[first]);
    ray.pdf_light = light.pdf, ray.pdf_bsdf = select(light.delta > 0.f, 0.f, f.pdf);
    const auto throughput = colorLanes<W>(p.throughput, first);
    for (int k = 0; k < C; ++k) ray.light[k] = throughput[k] * light.radiance[k] * f.value[k] / light.pdf;
    if constexpr (K.split) {
      ray.closed_form = light.closed_form;
      for (int k = 0; k < C; ++k)
        ray.unoccluded[k] = light.radiance[k] * light.closed_form * cosinePdf(cosine) / light.pdf;
      forEachLane(lanesOf(lanes), [&](int i) {
        for (int k = 0; k < C; ++k) b.results.unoccluded.of[k][ray.slot[i]] += ray.unoccluded[k][i];
      });
    }
    shadow_rays.add(lanesOf(lanes), ray);
  }
  shadow_rays.finish();
}

// K.split: of the first vertex, whose direct light is split.
template <int W, PathKind K>
void directLight(const Batch<K.channels>& b) {
  for (const Stratum stratum : {Stratum::kLamps, Stratum::kDistant})
    if (b.t.scene.lights().has(stratum, b.lightSet())) directLightOf<W, K>(b, stratum);
}

}  // namespace saccade
