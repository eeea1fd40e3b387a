// Data of a material that would be slow to compute at each hit. It is computed once for each material.
#pragma once

#include <algorithm>
#include <array>

#include "base/vec.h"
#include "render/bsdf/schlick_tables.h"
#include "scene/bsdf_model.h"

namespace saccade {

// A function of the cosine between a direction and the normal. The table has equal steps of the square root
// of the cosine, because such functions change most at grazing angles.
template <class T>
class CosineTable {
 public:
  template <class Function>
  void fill(Function at) {
    for (int i = 0; i < kSize; ++i) {
      const float root = std::max(0.01f, static_cast<float>(i) / (kSize - 1));
      values_[i] = at(root * root);
    }
  }
  static constexpr int kSize = 32;
  const std::array<T, kSize>& values() const { return values_; }

  T operator()(float cosine) const {
    const float x = std::sqrt(std::clamp(cosine, 0.f, 1.f)) * (kSize - 1);
    const int i = std::min(static_cast<int>(x), kSize - 2);
    const float w = x - static_cast<float>(i);
    return values_[i] * (1 - w) + values_[i + 1] * w;
  }

 private:
  std::array<T, kSize> values_{};
};

struct BsdfTables {
  explicit BsdfTables(const BsdfModel& model);

  BsdfModel model;  // its roughness is at least kLeastAlpha

  // For rough kinds: the fractions of light from outside that leave into the upper hemisphere, per channel.
  // Of plastic and glass also those into the lower one. Light between two microfacets is lost, as in Mitsuba.
  // Of phong and ward: what a white lobe of gloss reflects.
  CosineTable<Rgb> reflectance;
  CosineTable<float> transmittance;
  // Rough glass: the same of light from inside.
  CosineTable<float> inner_reflectance, inner_transmittance;
  // Coated metals: `reflectance` is of light that has entered the coat. Rough coats: `transmittance`, and
  // this.
  CosineTable<float> coat_reflectance;

  // For plastics: the transmittance of diffuse light from outside, and the reflectance of diffuse light from
  // inside.
  float mean_transmittance = 1, internal_reflectance = 0;

  // For metallic-roughness: the reflectance of what is no metal, at a right angle.
  float dielectric_reflectance = 0;
  const SchlickTables* schlick = nullptr;

 private:
  void fillCoated();
};

}  // namespace saccade
