#include "render/bsdf/bsdf_tables.h"

#include "render/bsdf/coated_conductor.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/gloss_lobes.h"
#include "render/bsdf/microfacet_mean.h"

namespace saccade {
namespace {

constexpr int kCosines = 256;

// The fraction of light from cosine cos_o that rough plastic or metal reflects: E[F G1].
template <class Fresnel>
Rgb roughReflectance(const Microfacets& f, float cos_o, Fresnel fresnel) {
  return meanOverNormals(f, cos_o, [&](Vec3 wo, Vec3 m) {
    const Vec3 wi = mirror(wo, m);
    return fresnel(dot(wo, m)) * (wi.z > 0 ? visibleFraction(f, wi) : 0);
  });
}

// The fraction of light that a rough dielectric transmits: E[(1 - F) G1] [Walter 2007 (21)].
float roughTransmittance(const Microfacets& f, float cos_o, float ior) {
  return meanOverNormals(f, cos_o, [&](Vec3 wo, Vec3 m) {
    const float cos_m = dot(wo, m);
    const Refraction r = fresnelDielectric(cos_m, ior);
    const Vec3 wt = m * (cos_m / ior - r.cos_t) - wo / ior;
    return wt.z < 0 ? (1 - r.reflectance) * visibleFraction(f, wt) : 0;
  });
}

// The fraction of light that a rough metal returns through its coat, once it has entered from cosine cos_o:
// E[F G1 T(i)]. It has an edge where the coat lets nothing out.
Rgb coatedReflectance(const BsdfTables& t, float cos_o) {
  const BsdfModel& m = t.model;
  const Microfacets metal{m.microfacets, m.alpha};
  const auto at = [&](Vec3 wo, Vec3 facet) {
    const Vec3 wi = mirror(wo, facet), outside = leaveCoat(wi, m.coat_ior);
    if (!(outside.z > 0)) return Rgb{};
    return fresnelConductor(dot(wo, facet), m.eta, m.k) *
           (visibleFraction(metal, wi) * coatTransmittance(t, outside.z));
  };
  const Vec3 entered = enterCoat({std::sqrt(1 - cos_o * cos_o), 0, cos_o}, m.coat_ior);
  return latticeMeanOverNormals(metal, entered.z, at);
}

// f cos_i / pdf of a lobe of gloss that is sampled by itself.
template <class Lobe>
float glossWeight(float alpha, Vec3 wo, Vec3 wi) {
  const GlossValue gloss = wi.z > 0 ? Lobe::at(alpha, wo, wi) : GlossValue{};
  return gloss.pdf > 0 ? gloss.value / gloss.pdf : 0;
}

// The fraction of light from cosine cos_o that a white lobe reflects.
float phongReflectance(float alpha, float cos_o) {
  constexpr int kSteps = 48;  // per dimension
  const Vec3 wo{std::sqrt(1 - cos_o * cos_o), 0, cos_o};
  const auto node = [](int i) { return (static_cast<float>(i) + 0.5f) / kSteps; };
  float sum = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j)
      sum += glossWeight<PhongLobe>(alpha, wo, PhongLobe::sample(alpha, wo, node(i), node(j)));
  return sum / (kSteps * kSteps);
}
float wardReflectance(float alpha, float cos_o) {
  return meanOverNormals({MicrofacetKind::kBeckmann, alpha}, cos_o,
                         [&](Vec3 wo, Vec3 m) { return glossWeight<WardLobe>(alpha, wo, mirror(wo, m)); });
}

// 2 int_0^1 at(c) c dc, over the square root of c.
template <class Function>
float cosineWeightedMean(Function at) {
  float sum = 0;
  for (int i = 0; i < kCosines; ++i) {
    const float root = (static_cast<float>(i) + 0.5f) / kCosines, c = root * root;
    sum += at(c) * c * 4 * root;
  }
  return sum / kCosines;
}

}  // namespace

BsdfTables::BsdfTables(const BsdfModel& m) : model(m) {
  model.alpha = std::max(m.alpha, kLeastAlpha);
  const Microfacets f{m.microfacets, model.alpha};
  const auto dielectric = [&](float cosine) { return fresnelDielectric(cosine, m.ior).reflectance; };
  if (m.kind == BsdfKind::kRoughConductor) {
    const auto conductor = [&](float cosine) { return fresnelConductor(cosine, m.eta, m.k); };
    reflectance.fill([&](float cos_o) { return roughReflectance(f, cos_o, conductor); });
  }
  if (m.kind == BsdfKind::kRoughPlastic || m.kind == BsdfKind::kRoughDielectric) {
    const auto grey = [&](float cosine) { return Rgb{1, 1, 1} * dielectric(cosine); };
    reflectance.fill([&](float cos_o) { return roughReflectance(f, cos_o, grey); });
    transmittance.fill([&](float cos_o) { return roughTransmittance(f, cos_o, m.ior); });
    mean_transmittance = cosineWeightedMean(transmittance);
  }
  if (m.kind == BsdfKind::kRoughDielectric) {
    const auto inner = [&](float cosine) {
      return Rgb{1, 1, 1} * fresnelDielectric(cosine, 1 / m.ior).reflectance;
    };
    inner_reflectance.fill([&](float cos_o) { return roughReflectance(f, cos_o, inner).x; });
    inner_transmittance.fill([&](float cos_o) { return roughTransmittance(f, cos_o, 1 / m.ior); });
  }
  if (m.kind == BsdfKind::kCoatedConductor) fillCoated();
  if (m.kind == BsdfKind::kPhong)
    reflectance.fill([&](float cos_o) { return Rgb{1, 1, 1} * phongReflectance(model.alpha, cos_o); });
  if (m.kind == BsdfKind::kWard)
    reflectance.fill([&](float cos_o) { return Rgb{1, 1, 1} * wardReflectance(model.alpha, cos_o); });
  if (m.kind == BsdfKind::kPlastic)
    mean_transmittance = cosineWeightedMean([&](float cosine) { return 1 - dielectric(cosine); });
  if (m.kind == BsdfKind::kMetallicRoughness) {
    dielectric_reflectance = dielectric(1);
    schlick = &schlickTables();
  }
  // An interface transmits as much light inwards as outwards [Walter 2007, reciprocity]. It reflects the
  // rest.
  internal_reflectance = 1 - mean_transmittance / (m.ior * m.ior);
}

void BsdfTables::fillCoated() {
  if (model.coat_alpha > 0) {
    model.coat_alpha = std::max(model.coat_alpha, kLeastAlpha);
    const Microfacets coat{model.coat_microfacets, model.coat_alpha};
    const auto grey = [&](float cosine) {
      return Rgb{1, 1, 1} * fresnelDielectric(cosine, model.coat_ior).reflectance;
    };
    coat_reflectance.fill([&](float cos_o) { return roughReflectance(coat, cos_o, grey).x; });
    transmittance.fill([&](float cos_o) { return roughTransmittance(coat, cos_o, model.coat_ior); });
  }
  reflectance.fill([&](float cos_o) { return coatedReflectance(*this, cos_o); });
}

}  // namespace saccade
