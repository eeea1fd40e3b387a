// Means over the microfacets that a direction sees.
#pragma once

#include "render/bsdf/microfacet.h"

namespace saccade {

// The mean of at(wo, m) over the microfacets that are visible from cosine cos_o. As wo lies in the xz plane,
// half of u2 is enough by symmetry. The rule is finer towards both ends, because steep normals are rare but
// lose most of the light.
template <class Function>
auto meanOverNormals(const Microfacets& f, float cos_o, Function at) {
  constexpr int kNormals = 24;  // per dimension
  const auto ease = [](float i) {
    const float t = i / kNormals;
    return t * t * (3 - 2 * t);
  };
  const auto node = [&](int i) { return ease(static_cast<float>(i) + 0.5f); };
  const auto weight = [&](int i) { return ease(static_cast<float>(i + 1)) - ease(static_cast<float>(i)); };
  const Vec3 wo{std::sqrt(1 - cos_o * cos_o), 0, cos_o};
  decltype(at(wo, wo)) sum{};
  for (int i = 0; i < kNormals; ++i)
    for (int j = 0; j < kNormals; ++j)
      sum = sum + at(wo, sampleVisibleNormal(f, wo, node(i), node(j) / 2)) * (weight(i) * weight(j));
  return sum;
}

// The same for a function with an edge. No row of nodes lies along it: they are a Fibonacci lattice.
template <class Function>
auto latticeMeanOverNormals(const Microfacets& f, float cos_o, Function at) {
  constexpr int kNormals = 4181, kStep = 2584;  // neighbours in Fibonacci's sequence
  const auto node = [](int i) { return (static_cast<float>(i) + 0.5f) / kNormals; };
  const auto ease = [](float t) { return t * t * (3 - 2 * t); };
  const auto density = [](float t) { return 6 * t * (1 - t); };
  const Vec3 wo{std::sqrt(1 - cos_o * cos_o), 0, cos_o};
  decltype(at(wo, wo)) sum{};
  for (int i = 0, j = 0; i < kNormals; ++i, j = (j + kStep) % kNormals)
    sum = sum + at(wo, sampleVisibleNormal(f, wo, ease(node(i)), ease(node(j)) / 2)) *
                    (density(node(i)) * density(node(j)));
  return sum * (1.f / kNormals);
}

}  // namespace saccade
