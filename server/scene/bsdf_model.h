// The model of a material: the same at all its points, in the terms of Mitsuba and of glTF.
#pragma once

#include <cstddef>
#include <iterator>

#include "base/vec.h"

namespace saccade {

enum class BsdfKind {
  kDiffuse,
  kPlastic,  // a diffuse base under a smooth dielectric
  kRoughPlastic,
  kConductor,  // a mirror of metal
  kRoughConductor,
  kDielectric,      // the surface of glass
  kThinDielectric,  // a pane: both its surfaces at once, nothing is bent
  kRoughDielectric,
  kMetallicRoughness,  // the material of glTF 2.0: a diffuse base under a rough interface, or a metal
  kPhong,              // a diffuse base and a lobe of gloss, as in Mitsuba 0.6
  kWard,
  kCoatedConductor,  // a rough metal under a dielectric, as in Mitsuba 0.6
  kCount,            // how many kinds there are; no kind
};
inline constexpr auto kBsdfKindCount = static_cast<std::size_t>(BsdfKind::kCount);

// Properties of a kind of BSDF.
struct BsdfTraits {
  BsdfKind kind;
  const char* name;                 // the type of its <bsdf> in Mitsuba's XML; metallicroughness is our own
  bool base = false;                // has a diffuse base, of the colour Material::reflectance
  bool delta = false;               // has delta lobes only: the view is followed into it
  bool transmits = false;           // lets light through, and is seen from both sides
  bool transmits_rough = false;     // spreads the light it lets through: lights behind it are sampled
  bool transmits_straight = false;  // does not bend the light it lets through: shadow rays go on
};

// One row per kind, in the order of BsdfKind.
inline constexpr BsdfTraits kBsdfTraits[] = {
    {.kind = BsdfKind::kDiffuse, .name = "diffuse", .base = true},
    {.kind = BsdfKind::kPlastic, .name = "plastic", .base = true},
    {.kind = BsdfKind::kRoughPlastic, .name = "roughplastic", .base = true},
    {.kind = BsdfKind::kConductor, .name = "conductor", .delta = true},
    {.kind = BsdfKind::kRoughConductor, .name = "roughconductor"},
    {.kind = BsdfKind::kDielectric, .name = "dielectric", .delta = true, .transmits = true},
    {.kind = BsdfKind::kThinDielectric,
     .name = "thindielectric",
     .delta = true,
     .transmits = true,
     .transmits_straight = true},
    {.kind = BsdfKind::kRoughDielectric,
     .name = "roughdielectric",
     .transmits = true,
     .transmits_rough = true},
    {.kind = BsdfKind::kMetallicRoughness, .name = "metallicroughness", .base = true},
    {.kind = BsdfKind::kPhong, .name = "phong", .base = true},
    {.kind = BsdfKind::kWard, .name = "ward", .base = true},
    {.kind = BsdfKind::kCoatedConductor, .name = "coating"},
};
static_assert(std::size(kBsdfTraits) == kBsdfKindCount, "each kind has a row");
static_assert(
    [] {
      for (std::size_t i = 0; i < kBsdfKindCount; ++i)
        if (kBsdfTraits[i].kind != static_cast<BsdfKind>(i)) return false;
      return true;
    }(),
    "the rows are in the order of BsdfKind");

constexpr const BsdfTraits& traitsOf(BsdfKind kind) {
  return kBsdfTraits[static_cast<std::size_t>(kind)];
}

// How the slopes of a rough surface are spread.
enum class MicrofacetKind { kBeckmann, kGgx };

struct BsdfModel {
  BsdfKind kind = BsdfKind::kDiffuse;
  MicrofacetKind microfacets = MicrofacetKind::kBeckmann;  // rough kinds
  float alpha = 0.1f;            // rough kinds: roughness, in (0, 1]; below 1e-4 counts as 1e-4
  float ior = 1.5f;              // with an interface: index of refraction, inside over outside, > 0
  Rgb eta{0, 0, 0}, k{1, 1, 1};  // conductors: the index eta + ik over the outside's; default: reflects all
  bool nonlinear = false;        // plastics: light that is scattered inside takes on more of the colour
  bool scatters_once = false;    // plastics: light that the interface sends back to the base is lost
  // A dielectric layer on a metal: its index over the outside's, and its roughness. Smooth conductors may
  // have a smooth one, and 0 is none. Coated conductors have one of at least 1, of any roughness; 0 is
  // smooth.
  float coat_ior = 0, coat_alpha = 0;
  MicrofacetKind coat_microfacets = MicrofacetKind::kBeckmann;
};

}  // namespace saccade
