#include "render/bsdf/schlick_tables.h"

#include "render/bsdf/microfacet_mean.h"

namespace saccade {
namespace {

float fifthPower(float x) {
  return x * x * x * x * x;
}

// E[F G1], apart for F0 and F90.
SchlickAlbedo reflected(float alpha, float cos_o) {
  const Microfacets f{MicrofacetKind::kGgx, std::max(alpha, kLeastAlpha)};
  return meanOverNormals(f, cos_o, [&](Vec3 wo, Vec3 m) {
    const Vec3 wi = mirror(wo, m);
    const float left = wi.z > 0 ? visibleFraction(f, wi) : 0;
    const float grazing = fifthPower(1 - std::clamp(dot(wo, m), 0.f, 1.f));
    return SchlickAlbedo{left * (1 - grazing), left * grazing};
  });
}

}  // namespace

SchlickTables::SchlickTables() {
  constexpr int kSteps = 256;
  for (int i = 0; i < kSize; ++i) {
    const float roughness = static_cast<float>(i) / (kSize - 1), alpha = roughness * roughness;
    for (int j = 0; j < kSize; ++j) {
      const float root = std::max(0.01f, static_cast<float>(j) / (kSize - 1));
      values_[i][j] = reflected(alpha, root * root);
    }
  }
  for (int i = 0; i < kSize; ++i) {
    const float roughness = static_cast<float>(i) / (kSize - 1);
    for (int j = 0; j < kSteps; ++j) {
      const float root = (static_cast<float>(j) + 0.5f) / kSteps, cosine = root * root;
      means_[i] = means_[i] + at(roughness * roughness, cosine) * (cosine * 4 * root / kSteps);
    }
  }
}

const SchlickTables& schlickTables() {
  static const SchlickTables tables;
  return tables;
}

}  // namespace saccade
