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

// Uniform points on triangles, by the square-root map.
template <int W, int C>
[[gnu::always_inline]] inline LightSamples<W, C> sampleTriangles(const LightColumns& lights,
                                                                 const Uints<W>& chosen,
                                                                 const EmitterStrengths& strengths,
                                                                 const Vec3T<Floats<W>>& point,
                                                                 const Floats<W>& u1, const Floats<W>& u2) {
  using F = Floats<W>;
  using Columns = LightColumns;
  LightSamples<W, C> light;
  const F s = sqrt(u1);
  const Vec3T<F> on_light = lights.vectorAt<W>(Columns::kCornerX, chosen) +
                            lights.vectorAt<W>(Columns::kEdge1X, chosen) * F(1.f - s) +
                            lights.vectorAt<W>(Columns::kEdge2X, chosen) * F(u2 * s);
  light.segment = on_light - point;
  const F distance2 = dot(light.segment, light.segment);
  light.direction = light.segment * F(1.f / sqrt(distance2));
  const F cosine = -dot(light.direction, lights.vectorAt<W>(Columns::kNormalX, chosen));
  light.pdf = select(cosine > 0.f, lights.at<W>(Columns::kPdf, chosen) * distance2 / cosine, 0.f);
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

// Samples of the lights. Those of other kinds are taken one by one.
template <int W, int C>
[[gnu::always_inline]] inline LightSamples<W, C> sampleLights(const Tracing& t, const Vec3T<Floats<W>>& point,
                                                              const Floats<W>& u_light, const Floats<W>& u1,
                                                              const Floats<W>& u2, LaneSet lanes) {
  const LightColumns& columns = t.scene.still().lightColumns();
  const Uints<W> chosen = columns.choose<W>(u_light);
  LightSamples<W, C> light = sampleTriangles<W, C>(columns, chosen, t.scene.strengths(), point, u1, u2);
  if (columns.allTriangles()) return light;
  const LaneSet others = lanesOf(columns.at<W>(LightColumns::kTriangle, chosen) == 0.f) & lanes;
  forEachLane(others, [&](int i) {
    const IncidentLight one = t.scene.still().lights().at(laneOf(point, i), u_light[i], u1[i], u2[i]);
    setLane(light.direction, i, one.direction);
    setLane(light.segment, i, one.segment);
    const float strength = one.geometry == IncidentLight::kNoGeometry ? 1 : t.scene.strengths()[one.geometry];
    setLane(light.radiance, i, Color<C>(one.radiance) * strength);
    light.reach[i] = one.reach, light.pdf[i] = one.pdf;
    light.delta[i] = one.delta ? 1.f : 0.f;
    light.closed_form[i] = t.scene.still().analyticLight().holds(one.geometry) ? 1.f : 0.f;
  });
  return light;
}

}  // namespace saccade
