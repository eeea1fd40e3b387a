// A sample of the lights for each of W paths.
#pragma once

#include "render/paths/batch.h"
#include "render/sampling/path_numbers.h"

namespace saccade {

// As IncidentLight.
template <int W, int C>
struct LightSamples {
  Vec3T<Floats<W>> direction, segment;
  Floats<W> reach, pdf;
  std::array<Floats<W>, C> radiance;  // at the strength of this time
  Floats<W> delta, closed_form;       // 1 or 0; closed_form: AnalyticLight::holds()
};

// As ChosenLamp.
template <int W>
struct ChosenLamps {
  Uints<W> number;
  Floats<W> pdf;
};

template <int W, int C>
[[gnu::noinline]] ChosenLamps<W> chooseFromTree(const Batch<C>& b, const Vec3T<Floats<W>>& point,
                                                const Vec3T<Floats<W>>& normal, const Floats<W>& u_lamp,
                                                LaneSet lanes) {
  LaneVectors points, normals;
  points.store(point, 0), normals.store(normal, 0);
  alignas(64) float u[kLaneVectors] = {};
  store(u_lamp, u);
  const Lamps::ChosenLanes chosen =
      b.t.scene.lights().lamps().chooseFromTree(b.lightSet(), points, normals, u, lanes);
  return {load<W>(chosen.number), load<W>(chosen.pdf)};
}

template <int W, int C>
[[gnu::always_inline]] inline ChosenLamps<W> chooseLamps(const Batch<C>& b, const Vec3T<Floats<W>>& point,
                                                         const Vec3T<Floats<W>>& normal,
                                                         const Floats<W>& u_lamp, LaneSet lanes) {
  if (b.t.scene.lights().lamps().hasTree(b.lightSet()))
    return chooseFromTree<W, C>(b, point, normal, u_lamp, lanes);
  const LightColumns& columns = b.t.scene.lightColumns();
  const Uints<W> number = columns.choose<W>(b.lightSet(), u_lamp);
  return {number, columns.at<W>(columns.pdfColumn(b.lightSet()), number)};
}

// Uniform points on triangles, by the square-root map.
template <int W, int C>
[[gnu::always_inline]] inline LightSamples<W, C> sampleTriangles(const Batch<C>& b,
                                                                 const ChosenLamps<W>& lamps,
                                                                 const Vec3T<Floats<W>>& point,
                                                                 const Floats<W>& u1, const Floats<W>& u2) {
  using F = Floats<W>;
  using Columns = LightColumns;
  const LightColumns& lights = b.t.scene.lightColumns();
  const EmitterStrengths& strengths = b.t.scene.strengths();
  const Uints<W>& chosen = lamps.number;
  LightSamples<W, C> light;
  const F s = sqrt(u1);
  const Vec3T<F> on_light = lights.vectorAt<W>(Columns::kCornerX, chosen) +
                            lights.vectorAt<W>(Columns::kEdge1X, chosen) * F(1.f - s) +
                            lights.vectorAt<W>(Columns::kEdge2X, chosen) * F(u2 * s);
  light.segment = on_light - point;
  const F distance2 = dot(light.segment, light.segment);
  light.direction = light.segment * F(1.f / sqrt(distance2));
  const F cosine = -dot(light.direction, lights.vectorAt<W>(Columns::kNormalX, chosen));
  light.pdf = select(cosine > 0.f, lamps.pdf * distance2 / cosine, 0.f);
  light.reach = kShadowEnd;
  light.delta = 0.f;
  light.closed_form = lights.at<W>(Columns::kClosedForm, chosen);
  F strength = 1.f;
  if (!strengths.areSteady())
    strength = gather(strengths.factors().data(), toUints(lights.at<W>(Columns::kGeometry, chosen)));
  for (int k = 0; k < C; ++k)
    light.radiance[k] =
        lights.at<W>(C == 1 ? Columns::kLuminance : Columns::Column(Columns::kRed + k), chosen) * strength;
  return light;
}

// Takes the samples of `lanes` from sample(lane).
template <int W, int C>
void sampleOneByOne(const Batch<C>& b, LaneSet lanes, const auto& sample, LightSamples<W, C>& light) {
  forEachLane(lanes, [&](int i) {
    const IncidentLight one = sample(i);
    setLane(light.direction, i, one.direction);
    setLane(light.segment, i, one.segment);
    const float strength =
        one.geometry == IncidentLight::kNoGeometry ? 1 : b.t.scene.strengths()[one.geometry];
    setLane(light.radiance, i, Color<C>(one.radiance) * strength);
    light.reach[i] = one.reach, light.pdf[i] = one.pdf;
    light.delta[i] = one.delta ? 1.f : 0.f;
    light.closed_form[i] = b.t.scene.analyticLight().holds(one.geometry) ? 1.f : 0.f;
  });
}

// Samples of a stratum. Those of triangles are taken together.
template <int W, int C>
[[gnu::always_inline]] inline LightSamples<W, C> sampleLights(const Batch<C>& b, Stratum stratum,
                                                              const Vec3T<Floats<W>>& point,
                                                              const Vec3T<Floats<W>>& normal,
                                                              const Floats<W>& u_light, const Floats<W>& u1,
                                                              const Floats<W>& u2, LaneSet lanes) {
  const PosedScene& scene = b.t.scene;
  LightSamples<W, C> light;
  if (stratum == Stratum::kDistant) {
    sampleOneByOne<W, C>(
        b, lanes,
        [&](int i) {
          return scene.lights().sample(stratum, b.lightSet(), {laneOf(point, i), laneOf(normal, i)},
                                       u_light[i], u1[i], u2[i]);
        },
        light);
    return light;
  }
  const LightColumns& columns = scene.lightColumns();
  const ChosenLamps<W> chosen = chooseLamps<W, C>(b, point, normal, u_light, lanes);
  light = sampleTriangles<W, C>(b, chosen, point, u1, u2);
  if (columns.allTriangles()) return light;
  sampleOneByOne<W, C>(
      b, lanes & lanesOf(columns.at<W>(LightColumns::kTriangle, chosen.number) == 0.f),
      [&](int i) {
        return scene.lights().lamps().sample({chosen.number[i], chosen.pdf[i]}, laneOf(point, i), u1[i],
                                             u2[i]);
      },
      light);
  return light;
}

}  // namespace saccade
