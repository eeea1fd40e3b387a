#include "scene/gltf/key_track.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

using Value = std::array<double, 4>;

Value mix(const Value& a, const Value& b, double wa, double wb) {
  Value v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = a[i] * wa + b[i] * wb;
  return v;
}

double inner(const Value& a, const Value& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Along the great circle, the short way [glTF 2.0, C.3].
Value slerp(const Value& a, const Value& b, double s) {
  constexpr double kNearlyEqual = 1 - 1e-9;
  const double cosine = inner(a, b) / std::sqrt(inner(a, a) * inner(b, b)), sign = cosine < 0 ? -1 : 1;
  if (!(std::abs(cosine) < kNearlyEqual)) return mix(a, b, 1 - s, sign * s);
  const double angle = std::acos(std::abs(cosine));
  return mix(a, b, std::sin((1 - s) * angle) / std::sin(angle), sign * std::sin(s * angle) / std::sin(angle));
}

}  // namespace

std::array<double, 4> KeyTrack::at(double seconds) const {
  const bool cubic = interpolation == KeyInterpolation::kCubic;
  enum Part { kIn, kValue, kOut };
  const auto part = [&](std::size_t key, Part which) {
    Value v{};
    const std::size_t first = (cubic ? key * 3 + which : key) * size;
    for (std::size_t i = 0; i < size; ++i) v[i] = values[first + i];
    return v;
  };
  const auto after = std::ranges::upper_bound(times, seconds, {}, [](float t) { return double{t}; });
  const auto next = static_cast<std::size_t>(after - times.begin());
  if (next == 0) return part(0, kValue);
  if (next == times.size() || interpolation == KeyInterpolation::kStep) return part(next - 1, kValue);
  const double begin = times[next - 1], span = times[next] - begin, s = (seconds - begin) / span;
  const Value a = part(next - 1, kValue), b = part(next, kValue);
  if (!cubic) return size == 4 ? slerp(a, b, s) : mix(a, b, 1 - s, s);
  // Hermite's, with tangents per second [glTF 2.0, C.4].
  const double s2 = s * s, s3 = s2 * s;
  const Value values_part = mix(a, b, 2 * s3 - 3 * s2 + 1, -2 * s3 + 3 * s2);
  const Value tangents = mix(part(next - 1, kOut), part(next, kIn), s3 - 2 * s2 + s, s3 - s2);
  return mix(values_part, tangents, 1, span);
}

}  // namespace saccade
