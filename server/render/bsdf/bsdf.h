// BSDFs are free functions over plain records. They are compiled for sets of kinds, which
// render/surface/shading.h lists. Kinds outside the set cost nothing. In a set of one kind, the kind is not
// even read.
#pragma once

#include <tuple>
#include <utility>

#include "render/bsdf/coated_conductor.h"
#include "render/bsdf/conductor.h"
#include "render/bsdf/dielectric.h"
#include "render/bsdf/diffuse.h"
#include "render/bsdf/glossy.h"
#include "render/bsdf/metallic_roughness.h"
#include "render/bsdf/plastic.h"
#include "render/bsdf/rough_dielectric.h"

namespace saccade {

using BsdfKinds = unsigned;  // a bit for each kind

constexpr BsdfKinds only(BsdfKind kind) {
  return 1u << static_cast<unsigned>(kind);
}
inline constexpr BsdfKinds kAllBsdfKinds = only(BsdfKind::kCount) - 1;

// The kinds that have a trait.
constexpr BsdfKinds kindsWith(bool BsdfTraits::*trait) {
  BsdfKinds kinds = 0;
  for (const BsdfTraits& row : kBsdfTraits) kinds |= row.*trait ? only(row.kind) : 0;
  return kinds;
}

namespace detail {

// In the order of BsdfKind.
using BsdfFamilies =
    std::tuple<Diffuse, Plastic, RoughPlastic, Conductor, RoughConductor, Dielectric, ThinDielectric,
               RoughDielectric, MetallicRoughness, Phong, Ward, CoatedConductor>;

template <std::size_t... I>
constexpr bool inOrder(std::index_sequence<I...>) {
  return (... && (std::tuple_element_t<I, BsdfFamilies>::kKind == static_cast<BsdfKind>(I)));
}
static_assert(std::tuple_size_v<BsdfFamilies> == kBsdfKindCount, "each kind is shaded");
static_assert(inOrder(std::make_index_sequence<kBsdfKindCount>()), "as itself");

// Calls call(Family()) for the family of b's kind. The kind is in Kinds, and not before I.
template <BsdfKinds Kinds, std::size_t I = 0, class Call>
auto visit(const Bsdf& b, Call call) {
  using Family = std::tuple_element_t<I, BsdfFamilies>;
  if constexpr ((Kinds >> I & 1) == 0) {
    return visit<Kinds, I + 1>(b, call);
  } else if constexpr (Kinds >> (I + 1) == 0) {
    return call(Family());
  } else {
    return b.tables->model.kind == Family::kKind ? call(Family()) : visit<Kinds, I + 1>(b, call);
  }
}

}  // namespace detail

// The value for a pair of directions. Kinds are those that b may be of.
template <BsdfKinds Kinds = kAllBsdfKinds>
BsdfValue evaluateBsdf(const Bsdf& b, Vec3 wo, Vec3 wi) {
  return detail::visit<Kinds>(b, [&](auto family) { return family.evaluate(b, wo, wi); });
}

// Samples wi for a given wo. u_lobe chooses the lobe, u1 and u2 the direction within it. All are in [0, 1).
template <BsdfKinds Kinds = kAllBsdfKinds>
BsdfSample sampleBsdf(const Bsdf& b, Vec3 wo, float u_lobe, float u1, float u2) {
  return detail::visit<Kinds>(b, [&](auto family) { return family.sample(b, wo, u_lobe, u1, u2); });
}

// The fraction of light from cosine cos_o that is reflected or transmitted, in all directions together.
template <BsdfKinds Kinds = kAllBsdfKinds>
Rgb bsdfAlbedo(const Bsdf& b, float cos_o) {
  return detail::visit<Kinds>(b, [&](auto family) { return family.albedo(b, cos_o); });
}

// Whether a surface of a kind with a base reflects light by it at all: a metal does not.
template <BsdfKinds Kinds = kAllBsdfKinds>
bool bsdfHasBase(const Bsdf& b) {
  return detail::visit<Kinds>(b, [&](auto family) {
    if constexpr (requires { family.hasBase(b); }) return family.hasBase(b);
    return traitsOf(family.kKind).base;
  });
}

// The part of it that a diffuse base reflects; 0 without one.
template <BsdfKinds Kinds = kAllBsdfKinds>
Rgb bsdfDiffuseAlbedo(const Bsdf& b, float cos_o) {
  return detail::visit<Kinds>(b, [&](auto family) {
    if constexpr (requires { family.diffuseAlbedo(b, cos_o); }) return family.diffuseAlbedo(b, cos_o);
    return Rgb{};
  });
}

}  // namespace saccade
