// The test that decides whether a pixel has an event, of Manabe et al. 2024, "Monte Carlo path tracing and
// statistical event detection for event camera simulation". It is Student's t-test of two means of log
// luminance. Their variances need not be equal (Welch 1947).
#pragma once

#include <cmath>

namespace saccade {

// A mean of samples of log brightness, natural log units.
struct BrightnessMean {
  float mean = 0;
  float variance = 0;  // of the mean
  float samples = 0;

  // From the sum of samples and of their squares. The variance of one sample counts as 0.
  static BrightnessMean of(float sum, float squares, float samples) {
    const float mean = sum / samples;
    const float spread = std::fmax(squares / samples - mean * mean, 0.f);
    return {mean, samples > 1 ? spread / (samples - 1) : 0, samples};
  }
};

// The quantile of 97.5 % of Student's distribution, by Abramowitz and Stegun 26.7.5: to 1 % from 3 degrees of
// freedom on. So a test that needs a larger |t| errs in 5 % of the cases, as published.
inline float tQuantile(float freedom) {
  constexpr float z = 1.959964f, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  const float n = 1 / freedom;
  return z + (z3 + z) / 4 * n + (5 * z5 + 16 * z3 + 3 * z) / 96 * n * n +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / 384 * n * n * n;
}

struct EventTest {
  bool event;    // whether the brightness differs by the threshold
  bool certain;  // whether more samples would hardly change that
};

// Of the brightness now and at the last event.
inline EventTest testEvent(const BrightnessMean& now, const BrightnessMean& last, float threshold) {
  const float beyond = std::abs(now.mean - last.mean) - threshold, variance = now.variance + last.variance;
  // Welch and Satterthwaite.
  const auto part = [](const BrightnessMean& m) { return m.variance * m.variance / (m.samples - 1); };
  const float parts = part(now) + part(last);
  const float freedom = parts > 0 ? std::fmax(variance * variance / parts, 3.f) : 3.f;
  const float t = tQuantile(freedom);
  return {beyond >= 0, beyond * beyond >= t * t * variance};
}

}  // namespace saccade
