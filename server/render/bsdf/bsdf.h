// BSDFs: free functions over plain records. A kernel is compiled for the set of kinds that its scene has, and
// pays for no other: of a scene that is all diffuse, not even the kind is looked at.
#pragma once

#include "render/bsdf/conductor.h"
#include "render/bsdf/dielectric.h"
#include "render/bsdf/diffuse.h"
#include "render/bsdf/plastic.h"

namespace saccade {

using BsdfKinds = unsigned;  // a bit for each kind

constexpr BsdfKinds only(BsdfKind kind) {
  return 1u << static_cast<unsigned>(kind);
}

namespace detail {

// call(Family()) of the family that b's kind names, among those in Kinds.
template <BsdfKinds Kinds, class Family, class... Others, class Call>
auto visitFamily(const Bsdf& b, Call call) {
  constexpr BsdfKinds kOthers = Kinds & (only(Others::kKind) | ... | 0u);
  if constexpr ((Kinds & only(Family::kKind)) == 0) {
    return visitFamily<Kinds, Others...>(b, call);
  } else if constexpr (kOthers == 0) {
    return call(Family());
  } else {
    return b.tables->model.kind == Family::kKind ? call(Family()) : visitFamily<Kinds, Others...>(b, call);
  }
}

template <BsdfKinds Kinds, class Call>
auto visit(const Bsdf& b, Call call) {
  return visitFamily<Kinds, Diffuse, Plastic, RoughPlastic, Conductor, RoughConductor, Dielectric,
                     ThinDielectric>(b, call);
}

}  // namespace detail

inline constexpr BsdfKinds kAllBsdfKinds = (only(BsdfKind::kThinDielectric) << 1) - 1;

// Kinds: those that b may be of.
template <BsdfKinds Kinds = kAllBsdfKinds>
BsdfValue evaluateBsdf(const Bsdf& b, LaneVec3 wo, LaneVec3 wi) {
  return detail::visit<Kinds>(b, [&](auto family) { return family.evaluate(b, wo, wi); });
}

// A direction for given wo: u_lobe chooses the lobe, u1 and u2 the direction within it, all in [0, 1).
template <BsdfKinds Kinds = kAllBsdfKinds>
BsdfSample sampleBsdf(const Bsdf& b, LaneVec3 wo, Lane u_lobe, Lane u1, Lane u2) {
  return detail::visit<Kinds>(b, [&](auto family) { return family.sample(b, wo, u_lobe, u1, u2); });
}

// Fraction of light from cosine cos_o that is reflected or let through, into all directions together.
template <BsdfKinds Kinds = kAllBsdfKinds>
LaneRgb bsdfAlbedo(const Bsdf& b, Lane cos_o) {
  return detail::visit<Kinds>(b, [&](auto family) { return family.albedo(b, cos_o); });
}

}  // namespace saccade
