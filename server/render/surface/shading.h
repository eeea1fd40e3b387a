// The sets of features that the renderer is compiled for. A scene uses the first set that covers it.
//
// Measurements chose the sets. The kinds of BSDF cost most: a plastic bunny in a Cornell box took 1 to 15 %
// longer in a kernel with metals and glass. Real scenes with metals have glass too, so both share one kernel.
// Masks, bump maps and lights that are no surface cost a scene without them nothing measurable.
#pragma once

#include "render/bsdf/bsdf.h"
#include "scene/scene.h"

namespace saccade {

struct Shading {
  BsdfKinds kinds = only(BsdfKind::kDiffuse);
  bool textures = false;  // colours that vary over a surface
  bool extras = false;    // masks, bump maps, and lights that are no surface

  bool operator==(const Shading&) const = default;
  constexpr bool diffuseOnly() const { return kinds == only(BsdfKind::kDiffuse); }
  constexpr bool has(bool BsdfTraits::*trait) const { return (kinds & kindsWith(trait)) != 0; }
  constexpr bool covers(const Shading& needed) const {
    return (needed.kinds & ~kinds) == 0 && textures >= needed.textures && extras >= needed.extras;
  }
};

// From the smallest to the largest. A diffuse scene with extras uses kPlastics, and one of glTF kEverything.
inline constexpr Shading kPlainDiffuse{};
inline constexpr Shading kTexturedDiffuse{only(BsdfKind::kDiffuse), true};
inline constexpr Shading kPlastics{
    only(BsdfKind::kDiffuse) | only(BsdfKind::kPlastic) | only(BsdfKind::kRoughPlastic), true, true};
inline constexpr Shading kEverything{kAllBsdfKinds, true, true};

Shading shadingOf(const Scene& scene);  // the features that the scene has

// Calls call.operator()<S>() with the first kernel that covers `needed`.
template <class Call>
auto withKernel(const Shading& needed, Call call) {
  if (kPlainDiffuse.covers(needed)) return call.template operator()<kPlainDiffuse>();
  if (kTexturedDiffuse.covers(needed)) return call.template operator()<kTexturedDiffuse>();
  if (kPlastics.covers(needed)) return call.template operator()<kPlastics>();
  return call.template operator()<kEverything>();
}

}  // namespace saccade
