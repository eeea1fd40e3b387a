// What a material is made of: the same at all its points, in Mitsuba's terms.
#pragma once

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
};

// One row per kind, in the order of BsdfKind.
struct BsdfTraits {
  BsdfKind kind;
  const char* name;  // the type of its <bsdf> in Mitsuba's XML
};
inline constexpr BsdfTraits kBsdfTraits[] = {
    {BsdfKind::kDiffuse, "diffuse"},
    {BsdfKind::kPlastic, "plastic"},
    {BsdfKind::kRoughPlastic, "roughplastic"},
    {BsdfKind::kConductor, "conductor"},
    {BsdfKind::kRoughConductor, "roughconductor"},
    {BsdfKind::kDielectric, "dielectric"},
    {BsdfKind::kThinDielectric, "thindielectric"},
};

constexpr const BsdfTraits& traitsOf(BsdfKind kind) {
  return kBsdfTraits[static_cast<int>(kind)];
}

// How the slopes of a rough surface are spread.
enum class MicrofacetKind { kBeckmann, kGgx };

struct BsdfModel {
  BsdfKind kind = BsdfKind::kDiffuse;
  MicrofacetKind microfacets = MicrofacetKind::kBeckmann;  // rough kinds
  float alpha = 0.1f;            // rough kinds: roughness, in (0, 1]; below 1e-4 counts as 1e-4
  float ior = 1.5f;              // plastics and dielectrics: index of refraction, inside over outside, > 0
  Rgb eta{0, 0, 0}, k{1, 1, 1};  // conductors: the index eta + ik over the outside's; default: reflects all
  bool nonlinear = false;        // plastics: light that is scattered inside takes on more of the colour
};

}  // namespace saccade
