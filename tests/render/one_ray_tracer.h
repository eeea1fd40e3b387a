// The plain path tracer, one ray at a time: what the stages of render/paths must find, path by path.
#pragma once

#include <limits>

#include "render/paths/tracing.h"
#include "render/sampling/path_sampler.h"
#include "render/surface/path_start.h"
#include "render/surface/scatter.h"
#include "render/world/surface_at.h"

namespace saccade::test {

// The light that panes and masks let through along a shadow ray.
template <Shading S>
Transmittance transmittanceAlong(const PosedScene& scene, Ray ray, Vec3 direction) {
  RayPacket<8> packet(kBlockingMask);
  packet.set(0, ray);
  scene.still().geometry().occluded(packet, LaneSet::first(1));
  if (packet.far[0] < 0) return {{}, 0};
  Transmittance all;
  for (Hit hit; (hit = scene.still().straight().intersect(ray)).valid;) {
    const Surface s = surfaceAt<S>(scene, ray, hit, RayCone::kDiffuseSpread * hit.t);
    const Transmittance one = Scatter<S>(s, direction).straightTransmittance();
    all = {all.fraction * one.fraction, all.probability * one.probability};
    ray.origin = leave(s, true);
    ray.tfar -= hit.t;
  }
  return all;
}

template <Shading S, int C>
Color<C> directLightOf(Stratum stratum, LightSet set, const PosedScene& scene, const Surface& s,
                       const Scatter<S>& scatter, const PathSampler& sampler, std::uint32_t dimension) {
  const Vec3 origin = leave(s);
  const IncidentLight light =
      scene.still().lights().sample(stratum, set, {origin, s.geometric_normal}, sampler.u(dimension),
                                    sampler.u(dimension + 1), sampler.u(dimension + 2));
  if (light.pdf <= 0) return {};
  BsdfValue f = scatter.evaluate(light.direction);
  if (f.pdf <= 0) return {};
  const Transmittance through =
      transmittanceAlong<S>(scene, {origin, light.segment, light.reach}, light.direction);
  f = {f.value * through.fraction, f.pdf * through.probability};
  float weight = light.delta ? 1 : balance(light.pdf, f.pdf);
  if (light.geometry != IncidentLight::kNoGeometry) weight *= scene.strengths()[light.geometry];
  return Color<C>(light.radiance) * Color<C>(f.value) * (weight / light.pdf);
}

template <Shading S, int C>
Color<C> directLight(LightSet set, const PosedScene& scene, const Surface& s, const Scatter<S>& scatter,
                     const PathSampler& sampler, std::uint32_t dimension) {
  Color<C> sum;
  for (const Stratum stratum : {Stratum::kLamps, Stratum::kDistant})
    if (scene.still().lights().has(stratum, set))
      sum += directLightOf<S, C>(stratum, set, scene, s, scatter, sampler, dimension);
  return sum;
}

template <Shading S, int C>
Color<C> traceOneRay(const Tracing& t, const PathStart& start, const PathSampler& sampler) {
  const PosedScene& scene = t.scene;
  const int bounces = t.bounces;
  Color<C> radiance, throughput(1.f);
  const Lights& lights = scene.still().lights();
  Surface s = start.surface;
  Vec3 arriving = start.direction;
  RayCone cone = start.cone;
  float pdf = 1, distance = 0;    // of the last direction that was not straight on, and since then
  Receiver chooser{};             // the vertex that chose it
  LightSet set = LightSet::kAll;  // that the vertex sampled which chose it
  bool delta = true, in_view = S.extras;
  const bool transmission = S.extras && scene.still().hasStraightTransmission();
  for (int vertex = 0, bounce = 0; vertex <= bounces + kMaxDeltas; ++vertex) {
    const std::uint32_t dimension = static_cast<std::uint32_t>(vertex) * kDimensions;
    const Scatter<S> scatter(s, arriving);
    const bool spent = transmission && bounce > bounces;
    if (!spent)
      radiance += throughput *
                  directLight<S, C>(t.lightsOf(vertex == 0), scene, s, scatter, sampler, dimension + kLight);
    const BsdfSample next = scatter.sample(sampler.u(dimension + kLobe), sampler.u(dimension + kBounce),
                                           sampler.u(dimension + kBounce + 1));
    throughput = throughput * Color<C>(next.weight);
    if (next.pdf <= 0 || throughput.luminance() <= 0) return radiance;
    const bool straight = S.extras && scatter.isStraight(next);
    if (spent && !straight) return radiance;
    if (straight)
      pdf *= scatter.straightTransmittance().probability;
    else
      pdf = next.pdf, delta = next.delta, distance = 0, set = t.lightsOf(vertex == 0),
      chooser = {leave(s, next.transmitted), s.geometric_normal};
    const bool image = t.images_apart && vertex == 0 && scatter.isImage(next);
    in_view = in_view && vertex < kMaxViewDepth && (image || scatter.isView(next));
    if (!next.delta) cone.spread = RayCone::lobeSpread(next.pdf);
    const Ray ray{leave(s, next.transmitted), next.wi, std::numeric_limits<float>::infinity()};
    bounce += !next.delta;
    const bool last = bounce > bounces && !transmission;  // it can only find light
    if (last && !scene.still().lightMayBeAnywhere() && !scene.still().emitters().occluded(ray))
      return radiance;
    const Hit hit = scene.still().geometry().intersect(ray);
    if (!hit.valid) {
      if (in_view) return radiance;
      const float weight = delta ? 1 : balance(pdf, lights.distant().pdf(set, next.wi));
      return radiance += throughput * Color<C>(lights.distant().radiance(next.wi)) * weight;
    }
    cone.width = cone.at(hit.t);
    s = surfaceAt<S>(scene, ray, hit, cone.width);
    arriving = next.wi;
    distance += hit.t;
    if (luminance(s.radiance) > 0 && !in_view) {
      const float cos_light = -dot(next.wi, s.geometric_normal);
      const float pdf_light =
          lights.lamps().pdf(set, {hit.geometry, hit.primitive, s.radiance, distance, cos_light}, chooser);
      const float weight = delta ? 1 : balance(pdf, pdf_light);
      radiance += throughput * Color<C>(s.radiance) * (weight * scene.strengths()[hit.geometry]);
    }
    if (last) return radiance;
  }
  return radiance;
}

}  // namespace saccade::test
