#include "eval/metrics/event_phases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace saccade::eval {
namespace {

using Bins = std::array<double, kPhaseBins>;

Bins sharesOf(const PhasedEvents& events) {
  Bins shares{};
  for (const PhasedEvent& e : events) shares[static_cast<std::size_t>(e.bin)] += 1;
  for (double& share : shares) share /= static_cast<double>(events.size());
  return shares;
}

PhasedEvents byPixel(PhasedEvents events) {
  std::sort(events.begin(), events.end(),
            [](const PhasedEvent& a, const PhasedEvent& b) { return a.pixel < b.pixel; });
  return events;
}

// Adds `weight` times what the events of one pixel, from `next` on, have beyond their part of `shares`.
void addPixel(std::uint32_t pixel, PhasedEvents::const_iterator& next, PhasedEvents::const_iterator end,
              const Bins& shares, double weight, Bins& sum) {
  for (; next != end && next->pixel == pixel; ++next) {
    for (std::size_t b = 0; b < sum.size(); ++b) sum[b] -= weight * shares[b];
    sum[static_cast<std::size_t>(next->bin)] += weight;
  }
}

// The variances V of p - q.
Bins variances(const PhasedEvents& x, const PhasedEvents& ref, const Bins& p, const Bins& q) {
  const PhasedEvents of_x = byPixel(x), of_ref = byPixel(ref);
  Bins V{};
  auto a = of_x.begin(), b = of_ref.begin();
  while (a != of_x.end() || b != of_ref.end()) {
    const bool from_x = b == of_ref.end() || (a != of_x.end() && a->pixel < b->pixel);
    const std::uint32_t pixel = from_x ? a->pixel : b->pixel;
    Bins adds{};
    addPixel(pixel, a, of_x.end(), p, 1 / static_cast<double>(x.size()), adds);
    addPixel(pixel, b, of_ref.end(), q, -1 / static_cast<double>(ref.size()), adds);
    for (std::size_t i = 0; i < V.size(); ++i) V[i] += adds[i] * adds[i];
  }
  return V;
}

}  // namespace

PhasedEvents phasesOf(const Events& events, const FrameIntervals& intervals) {
  PhasedEvents phased;
  for (const Event& e : events) {
    const auto after = std::upper_bound(intervals.begin(), intervals.end(), e.t_ns,
                                        [](std::int64_t t, const FrameInterval& f) { return t < f.t0_ns; });
    if (after == intervals.begin()) continue;
    const FrameInterval& frame = after[-1];
    if (e.t_ns >= frame.t1_ns) continue;
    const std::int64_t bin = (e.t_ns - frame.t0_ns) * kPhaseBins / (frame.t1_ns - frame.t0_ns);
    phased.push_back({static_cast<std::uint32_t>(e.y) << 16 | e.x, static_cast<int>(bin)});
  }
  return phased;
}

double phaseError(const PhasedEvents& x, const PhasedEvents& ref) {
  if (x.empty() || ref.empty()) return std::numeric_limits<double>::quiet_NaN();
  const Bins p = sharesOf(x), q = sharesOf(ref), V = variances(x, ref, p, q);
  double D = 0, E = 0;
  for (std::size_t b = 0; b < p.size(); ++b) {
    D += std::abs(p[b] - q[b]) / 2;
    E += std::sqrt(2 * V[b] / std::numbers::pi) / 2;
  }
  const double square = D * D - E * E;
  return std::copysign(std::sqrt(std::abs(square)), square);
}

}  // namespace saccade::eval
