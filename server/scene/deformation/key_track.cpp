#include "scene/deformation/key_track.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace saccade {
namespace {

enum Part : std::size_t { kIn, kValue, kOut };  // of a cubic key

// Weights of two values along the great circle, the short way [glTF 2.0, C.3].
std::array<double, 2> slerp(const float* a, const float* b, double s) {
  constexpr double kNearlyEqual = 1 - 1e-9;
  const auto inner = [](const float* p, const float* q) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) sum += double{p[i]} * double{q[i]};
    return sum;
  };
  const double cosine = inner(a, b) / std::sqrt(inner(a, a) * inner(b, b)), sign = cosine < 0 ? -1 : 1;
  if (!(std::abs(cosine) < kNearlyEqual)) return {1 - s, sign * s};
  const double angle = std::acos(std::abs(cosine));
  return {std::sin((1 - s) * angle) / std::sin(angle), sign * std::sin(s * angle) / std::sin(angle)};
}

}  // namespace

void KeyTrack::at(double seconds, std::span<double> value) const {
  const bool cubic = interpolation == KeyInterpolation::kCubic;
  const auto part = [&](std::size_t key, Part which) {
    return values.data() + (cubic ? key * 3 + which : key) * size;
  };
  std::ranges::fill(value, 0.0);
  const auto add = [&](const float* of, double weight) {
    for (std::size_t i = 0; i < size; ++i) value[i] += weight * double{of[i]};
  };
  const auto after = std::ranges::upper_bound(times, seconds, {}, [](float t) { return double{t}; });
  const auto next = static_cast<std::size_t>(after - times.begin());
  if (next == 0) return add(part(0, kValue), 1);
  if (next == times.size() || interpolation == KeyInterpolation::kStep) return add(part(next - 1, kValue), 1);
  const double begin = times[next - 1], span = times[next] - begin, s = (seconds - begin) / span;
  const float *a = part(next - 1, kValue), *b = part(next, kValue);
  if (!cubic) {
    const auto [of_a, of_b] = rotates ? slerp(a, b, s) : std::array{1 - s, s};
    return add(a, of_a), add(b, of_b);
  }
  // Hermite's, with tangents per second [glTF 2.0, C.4].
  const double s2 = s * s, s3 = s2 * s;
  add(a, 2 * s3 - 3 * s2 + 1), add(b, -2 * s3 + 3 * s2);
  add(part(next - 1, kOut), (s3 - 2 * s2 + s) * span), add(part(next, kIn), (s3 - s2) * span);
}

}  // namespace saccade
