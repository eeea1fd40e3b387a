// Blends what the levels of the grid say at a point.
#pragma once

#include <algorithm>
#include <cmath>

#include "cache/grid_levels.h"

namespace saccade {

struct BlendParams {
  float tau;      // standard deviations that a level's detail must exceed its noise by
  float noise;    // variance of an interpolated mean, of that of one sample, at a density of one
  float caution;  // how many times the noise of detail counts, beside its energy
};

inline constexpr int kTop = kGridLevels - 1;  // the slot of the coarsest level

// Of the mean of samples of that weight, by the squared residuals of others.
inline float varianceOf(float residual2, float weight, float samples, const BlendParams& p) {
  return weight > 0 && samples > 0 ? p.noise * residual2 / (weight * samples) : 0;
}

// One kind of light, from coarse to fine: E += alpha_k (E_k - E), with alpha_k the share of the detail of
// level k that is not noise [ours].
struct BlendedLight {
  float value = 0, variance = 0;             // of the estimate so far, with the detail that it leaves out
  std::array<float, kTop> alpha{}, noise{};  // of each level: alpha_k, and the variance of E_k

  // `sum` of samples of the weight `samples`. alpha = energy / (energy + caution * noise): what evidence
  // says of the energy of the detail, against the variance of the level's mean.
  void refine(int k, float sum, float samples, float x, float x2, float residual2, float weight,
              float fraction, const BlendParams& p) {
    if (samples <= 0) return;
    const float energy = weight > 0 ? std::max(0.f, x - p.tau * std::sqrt(x2)) / weight : 0;
    noise[k] = varianceOf(residual2, weight, samples, p);
    float a = energy > 0 ? energy / (energy + p.caution * noise[k]) : 0;
    const float left_out = (1 - a) * (1 - a) * energy;
    // The coarsest level fades in, and the finest fades out, as the point moves away.
    if (k == kTop - 1) a += (1 - fraction) * (1 - a);
    if (k == 0) a *= 1 - fraction;
    alpha[k] = a;
    value += a * (sum / samples - value);
    variance = (1 - a) * (1 - a) * variance + a * a * noise[k] + left_out;
  }

  // Variance of the change over a step of `cells` finest cells, without the detail that is left out: the
  // weights of vertices change by as much.
  float stepVariance(float cells) const {
    float sum = 0, left = 1;
    for (int k = 0; k < kTop; ++k, cells *= 0.5f) {
      const float w = alpha[k] * left;
      sum += w * w * std::min(2.f, 2 * cells * cells) * noise[k];
      left *= 1 - alpha[k];
    }
    return sum;
  }
};

struct LevelBlend {
  LevelBlend(const GridLevels& levels, const Placement& at, const GridPoint& p, const BlendParams& params)
      : LevelBlend([&](int k) { return gather(levels[p.level + k].light, at, p, k); },
                   [&](int k) { return gather(levels[p.level + k].evidence, at, p, k); }, p.fraction,
                   params) {}

  // lightAt(slot) and evidenceAt(slot) gather what a point needs.
  LevelBlend(const auto& lightAt, const auto& evidenceAt, float fraction, const BlendParams& params) {
    visibility.value = 1;
    light[kTop] = lightAt(kTop);
    if (light[kTop][0] > 0) rest.value = light[kTop][1] / light[kTop][0];
    if (light[kTop][3] > 0) visibility.value = light[kTop][2] / light[kTop][3];
    for (int k = kTop - 1; k >= 0; --k) {
      const Quad l = light[k] = lightAt(k);
      const Octet e = evidenceAt(k + kPoolSteps);
      if (k == kTop - 1) {  // of the coarsest level there is no evidence of its own
        rest.variance = varianceOf(e[2], e[3], light[kTop][0], params);
        visibility.variance = varianceOf(e[6], e[7], light[kTop][3], params);
      }
      rest.refine(k, l[1], l[0], e[0], e[1], e[2], e[3], fraction, params);
      visibility.refine(k, l[2], l[3], e[4], e[5], e[6], e[7], fraction, params);
    }
  }

  // i = U V + rest, with U the unoccluded direct light.
  float value(float U) const { return rest.value + U * visibility.value; }
  float variance(float U) const { return rest.variance + U * U * visibility.variance; }
  float stepVariance(float U, float cells) const {
    return rest.stepVariance(cells) + U * U * visibility.stepVariance(cells);
  }
  BlendedLight rest, visibility;
  std::array<Quad, kGridLevels> light;  // gathered, by slot
};

}  // namespace saccade
