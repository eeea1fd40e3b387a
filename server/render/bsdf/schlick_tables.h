// How much light GGX microfacets reflect whose reflectance follows Schlick's formula.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace saccade {

// Schlick's reflectance F = F0 + (F90 - F0) (1 - cos)^5 is linear in F0 and in F90. So is the fraction of
// light that a surface reflects, in all directions together: F0 normal + F90 grazing.
struct SchlickAlbedo {
  float normal = 0, grazing = 0;

  SchlickAlbedo operator*(float s) const { return {normal * s, grazing * s}; }
  SchlickAlbedo operator+(SchlickAlbedo b) const { return {normal + b.normal, grazing + b.grazing}; }
};

// By roughness (the square root of alpha) and cosine, in equal steps of the roughness and of the square root
// of the cosine.
class SchlickTables {
 public:
  SchlickTables();

  SchlickAlbedo at(float alpha, float cosine) const {
    const Place r(std::sqrt(alpha)), c(std::sqrt(std::clamp(cosine, 0.f, 1.f)));
    const auto row = [&](int i) {
      return values_[i][c.low] * (1 - c.weight) + values_[i][c.low + 1] * c.weight;
    };
    return row(r.low) * (1 - r.weight) + row(r.low + 1) * r.weight;
  }
  // 2 int_0^1 at(alpha, c) c dc: of light from all directions alike.
  SchlickAlbedo mean(float alpha) const {
    const Place r(std::sqrt(alpha));
    return means_[r.low] * (1 - r.weight) + means_[r.low + 1] * r.weight;
  }

 private:
  static constexpr int kSize = 32;
  struct Place {
    explicit Place(float x)
        : low(std::min(static_cast<int>(x * (kSize - 1)), kSize - 2)),
          weight(x * (kSize - 1) - static_cast<float>(low)) {}
    int low;
    float weight;
  };
  std::array<std::array<SchlickAlbedo, kSize>, kSize> values_;
  std::array<SchlickAlbedo, kSize> means_;
};

// Computed at the first call.
const SchlickTables& schlickTables();

// The reflectance at grazing angles of an interface that reflects f0 at a right angle. No matter reflects
// less than 0.02 there, so that it fades out below [Lagarde and de Rousiers 2014, 3.2].
inline float grazingReflectance(float f0) {
  return std::min(1.f, 50 * f0);
}

}  // namespace saccade
