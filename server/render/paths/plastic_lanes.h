// Rough plastics with GGX microfacets, as RoughPlastic has them, for W paths at once.
#pragma once

#include "render/bsdf/fresnel.h"
#include "render/bsdf/microfacet.h"
#include "render/paths/batch.h"

namespace saccade {

// f |cos| and pdf for a pair of directions.
template <int W, int C>
struct ScatteredLanes {
  std::array<Floats<W>, C> value;
  Floats<W> pdf;
};

template <int W, int C>
[[gnu::always_inline]] inline void mergeLanes(LaneSet lanes, const ScatteredLanes<W, C>& from,
                                              ScatteredLanes<W, C>& to) {
  const auto these = maskOf<W>(lanes);
  for (int k = 0; k < C; ++k) to.value[k] = select(these, from.value[k], to.value[k]);
  to.pdf = select(these, from.pdf, to.pdf);
}

template <int W, int C>
class PlasticLanes {
  using F = Floats<W>;

 public:
  // Those of the paths from `first` on whose state says so.
  PlasticLanes(const LivePaths<C>& paths, int first, const ShadingFrame<F>& frame, LaneSet lanes)
      : paths_(paths),
        first_(first),
        lanes_(lanes),
        wo_(frame.toLocal(-paths.arriving.template lanes<W>(first))) {
    wo_.z = max(wo_.z, F(kGrazingCosine));
    alpha_ = load<W>(&paths.plastic.alpha[first]);
  }

  // Directions are in the shading frame.
  Vec3T<F> sample(const F& u_lobe, const F& u1, const F& u2, const Vec3T<F>& diffuse) const {
    const Vec3T<F> m = sampleGgxNormal(alpha_, wo_, u1, u2);
    const Vec3T<F> reflected = m * F(2.f * dot(wo_, m)) - wo_;
    return selectLanes(u_lobe < plane(paths_.plastic.specular_probability), reflected, diffuse);
  }

  ScatteredLanes<W, C> evaluate(const Vec3T<F>& wi) const {
    const auto& p = paths_.plastic;
    const Vec3T<F> h = wo_ + wi;
    const Vec3T<F> m = h * F(1.f / max(F(1e-12f), sqrt(dot(h, h))));
    const F pdf_m = ggxDensity(alpha_, m) * ggxVisible(alpha_, wo_) / (4.f * wo_.z);
    const F cos_m = min(max(dot(wo_, m), F(0.f)), F(1.f));
    const F interface = pdf_m * ggxVisible(alpha_, wi) * fresnelDielectric(cos_m, plane(p.ior)).reflectance;
    const F cosine = cosinePdf(wi.z);
    const F base = plane(p.transmittance) * transmittance(wi.z) * cosine;
    const F probability = plane(p.specular_probability);
    const auto above = wi.z > 0.f;
    ScatteredLanes<W, C> f;
    f.pdf = select(above, F(probability * pdf_m + (1.f - probability) * cosine), 0.f);
    for (int k = 0; k < C; ++k)
      f.value[k] =
          select(above, F(plane(p.specular.of[k]) * interface + plane(paths_.reflectance.of[k]) * base), 0.f);
    return f;
  }

 private:
  F plane(const Plane& of) const { return load<W>(&of[first_]); }

  // BsdfTables::transmittance of each path's material.
  F transmittance(const F& cosine) const {
    constexpr int kSize = CosineTable<float>::kSize;
    const F x = sqrt(min(max(cosine, F(0.f)), F(1.f))) * float(kSize - 1);
    const F low = min(floor(x), F(kSize - 2));
    alignas(64) std::uint32_t at[W];
    alignas(64) float values[2][W] = {};
    store(toUints(low), at);
    forEachLane(lanes_, [&](int i) {
      const auto path = static_cast<std::size_t>(first_ + i);
      const auto& table = paths_.surfaces[path].bsdf.tables->transmittance.values();
      values[0][i] = table[at[i]], values[1][i] = table[at[i] + 1];
    });
    const F w = x - low;
    return load<W>(values[0]) * (1.f - w) + load<W>(values[1]) * w;
  }

  const LivePaths<C>& paths_;
  int first_;
  LaneSet lanes_;
  Vec3T<F> wo_;
  F alpha_;
};

}  // namespace saccade
