// Blends the estimates of the grid's levels at a point.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/wide.h"
#include "cache/grid/grid_levels.h"

namespace saccade {

struct BlendParams {
  float tau;           // standard deviations that a level's detail must exceed its noise by
  float noise;         // variance of an interpolated mean, of that of one sample, at a density of one
  float noise_weight;  // of the noise of detail, against its energy
};

inline constexpr int kTop = kGridLevels - 1;  // the slot of the coarsest level

// Variance of the mean of samples of that weight, by the squared deviations of others.
template <class F>
F varianceOf(F deviation2, F weight, F samples, const BlendParams& p) {
  return select(weight > 0.f && samples > 0.f, p.noise * deviation2 / (weight * samples), F(0.f));
}

// The mean of one kind of light on a level, and the evidence for the detail that it adds, see evidence.h.
template <class F>
struct LevelEvidence {
  F sum, samples;        // of the level's light: sum / samples is its mean
  F x, x2;               // sums of x and of x^2
  F deviation2, weight;  // sum of squared deviations of samples, and their weight
};

// One kind of light, from coarse to fine: E += alpha_k (E_k - E). Here alpha_k is the share of the detail of
// level k that is not noise [ours]. Of one point, or of a point in each lane (F is Floats then).
template <class F>
struct BlendedLight {
  F value = 0.f, variance = 0.f;         // of the estimate so far, with the detail that it leaves out
  std::array<F, kTop> alpha{}, noise{};  // of each level: alpha_k, and the variance of E_k

  // Sets alpha = energy / (energy + noise_weight * noise): the energy of the detail by its evidence, against
  // the variance of the level's mean. `fraction`: of the way to the next level.
  void refine(int k, const LevelEvidence<F>& e, F fraction, const BlendParams& p) {
    using std::max, std::sqrt;
    const auto& [sum, samples, x, x2, deviation2, weight] = e;
    const auto known = samples > 0.f;
    const F energy = select(weight > 0.f, max(F(0.f), F(x - p.tau * sqrt(x2))) / weight, F(0.f));
    noise[k] = varianceOf<F>(deviation2, weight, samples, p);
    F a = select(energy > 0.f, energy / (energy + p.noise_weight * noise[k]), F(0.f));
    const F left_out = (1.f - a) * (1.f - a) * energy;
    // The coarsest level fades in, and the finest fades out, as the point moves away.
    if (k == kTop - 1) a += (1.f - fraction) * (1.f - a);
    if (k == 0) a *= 1.f - fraction;
    alpha[k] = select(known, a, F(0.f));
    value = select(known, F(value + a * (sum / samples - value)), value);
    variance = select(known, F((1.f - a) * (1.f - a) * variance + a * a * noise[k] + left_out), variance);
  }

  // Variance of the change over a step of `cells` finest cells, without the detail that is left out. The
  // weights of vertices change by as much.
  F stepVariance(F cells) const {
    using std::min;
    F sum = 0.f, left = 1.f;
    for (int k = 0; k < kTop; ++k, cells *= 0.5f) {
      const F w = alpha[k] * left;
      sum += w * w * min(F(2.f), F(2.f * cells * cells)) * noise[k];
      left *= 1.f - alpha[k];
    }
    return sum;
  }
};

template <class F>
struct LevelBlend {
  // lightAt(slot) and evidenceAt(slot) give what GridLevel has at a point: four and eight values.
  LevelBlend(const auto& lightAt, const auto& evidenceAt, F fraction, const BlendParams& params) {
    const auto setLight = [&](int k) {
      const auto l = lightAt(k);
      light[k] = {l[0], l[1], l[2], l[3]};
    };
    setLight(kTop);
    residual.value = select(light[kTop][0] > 0.f, light[kTop][1] / light[kTop][0], F(0.f));
    visibility.value = select(light[kTop][3] > 0.f, light[kTop][2] / light[kTop][3], F(1.f));
    for (int k = kTop - 1; k >= 0; --k) {
      setLight(k);
      const auto& l = light[k];
      const auto e = evidenceAt(k + kPoolSteps);
      if (k == kTop - 1) {  // of the coarsest level there is no evidence of its own
        residual.variance = varianceOf<F>(e[2], e[3], light[kTop][0], params);
        visibility.variance = varianceOf<F>(e[6], e[7], light[kTop][3], params);
      }
      residual.refine(
          k, {.sum = l[1], .samples = l[0], .x = e[0], .x2 = e[1], .deviation2 = e[2], .weight = e[3]},
          fraction, params);
      visibility.refine(
          k, {.sum = l[2], .samples = l[3], .x = e[4], .x2 = e[5], .deviation2 = e[6], .weight = e[7]},
          fraction, params);
    }
  }

  // i = U V + residual, with U the unoccluded direct light.
  F value(F U) const { return residual.value + U * visibility.value; }
  F variance(F U) const { return residual.variance + U * U * visibility.variance; }
  F stepVariance(F U, F cells) const {
    return residual.stepVariance(cells) + U * U * visibility.stepVariance(cells);
  }
  BlendedLight<F> residual, visibility;
  std::array<std::array<F, 4>, kGridLevels> light;  // by slot
};

}  // namespace saccade
