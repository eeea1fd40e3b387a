// The stages that go path by path. For kernel.h.
#pragma once

#include "render/paths/found_light.h"
#include "render/paths/surface_stages.h"

namespace saccade {
namespace detail {

inline ShadedAs shadedAs(const Surface& s) {
  const BsdfModel& m = s.bsdf.tables->model;
  if (s.opacity < 1) return ShadedAs::kOther;
  if (m.kind == BsdfKind::kDiffuse) return ShadedAs::kDiffuse;
  const bool ggx = m.kind == BsdfKind::kRoughPlastic && m.microfacets == MicrofacetKind::kGgx;
  return ggx ? ShadedAs::kPlastic : ShadedAs::kOther;
}

template <int C>
void putPlastic(const Surface& s, Vec3 arriving, std::uint32_t i, LivePaths<C>& to) {
  const Bsdf& b = s.bsdf;
  const Interface o = RoughPlastic::at(b, std::max(-dot(arriving, s.shading_normal), kGrazingCosine));
  to.reflectance.set(i, Color<C>(plasticBase(b)));
  to.plastic.specular.set(i, Color<C>(b.specular));
  to.plastic.alpha[i] = b.tables->model.alpha, to.plastic.ior[i] = b.tables->model.ior;
  to.plastic.transmittance[i] = o.transmittance / b.tables->mean_transmittance;
  to.plastic.specular_probability[i] = specularProbability(b, o);
}

template <Shading S, int C>
void put(const Surface& s, Vec3 arriving, RayCone cone, const PathSampler& sampler, std::uint32_t slot,
         Color<C> throughput, LivePaths<C>& to) {
  const auto i = static_cast<std::uint32_t>(to.count++);
  to.origin.set(i, leave(s));
  to.geometric_normal.set(i, s.geometric_normal);
  to.shading_normal.set(i, s.shading_normal);
  to.reflectance.set(i, Color<C>(s.bsdf.diffuse));
  to.throughput.set(i, throughput);
  to.width[i] = cone.width, to.spread[i] = cone.spread;
  to.reversed_index[i] = sampler.reversed_index, to.path_key[i] = sampler.key;
  to.slot[i] = slot;
  if constexpr (S.extras) {
    to.arriving.set(i, arriving), to.surfaces[i] = s;
    if (shadedAs(s) == ShadedAs::kPlastic) putPlastic(s, arriving, i, to);
  }
}

template <Shading S, int C>
void begin(const PathStart& start, const PathSampler& sampler, std::uint32_t slot, LivePaths<C>& to) {
  const auto i = static_cast<std::uint32_t>(to.count);
  put<S>(start.surface, start.direction, start.cone, sampler, slot, Color<C>(1.f), to);
  if constexpr (S.extras) {
    to.state[i] = PathState{0, true, true, true, false, shadedAs(start.surface)}.pack();
    to.pdf[i] = 1, to.distance[i] = 0;
  }
}

template <Shading S, int C, bool kSplit>
void shadeHit(const Tracing& t, int vertex, const LivePaths<C>& from, std::uint32_t i, const PathHit& at,
              LivePaths<C>& to, PathResults<C>& results) {
  const std::uint32_t slot = from.slot[i];
  Color<C> throughput = from.throughput.at(i);
  PathState state = PathState::unpack(from.state[i]);
  if (!at.hit.valid) {
    if (state.in_view) return;
    const DistantLights& lights = t.scene.lights().distant();
    const float pdf_light = lights.pdf(t.lightsOf(state.from_start), at.direction);
    const float weight = state.delta ? 1 : balance(from.pdf[i], pdf_light);
    results.radiance.add(slot, throughput * Color<C>(lights.radiance(at.direction)) * weight);
    return;
  }
  const RayCone cone{from.width[i] + from.spread[i] * at.hit.t, from.spread[i]};
  const Surface s = surfaceOf<S>(t.scene, at.hit, at.patch, at.normal, at.cosine, cone.width);
  const float distance = at.hit.t + from.distance[i];
  if (luminance(s.radiance) > 0 && !state.in_view) {
    const Found found{slot,
                      {at.hit.geometry, at.hit.primitive, s.radiance, distance, at.cosine},
                      chooserOf<true>(from, i, s.point, at.direction, distance)};
    addFound<C, kSplit>(t, found, throughput, state.delta ? kDeltaPdf : from.pdf[i], state.from_start,
                        results);
  }
  if (state.bounces > t.bounces && !t.scene.still().hasStraightTransmission()) return;
  if (vertex >= t.bounces + kMaxDeltas) return;
  const PathSampler sampler(from.reversed_index[i], from.path_key[i]);
  if constexpr (kSplit) {
    const Scatter<S> scatter(s, at.direction);
    if (vertex == 0 && !state.delta_last && scatter.hasBase() && s.opacity >= 1 &&
        endsAtKnownLight<C>(t, {s.point, s.geometric_normal, scatter.albedo(), cone.width}, sampler, slot,
                            throughput, results))
      return;
  }
  const auto j = static_cast<std::uint32_t>(to.count);
  state.surface = shadedAs(s);
  to.state[j] = state.pack(), to.pdf[j] = from.pdf[i], to.distance[j] = distance;
  if (t.scene.lights().lamps().hasTree(LightSet::kAll))
    to.chooser_normal.set(j, chooserOf<true>(from, i, s.point, at.direction, distance).normal);
  put<S>(s, at.direction, cone, sampler, slot, throughput, to);
}

template <Shading S, int C>
ScatteredRay sampleBsdf(const Tracing& t, int vertex, LivePaths<C>& paths, std::uint32_t i) {
  const Surface& s = paths.surfaces[i];
  PathState state = PathState::unpack(paths.state[i]);
  const PathSampler sampler(paths.reversed_index[i], paths.path_key[i]);
  const std::uint32_t dimension = static_cast<std::uint32_t>(vertex) * kDimensions;
  const Scatter<S> scatter(s, paths.arriving.at(i));
  const BsdfSample next = scatter.sample(sampler.u(dimension + kLobe), sampler.u(dimension + kBounce),
                                         sampler.u(dimension + kBounce + 1));
  const Color<C> throughput = paths.throughput.at(i) * Color<C>(next.weight);
  if (next.pdf <= 0 || throughput.luminance() <= 0) return {};
  const bool straight = scatter.isStraight(next);
  if (!straight && state.bounces > t.bounces) return {};
  if (straight)
    paths.pdf[i] *= scatter.straightTransmittance().probability;
  else
    paths.pdf[i] = next.pdf, paths.distance[i] = 0, state.delta = next.delta, state.from_start = vertex == 0;
  const bool image = t.images_apart && vertex == 0 && scatter.isImage(next);
  state.in_view = state.in_view && vertex < kMaxViewDepth && (image || scatter.isView(next));
  state.delta_last = next.delta;
  state.bounces += !next.delta;
  if (!next.delta) paths.spread[i] = RayCone::lobeSpread(next.pdf);
  paths.state[i] = state.pack();
  paths.throughput.set(i, throughput);
  return {leave(s, next.transmitted), next.wi, true};
}

template <Shading S, int C>
BsdfValue evaluate(const LivePaths<C>& paths, std::uint32_t i, Vec3 direction) {
  return Scatter<S>(paths.surfaces[i], paths.arriving.at(i)).evaluate(direction);
}

template <Shading S>
Transmittance transmit(const Tracing& t, const Ray& shadow, const Hit& first) {
  constexpr int kMaxTransmissions = 16;
  Transmittance all;
  const Vec3 direction = normalize(shadow.direction);
  Ray ray = shadow;
  Hit hit = first;
  for (int i = 0; hit.valid; hit = t.scene.straight().intersect(ray), ++i) {
    if (i == kMaxTransmissions) return {{}, 0};
    const Surface s = surfaceAt<S>(t.scene, ray, hit, RayCone::kDiffuseSpread * hit.t);
    const Transmittance one = Scatter<S>(s, direction).straightTransmittance();
    all = {all.fraction * one.fraction, all.probability * one.probability};
    if (luminance(all.fraction) <= 0) return {{}, 0};
    ray.origin = leave(s, true);
    ray.tfar -= hit.t;
  }
  return all;
}

}  // namespace detail

template <Shading S, int C, bool kSplit>
SurfaceStages<C> surfaceStages() {
  SurfaceStages<C> stages{detail::begin<S, C>, nullptr, nullptr, nullptr, nullptr};
  if constexpr (S.extras) {
    stages.shadeHit = detail::shadeHit<S, C, kSplit>;
    stages.sampleBsdf = detail::sampleBsdf<S, C>;
    stages.evaluate = detail::evaluate<S, C>;
    stages.transmit = detail::transmit<S>;
  }
  return stages;
}

}  // namespace saccade
