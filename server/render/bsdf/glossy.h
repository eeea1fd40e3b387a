// A diffuse base and a lobe of gloss beside it, as in phong and ward of Mitsuba 0.6:
//   f = a / pi + s L(wo, wi),   a = min(diffuse, 1 - s).
// A lobe L reflects no more than it gets, so that the surface does not either, whatever its textures say.
#pragma once

#include "render/bsdf/bsdf_record.h"
#include "render/bsdf/gloss_lobes.h"

namespace saccade {

template <BsdfKind Kind, class Lobe>
struct Glossy {
  static constexpr BsdfKind kKind = Kind;

  static BsdfValue evaluate(const Bsdf& b, Vec3 wo, Vec3 wi) {
    if (!(wo.z > 0 && wi.z > 0)) return {};
    const GlossValue gloss = Lobe::at(b.tables->model.alpha, wo, wi);
    const float p = glossProbability(b, wo.z), cosine = cosinePdf(wi.z);
    return {base(b) * cosine + b.specular * gloss.value, p * gloss.pdf + (1 - p) * cosine};
  }
  static BsdfSample sample(const Bsdf& b, Vec3 wo, float u_lobe, float u1, float u2) {
    const bool gloss = u_lobe < glossProbability(b, wo.z);
    const Vec3 wi = gloss ? Lobe::sample(b.tables->model.alpha, wo, u1, u2) : cosineHemisphere(u1, u2);
    return weigh(wi, evaluate(b, wo, wi));
  }
  static Rgb albedo(const Bsdf& b, float cos_o) {
    return cos_o > 0 ? base(b) + b.specular * b.tables->reflectance(cos_o) : Rgb{};
  }
  static Rgb diffuseAlbedo(const Bsdf& b, float cos_o) { return cos_o > 0 ? base(b) : Rgb{}; }

 private:
  static Rgb base(const Bsdf& b) {
    const auto part = [](float a, float s) { return std::min(a, 1 - s); };
    return {part(b.diffuse.x, b.specular.x), part(b.diffuse.y, b.specular.y),
            part(b.diffuse.z, b.specular.z)};
  }
  static float glossProbability(const Bsdf& b, float cos_o) {
    return lobeProbability(luminance(b.specular) * b.tables->reflectance(cos_o).x, luminance(base(b)));
  }
};

using Phong = Glossy<BsdfKind::kPhong, PhongLobe>;
using Ward = Glossy<BsdfKind::kWard, WardLobe>;

}  // namespace saccade
