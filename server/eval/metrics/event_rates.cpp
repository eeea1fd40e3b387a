#include "eval/metrics/event_rates.h"

#include <algorithm>
#include <cmath>

#include "base/hash_rng.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

// Means of count(x, y, d, ref) over the pixels, with method and reference in both roles.
template <class Count>
EventRates meanRates(const ImageF& dL, const ImageF& dL_ref, Count count) {
  checkSameSize(dL, dL_ref);
  EventRates sum;
  forEachPixel(dL, [&](int x, int y) {
    const double d = dL.at(x, y), ref = dL_ref.at(x, y);
    const auto [false_events, false_pixels] = count(x, y, d, ref);
    const auto [missed_events, missed_pixels] = count(x, y, ref, d);
    sum.false_events += false_events, sum.false_pixels += false_pixels;
    sum.missed_events += missed_events, sum.missed_pixels += missed_pixels;
  });
  const double n = static_cast<double>(dL.width()) * dL.height();
  return {sum.false_events / n, sum.missed_events / n, sum.false_pixels / n, sum.missed_pixels / n};
}

struct Count {
  double events, pixels;
};

}  // namespace

// Let d >= 0, d = m C + r with 0 <= r < C; where d < 0, mirror U and both changes. The change d crosses m
// thresholds, and one more if U >= C - r [E (29)]. The reference is silent
//   for ref >= 0 on U in [0, C - ref),
//   for ref < 0  on U in [|ref|, C),
// both of length q = max(0, C - |ref|). Of the last piece [C - r, C) the first has max(0, r - |ref|), the
// second min(r, q). Hence C E = m q + that piece.
double expectedFalseEvents(double d, double ref, double C) {
  const double m = std::floor(std::abs(d) / C), r = std::abs(d) - m * C;
  const double quiet = std::max(C - std::abs(ref), 0.0);
  const bool same_sign = (d < 0) == (ref < 0);
  const double piece = same_sign ? std::max(r - std::abs(ref), 0.0) : std::min(quiet, r);
  return (m * quiet + piece) / C;
}

EventRates integratedRates(const ImageF& dL, const ImageF& dL_ref, double C) {
  return meanRates(dL, dL_ref, [C](int, int, double d, double ref) {
    // The first event of a pixel is all that its share asks for, and a change of C has exactly that one.
    return Count{expectedFalseEvents(d, ref, C), expectedFalseEvents(std::clamp(d, -C, C), ref, C)};
  });
}

EventRates sampledRates(const ImageF& dL, const ImageF& dL_ref, double C, std::uint64_t seed) {
  return meanRates(dL, dL_ref, [&](int x, int y, double d, double ref) {
    const std::uint64_t pixel = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(dL.width()) + x;
    const double U = static_cast<double>(hashKey(seed, pixel) >> 11) * 0x1p-53 * C;
    const double events = std::floor((U + ref) / C) == 0 ? std::abs(std::floor((U + d) / C)) : 0;
    return Count{events, events > 0 ? 1.0 : 0.0};
  });
}

}  // namespace saccade::eval
