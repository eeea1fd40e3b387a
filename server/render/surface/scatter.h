// How a surface scatters light, in world space: its BSDF and its mask.
#pragma once

#include <algorithm>

#include "render/bsdf/shading_frame.h"
#include "render/surface/surface.h"

namespace saccade {

template <Shading S>
class Scatter {
 public:
  // `arriving` is the unit direction of the ray that found `s`. Keeps a reference to `s`.
  Scatter(const Surface& s, Vec3 arriving)
      : s_(s), arriving_(arriving), frame_(kTransmits && s.inside ? -s.shading_normal : s.shading_normal) {
    if constexpr (!S.diffuseOnly()) {  // on the side of the geometric normal
      wo_ = frame_.toLocal(-arriving);
      wo_.z = s.inside ? std::min(wo_.z, -kGrazingCosine) : std::max(wo_.z, kGrazingCosine);
    }
  }

  // The value for light from the unit direction w.
  BsdfValue evaluate(Vec3 w) const {
    const Vec3 wi = frame_.toLocal(w);
    const float side = dot(w, s_.geometric_normal);
    if ((goesThrough(wi) ? -side : side) <= 0) return {};
    BsdfValue v = evaluateBsdf<S.kinds>(s_.bsdf, wo_, wi);
    if constexpr (S.extras) v.value = v.value * s_.opacity, v.pdf *= s_.opacity;
    return v;
  }

  // Samples a direction. `wi` is in world space.
  BsdfSample sample(float u_lobe, float u1, float u2) const {
    if constexpr (S.extras) {
      if (u_lobe >= s_.opacity) return {arriving_, {1, 1, 1}, 1 - s_.opacity, true, true};
      u_lobe = std::min(u_lobe / s_.opacity, 0x1.fffffep-1f);
    }
    BsdfSample next = sampleBsdf<S.kinds>(s_.bsdf, wo_, u_lobe, u1, u2);
    if constexpr (S.extras) next.pdf *= s_.opacity;
    next.wi = frame_.toWorld(next.wi);
    const float side = dot(next.wi, s_.geometric_normal);
    if ((next.transmitted ? -side : side) <= 0) next.weight = {}, next.pdf = 0;
    return next;
  }

  // The fraction of light that is reflected or transmitted, in all directions together.
  Rgb albedo() const {
    const Rgb a = bsdfAlbedo<S.kinds>(s_.bsdf, wo_.z);
    if constexpr (S.extras) return a * s_.opacity + Rgb{1, 1, 1} * (1 - s_.opacity);
    return a;
  }

  // Of its base, where it has one: the part of albedo() that is reflected alike into all directions.
  Rgb diffuseAlbedo() const { return bsdfDiffuseAlbedo<S.kinds>(s_.bsdf, wo_.z); }
  bool hasBase() const { return bsdfHasBase<S.kinds>(s_.bsdf); }
  bool isDiffuse() const { return traits().kind == BsdfKind::kDiffuse; }

  // The light that goes straight through. Panes and masks do not bend light, so that shadow rays go on behind
  // them.
  Transmittance straightTransmittance() const {
    if (!traits().transmits_straight) return {Rgb{1, 1, 1} * (1 - s_.opacity), 1 - s_.opacity};
    const Transmittance pane = ThinDielectric::straightTransmittance(s_.bsdf, wo_.z);
    return {Rgb{1, 1, 1} * (1 - s_.opacity) + pane.fraction * s_.opacity,
            1 - s_.opacity + pane.probability * s_.opacity};
  }
  // Whether a sample went straight through.
  bool isStraight(const BsdfSample& next) const {
    return next.transmitted && (!traits().transmits || traits().transmits_straight);
  }

  // Whether a sample is the direction that a viewer sees here: the likelier one of a mirror, of clear glass
  // or of a mask. If there is one, sample(0.5, ...) returns it.
  bool isView(const BsdfSample& next) const {
    return next.delta && next.pdf >= 0.5f && (traits().delta || next.transmitted);
  }

  // Whether a sample is what the surface mirrors beside its view: the coat of a plastic does, and clear
  // glass. If there is one, sample(0, ...) returns it.
  bool isImage(const BsdfSample& next) const { return next.delta && !next.transmitted && !isView(next); }

  // The normal of the mirror.
  Vec3 normal() const { return frame_.z; }

 private:
  // Whether light from wi is scattered through the surface.
  bool goesThrough(Vec3 wi) const {
    constexpr BsdfKinds kRough = kindsWith(&BsdfTraits::transmits_rough);
    if constexpr ((S.kinds & kRough) == 0) return false;
    return (kRough & only(s_.bsdf.tables->model.kind)) != 0 && wi.z * wo_.z < 0;
  }

  static constexpr bool kTransmits = S.has(&BsdfTraits::transmits);
  const BsdfTraits& traits() const {
    return traitsOf(S.diffuseOnly() ? BsdfKind::kDiffuse : s_.bsdf.tables->model.kind);
  }

  const Surface& s_;
  Vec3 arriving_;
  ShadingFrame<float> frame_;
  Vec3 wo_{0, 0, 1};  // diffuse surfaces do not use it
};

}  // namespace saccade
